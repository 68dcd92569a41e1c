#pragma once
// The poses that tell where the robot is, for the envelope of a run or drive.

#include "bridge/external_world.h"
#include "bridge/parameters.h"
#include "bridge/perception.h"
#include "control/envelope.h"
#include "control/tracker.h"
#include "core/pose.h"

namespace tp100::bridge {

/// Beside the steering pose: the robot on its own floor where an external world is another one; and
/// of odometry and the fused pose the one that does not steer, if a camera tells them apart. On a
/// stand, where the robot stands still, there is the steering pose alone. No allocation; safe in
/// the real-time thread.
///
/// Odometry counts from the start of the run, or from where the robot was last placed: no world
/// moves it, and a camera does only where odometry has become less certain than kCertainM and both
/// agree. So the envelope of a long drive is as narrow as that of a short one.
class WitnessPoses {
 public:
  static constexpr double kCertainM = 0.03;

  /// `parameters`, `perception` and `external` must outlive this.
  WitnessPoses(const Parameters& parameters, const Perception& perception,
               const ExternalWorld& external)
      : parameters_(parameters), perception_(perception), external_(external) {}

  /// A run or drive begins.
  void begin();
  /// Another `dt_s` of the run or drive has passed.
  void advance(double dt_s);
  /// `tracker`: of a run on a course; null: by hand.
  control::Witnesses now(const control::Tracker* tracker) const;

 private:
  control::Witness witness(const Pose& pose, const Pose& other) const;
  Pose odometry() const;
  void follow_camera();

  const Parameters& parameters_;
  const Perception& perception_;
  const ExternalWorld& external_;
  Transform2d begun_at_{};   ///< from the robot's floor into the course's world, as the run began
  Transform2d corrected_{};  ///< from odometry to where a camera last confirmed it
  PlanarCovariance at_correction_{};  ///< of odometry
  double slip_m_ = 0.0;               ///< that odometry may have missed on real ramps and blocks
  /// What the robot of the external world may be behind or ahead; a part is due to its obstacles.
  double lag_m_ = 0.0, lag_rad_ = 0.0, obstacle_lag_m_ = 0.0;
};

}  // namespace tp100::bridge
