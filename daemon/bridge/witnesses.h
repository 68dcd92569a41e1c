#pragma once
// The poses that tell where the robot is, for the envelope of a run or drive.

#include <optional>

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
/// Odometry counts from the start of the last run, or from where the robot was last placed; driving
/// by hand goes on from there. No world moves it, and a camera does only where odometry has become
/// less certain than kCertainM and both agree, so that the envelope of a long drive is as narrow as
/// that of a short one.
class WitnessPoses {
 public:
  static constexpr double kCertainM = 0.05;

  /// `parameters`, `perception` and `external` must outlive this. `identifies`: on a course that
  /// identifies the robot its slip is unknown, so that odometry may be wrong by half of the way.
  WitnessPoses(const Parameters& parameters, const Perception& perception,
               const ExternalWorld& external, bool identifies)
      : parameters_(parameters),
        perception_(perception),
        external_(external),
        identifies_(identifies) {}

  /// The robot is at the start of a run, or where it was placed.
  void begin();
  /// A drive by hand begins, or a run goes on.
  void continue_run();
  /// Another `dt_s` has passed.
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
  bool identifies_;
  Transform2d begun_at_{};   ///< from the robot's floor into the course's world, as the run began
  Transform2d corrected_{};  ///< from odometry to where a camera last confirmed it
  /// Odometry then: its error of that time does not count. Nothing since the start of a run.
  std::optional<Estimate> counts_from_{};
  double slip_m_ = 0.0;  ///< that odometry may have missed on real ramps and blocks, or if unknown
  /// What the robot of the external world may be behind or ahead; a part is due to its obstacles.
  double lag_m_ = 0.0, lag_rad_ = 0.0, obstacle_lag_m_ = 0.0;
};

}  // namespace tp100::bridge
