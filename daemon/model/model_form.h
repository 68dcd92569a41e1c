#pragma once
// The forms of the model of a robot, and dead reckoning by each: the extended model that the daemon
// drives with, and simpler ones that are judged beside it. A new form is a row of the table.

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <string_view>

#include "model/track_model.h"
#include "model/track_parameters.h"

namespace tp100::model {

/// One form: the parameters that it has. All others are switched off.
struct ModelForm {
  std::string_view key;                                ///< in robot files, JSON and tables
  std::string_view meaning;                            ///< one sentence without its full stop
  std::array<bool, kTrackParameters.size()> fitted{};  ///< by row of the table of parameters
  bool one_slip = false;                               ///< slip_left is both tracks' slip
  bool yaw_from_gyro = false;  ///< the gyro gives the yaw rate, bias removed; else eq 5
  /// The parameters of a form of which nothing is fitted.
  TrackParameters (*fixed)(double gauge_m) = nullptr;

  constexpr bool has(TrackParameter parameter) const { return fitted[row_of(parameter)]; }
  /// Number of fitted constants.
  constexpr std::ptrdiff_t constants() const {
    return std::count(fitted.begin(), fitted.end(), true);
  }
  /// `parameters` without those that the form does not have. The gyro's scale is always kept.
  TrackParameters only(TrackParameters parameters) const;
};

/// For the table below.
constexpr std::array<bool, kTrackParameters.size()> rows_of(
    std::initializer_list<TrackParameter> parameters) {
  std::array<bool, kTrackParameters.size()> rows{};
  for (const TrackParameter parameter : parameters) rows[row_of(parameter)] = true;
  return rows;
}
constexpr std::array<bool, kTrackParameters.size()> rows_of_motion() {
  std::array<bool, kTrackParameters.size()> rows{};
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = kTrackParameters[i].of != ParameterOf::kGyro;
  return rows;
}
TrackParameters without_slip(double gauge_m);
TrackParameters as_printed(double gauge_m);

/// The model that the daemon drives with.
inline constexpr ModelForm kExtendedForm{
    "extended", "Eqs 1-5 with turning centre, tight turns, uneven creep and loss of turns",
    rows_of_motion()};

/// Simpler forms, the simplest first.
inline constexpr std::array kBaselines = {
    ModelForm{.key = "differential",
              .meaning = "Differential drive: no slip, the wheelbase is the gauge",
              .fixed = without_slip},
    ModelForm{.key = "differential_fitted",
              .meaning = "Differential drive, fitted: the wheelbase, and slip_left for both "
                         "tracks, which is equivalent to another wheel radius",
              .fitted = rows_of({&TrackParameters::slip_left, &TrackParameters::wheelbase_m}),
              .one_slip = true},
    ModelForm{.key = "eqs_1_5_printed",
              .meaning = "Eqs 1-5 with the constants that the paper prints for its robot",
              .fixed = as_printed},
    ModelForm{.key = "eqs_1_5",
              .meaning = "Eqs 1-5, fitted",
              .fitted = rows_of({&TrackParameters::slip_left, &TrackParameters::slip_right,
                                 &TrackParameters::slip_angle_straight_rad,
                                 &TrackParameters::slip_angle_turning_rad,
                                 &TrackParameters::wheelbase_m})},
    ModelForm{.key = "icr",
              .meaning = "Constant turning centre, fitted: both slips, the wheelbase and the "
                         "centre's distance ahead",
              .fitted = rows_of({&TrackParameters::slip_left, &TrackParameters::slip_right,
                                 &TrackParameters::wheelbase_m, &TrackParameters::x_icr_m})},
    ModelForm{.key = "gyro",
              .meaning = "Yaw from the gyro, whose bias is measured at standstill; fitted: the "
                         "gyro's scale, and slip_left for both tracks",
              .fitted = rows_of({&TrackParameters::slip_left, &TrackParameters::gyro_scale}),
              .one_slip = true,
              .yaw_from_gyro = true},
};

/// One value for each baseline.
template <class T>
using PerBaseline = std::array<T, kBaselines.size()>;

/// Place of a baseline in the table; its size if the table does not have it.
constexpr std::size_t baseline(std::string_view key) {
  std::size_t i = 0;
  while (i < kBaselines.size() && kBaselines[i].key != key) ++i;
  return i;
}
inline constexpr std::size_t kEqsPrinted = baseline("eqs_1_5_printed");
inline constexpr std::size_t kEqsFitted = baseline("eqs_1_5");
static_assert(std::max(kEqsPrinted, kEqsFitted) < kBaselines.size());

/// Pose by encoders, and by the gyro if the form takes it, on flat ground. No allocation.
class DeadReckoning {
 public:
  /// `turn_lag_s`: lag of TurnShapeFilter.
  DeadReckoning(const ModelForm& form, const TrackParameters& parameters, const Pose& start = {},
                double turn_lag_s = kTurnLagS);

  /// Tracks at constant speeds for `dt_s`; `gyro_radps` in nominal scale, its bias removed.
  void advance(double left_mps, double right_mps, double gyro_radps, double dt_s);
  const Pose& pose() const { return pose_; }

 private:
  TrackParameters parameters_;
  bool yaw_from_gyro_;
  TrackModel tracks_;
  Pose pose_;
};

}  // namespace tp100::model
