#pragma once
// The slip-compensated skid-steer model, eqs 1-5, integrated over exact arcs.

#include <array>
#include <cmath>

#include "core/pose.h"
#include "model/track_parameters.h"
#include "shared/skid_steer.h"

namespace tp100::model {

/// The ground under one interval. The defaults are a level plane of the robot's own surface.
struct Incline {
  double slope_rad = 0.0;    ///< climb angle along the robot; shifts the slip ratios
  double slip_offset = 0.0;  ///< of the surface, added to both slip ratios
  /// Horizontal distance per distance along the slope, cos(slope) on a ramp; any value while the
  /// body rotates about an edge.
  double horizontal_fraction = 1.0;
};

/// A plane at a climb angle.
inline Incline inclined(double slope_rad) {
  return {.slope_rad = slope_rad, .horizontal_fraction = std::cos(slope_rad)};
}

// Slip ratio against slope: the paper's table and interpolations of it.

/// A row of the paper's table: straight climb at 0.10 m/s.
struct SlipRow {
  double slope_deg, left, right;
};
inline constexpr std::array<SlipRow, 7> kSlipRows = {{{0, 0.16, 0.162},
                                                      {8, 0.17, 0.176},
                                                      {12, 0.18, 0.197},
                                                      {16, 0.19, 0.204},
                                                      {20, 0.20, 0.218},
                                                      {24, 0.21, 0.247},
                                                      {28, 0.22, 0.260}}};

/// Slip ratios of both tracks.
struct Slip {
  double left = 0.0;
  double right = 0.0;
};

/// Slip of the board that the paper measured, 0 to 28 deg. `slope_rad`: climb angle; any other
/// value gives the nearest end, NaN the level one. Pure.
Slip slip_at_slope(double slope_rad, SlipCurve curve = SlipCurve::kTable);

/// Bound that keeps 1 - slip away from 0 where slip is divided out of a command.
inline constexpr double kMaxSlip = 0.95;

// The shape of a turn, and its effect on wheelbase, turning centre and slip. Our extension: the
// paper fits one wheelbase and one pair of slip ratios to all turns, but the forces with which the
// tracks work against each other change with the turn.

/// A turn described by the ratio of the two tracks' speeds, on which friction depends, rather than
/// by the speeds.
/// Unevenly creeping tracks lose or gain distance only until friction saturates (`wide`).
/// Friction that acts against sideways sliding cannot drive: a turn to either side costs distance,
/// the more the tighter the path is (`curved`).
/// The wheelbase drifts from wide turns on as more of the track ends slip, until the slower track
/// runs backwards: `medium`, `arc` and `spin` lead from its value in wide turns over those in arcs
/// of medium and tight curvature to that on the spot, the turning centre from tight arcs on. The
/// ratios are those with which four values come nearest to the wheelbases of both emulated bodies,
/// six bundled and 16 sampled robots each.
struct TurnShape {
  double wide = 0.0;    ///< -1..1, left positive: grows with the turn until the slower track makes
                        ///< 0.55 of the faster one's speed, then falls to 0 at 0.35
  double medium = 0.0;  ///< 0..1: 0 up to 0.9 of the faster one's speed, 1 from 0.65 on to spins
  double arc = 0.0;     ///< 0..1: 0 down to 0.65 of the faster one's speed, 1 from 0.35 on to spins
  double spin = 0.0;    ///< 0..1: 0 down to 0.35 of the faster one's speed, 1 from -0.3 on to spins
  double curved = 0.0;  ///< 0..1: difference of the speeds in parts of their sum, as the curvature
                        ///< of the path, 1 from where the slower track stands still on to spins
};

/// Shape for tracks whose ground sides move at these speeds (slip removed). Pure.
TurnShape turn_shape(double left_mps, double right_mps);

/// Lag of the filter below, enough for encoders that give a few edges per interval. [s]
inline constexpr double kTurnLagS = 0.1;

/// Eq 1: the tracks' speeds over the ground. Pure.
inline TrackSpeeds over_ground(const TrackSpeeds& tracks, const Slip& slip) {
  const auto [left, right] =
      shared::over_ground(tracks.left_mps, tracks.right_mps, slip.left, slip.right);
  return {left, right};
}

/// The shape of a turn from track speeds that are low-pass filtered. No allocation; safe in the
/// real-time thread.
class TurnShapeFilter {
 public:
  explicit TurnShapeFilter(double lag_s = kTurnLagS) : lag_s_(lag_s) {}

