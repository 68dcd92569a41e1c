#pragma once
// Covariance of the model's pose. No sensor corrects the model: its error only grows.

#include <Eigen/Core>
#include <algorithm>

#include "core/estimates.h"
#include "core/pose.h"
#include "core/step_record.h"
#include "estimation/motion.h"
#include "estimation/parameters.h"
#include "model/track_parameters.h"

namespace tp100::estimation {

/// How much the slip difference varies along a floor, by tracks against gyro over short pieces; old
/// ones are forgotten over some metres. No allocation.
class FloorSlip {
 public:
  explicit FloorSlip(const FilterParameters& noise) : noise_(noise) {}
  FloorSlip(const FilterParameters& noise, double slip_density_m, double seen_m)
      : noise_(noise), slip_density_m_(slip_density_m), seen_m_(seen_m) {}
  /// Variance of half the slip difference, summed over a distance, per distance.
  double slip_density_m() const { return std::max(slip_density_m_, 0.0); }
  double seen_m() const { return seen_m_; }

  /// In one interval of `dt_s` the tracks turned the robot by `turn_rad` over `distance_m` (>= 0),
  /// while the gyro saw `gyro_turn_rad`. `wheelbase_m`: in this turn.
  void add(double dt_s, double distance_m, double turn_rad, double gyro_turn_rad,
           double wheelbase_m);
  /// Tracks and gyro cannot be compared in this interval.
  void skip() { piece_ = {}; }

 private:
  struct Piece {
    double duration_s = 0.0, distance_m = 0.0, turn_rad = 0.0, gyro_turn_rad = 0.0;
  };

  FilterParameters noise_;
  /// Before anything was seen: between an even floor and a rough one, and soon forgotten.
  double slip_density_m_ = 2e-5;
  double seen_m_ = 0.02;
  Piece piece_{};  ///< so far
};

/// Propagates the error of dead reckoning with encoders alone: x, y, yaw in the world frame, the
/// common slip beside what is expected, which returns to 0, and the error of the wheelbase, which
/// stays. Slip that varies along the floor turns the robot at random: the gyro shows how much it
/// varies, and contributes nothing else. Neither disturbances nor a lasting slip difference are
/// allowed for. Right for the extended model with the parameters of an identified robot: with other
/// ones the error is larger. No allocation; safe in the real-time thread.
class ModelCovariance {
 public:
  ModelCovariance(const model::TrackParameters& tracks, const FilterParameters& noise);

  /// The robot is placed on the start of a run. What is known of the floor is kept.
  void begin();
  /// The samples were interrupted: the time between is unknown.
  void interrupt();
  CarriedModelCovariance carried() const;
  /// What carried() returns after begin(); the estimate itself stays.
  CarriedModelCovariance carried_from_start() const;
  /// As after construction, with this state.
  void resume(const CarriedModelCovariance& carried);

  /// The model moved from `before` to `after` in the interval that odometry took as `motion` and
  /// after which it knew the gyro's bias.
  void advance(const Pose& before, const Pose& after, const Motion& motion, double gyro_bias_radps);

  PlanarCovariance pose() const;

 private:
  static constexpr Eigen::Index kErrors = 5;
  using Matrix = Eigen::Matrix<double, kErrors, kErrors>;

  Matrix prior() const;
  CarriedModelCovariance carry(const Matrix& covariance) const;
  void compare_with_gyro(double distance_m, double turn_rad, double wheelbase_m,
                         const Motion& motion, double gyro_bias_radps);

  MotionModel model_;
  Matrix covariance_;
  FloorSlip floor_slip_;
};

}  // namespace tp100::estimation
