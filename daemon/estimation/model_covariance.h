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

/// Propagates the error of dead reckoning with encoders alone: x, y, yaw in the world frame, the
/// common slip beside what is expected, which returns to 0, and the error of the wheelbase, which
/// stays. Slip that varies along the floor turns the robot at random: the gyro shows how much it
/// varies, see TrackTrust, and contributes nothing else. Neither disturbances nor a lasting slip
/// difference are allowed for. Right for the extended model with the parameters of an identified
/// robot: with other ones the error is larger. No allocation; safe in the real-time thread.
class ModelCovariance {
 public:
  ModelCovariance(const model::TrackParameters& tracks, const FilterParameters& noise);

  /// The robot is placed on the start of a run.
  void begin();
  /// The samples were interrupted: the time between is unknown.
  void interrupt();
  CarriedModelCovariance carried() const;
  /// What carried() returns after begin(); the estimate itself stays.
  CarriedModelCovariance carried_from_start() const;
  /// As after construction, with this state.
  void resume(const CarriedModelCovariance& carried);

  /// The model moved from `before` to `after` in the interval that odometry took as `motion`, on a
  /// floor with this variance of the slip difference.
  void advance(const Pose& before, const Pose& after, const Motion& motion, double slip_variance);

  PlanarCovariance pose() const;

 private:
  static constexpr Eigen::Index kErrors = 5;
  using Matrix = Eigen::Matrix<double, kErrors, kErrors>;

  Matrix prior() const;
  static CarriedModelCovariance carry(const Matrix& covariance);

  MotionModel model_;
  Matrix covariance_;
};

}  // namespace tp100::estimation