  /// One interval; returns the shape at its end.
  TurnShape update(double left_mps, double right_mps, double dt_s);
  void restart() { started_ = false; }

 private:
  double lag_s_;
  double left_mps_ = 0.0, right_mps_ = 0.0;
  bool started_ = false;
};

/// `kPaper`: exactly eqs 1-5 on a plane. `kExtended` adds -x_icr * yaw rate to Vy, lets
/// wheelbase, x_icr and slip change with the turn, multiplies the horizontal part by cos(slope),
/// climbs with sin(slope) and shifts the slip ratios with surface and slope.
enum class Mode { kPaper, kExtended };

/// L of eq 5, the turning centre, the slip that the turn adds and the slip angle, in a turn of this
/// shape. In `kPaper` always one L and one angle and nothing else.
struct Turn {
  double wheelbase_m = 0.0;
  double x_icr_m = 0.0;
  double slip = 0.0;
  double slip_angle_rad = 0.0;
};
Turn turn_of(const TrackParameters& parameters, Mode mode, const TurnShape& shape);

/// Slip angle (beta of eq 2) at this yaw rate: the turn's above the threshold, else the straight
/// one. Pure.
double slip_angle_rad(const TrackParameters& parameters, const Turn& turn, double yaw_rate_radps);

/// What a slope adds to the slip ratios of level ground. With added_slips: linear between them and
/// the level, held beyond the steepest, and downhill the negative of uphill if all of them are
/// uphill, or the other way round. Without: the paper's table relative to its level value. NaN: 0.
/// Pure.
AddedSlip added_slip(const TrackParameters& parameters, double slope_rad);

/// Slip ratios on an incline: those of the parameters in `kPaper`; else shifted by surface and
/// slope, so that the parameters stay those of the flat floor.
Slip slip_on(const TrackParameters& parameters, Mode mode, const Incline& incline);

/// Eqs 1, 2 and 5: body twist of tracks at `left_mps`, `right_mps`. Negative speeds take the
/// literal equations. Pure.
Twist body_twist(const TrackParameters& parameters, Mode mode, double left_mps, double right_mps,
                 const Incline& incline = {});
/// The same in a turn whose shape is known more accurately than from these speeds.
Twist body_twist(const TrackParameters& parameters, Mode mode, double left_mps, double right_mps,
                 const Incline& incline, const TurnShape& shape);

/// Eqs 3 and 4 over `dt_s` of constant twist: the exact arc; exact for any step size. z and pitch
/// follow the slope. Yaw stays unwrapped. Pure.
void advance(Pose& pose, const Twist& twist, double dt_s, const Incline& incline = {});

/// Pose by encoders alone. No allocation; safe in the real-time thread.
class TrackModel {
 public:
  TrackModel(const TrackParameters& parameters, Mode mode, double turn_lag_s = kTurnLagS)
      : parameters_(parameters), mode_(mode), turn_shape_filter_(turn_lag_s) {}

  /// Continues from `pose`.
  void begin(const Pose& pose) {
    pose_ = pose;
    turn_shape_filter_.restart();
  }
  /// Tracks at constant speeds for `dt_s`. Returns the twist that was integrated.
  const Twist& advance(double left_mps, double right_mps, double dt_s, const Incline& incline = {});

  const Pose& pose() const { return pose_; }
  const Twist& twist() const { return twist_; }
  const Slip& slip() const { return slip_; }

 private:
  TrackParameters parameters_;
  Mode mode_;
  Pose pose_{};
  Twist twist_{};
  Slip slip_{};
  TurnShapeFilter turn_shape_filter_;
};

}  // namespace tp100::model
