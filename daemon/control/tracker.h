#pragma once
// Trajectory tracking: cross-track and heading error to desired yaw, turn rate and speed, along the
// pieces of a path. Desired yaw is the Stanley form: the tangent a little ahead, less
// atan(k_e e / (v + v_s)), less the slip angle.

#include <cstddef>

#include "control/parameters.h"
#include "core/pose.h"
#include "course/path.h"

namespace tp100::control {

/// What the tracker asks for, and where the robot is against the path.
struct Target {
  double desired_yaw_rad = 0.0;  ///< unwrapped, same branch as the path's yaw
  double yaw_rate_radps = 0.0;   ///< feed-forward
  double speed_mps = 0.0;
  double cross_track_m = 0.0;      ///< left positive
  double heading_error_rad = 0.0;  ///< desired - actual
  double progress_m = 0.0;         ///< along the path
  bool done = false;               ///< path completed and at rest
};

/// Follows one path once. Progress only grows. No allocation; safe in the real-time thread.
class Tracker {
 public:
  /// `path` must outlive the tracker. `slip_angle_rad`: crab angle to steer against on straights.
  Tracker(const Parameters& parameters, const course::Path& path, double speed_mps,
          double slip_angle_rad);

  /// Back to the start of the path.
  void restart();
  /// One step of `dt_s` with the steering pose and twist. The pose's yaw must be on the path's
  /// branch.
  const Target& update(const Pose& pose, const Twist& twist, double dt_s);

  /// Duration of the path at nominal speed, pivots included. [s]
  double nominal_duration_s() const { return nominal_duration_s_; }

 private:
  const course::Piece& piece() const;
  void next_piece();
  void follow(const Pose& pose, const Twist& twist, double dt_s);
  void turn(const Pose& pose, const Twist& twist, double dt_s);
  double left_to_stop(double offset_m) const;
  void stand(double yaw_rad);
  bool settled(const Twist& twist, bool in_tolerance, double dt_s);

  Parameters parameters_;
  const course::Path& path_;
  double speed_mps_;
  double slip_angle_rad_;
  double nominal_duration_s_ = 0.0;
  std::size_t index_ = 0;
  double offset_m_ = 0.0;
  double commanded_mps_ = 0.0;
  double pivot_yaw_rad_ = 0.0;
  double pivot_rate_radps_ = 0.0;
  double settled_s_ = 0.0;
  double waited_s_ = 0.0;
  bool stopping_ = false;
  Target target_{};
};

}  // namespace tp100::control
