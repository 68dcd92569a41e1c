#pragma once
// Trajectory tracking along the segments of a path: progress, speed, stops, turns on the spot and
// the return after a disturbance. Lines and arcs are steered by a law (law.h).

#include <cstdint>
#include <memory>
#include <vector>

#include "control/corner.h"
#include "control/law.h"
#include "control/parameters.h"
#include "control/progress.h"
#include "control/track_limits.h"
#include "core/pose.h"
#include "course/path.h"
#include "model/track_model.h"

namespace tp100::control {

// Recovery: from the detection of a disturbance until the robot is back on the path.

/// Signs of a disturbance in one step.
struct DisturbanceSigns {
  double gyro_radps = 0.0;  ///< yaw rates, bias removed; equal ones mean no disturbance
  double tracks_radps = 0.0;
  std::uint32_t contradictions = 0;  ///< how often the camera was accepted against the estimate
};

/// Detects that the robot is pushed or turned: the gyro measures a turn that the tracks do not
/// make, or the camera finds the robot elsewhere. No allocation; safe in the real-time thread.
class DisturbanceDetector {
 public:
  explicit DisturbanceDetector(const Parameters& parameters) : parameters_(parameters) {}

  /// A run begins: earlier signs do not count.
  void restart(std::uint32_t contradictions);
  /// True in every step in which a disturbance is detected.
  bool update(const DisturbanceSigns& signs, double dt_s);

 private:
  Parameters parameters_;
  std::uint32_t contradictions_ = 0;
  double lasted_s_ = 0.0;
};

/// Ends once the robot has been within kRecoveredM and kRecoveredRad of the path for
/// kRecoveredForS. No allocation; safe in the real-time thread.
class Recovery {
 public:
  /// A disturbance was detected.
  void begin();
  void restart() { active_ = false; }
  /// One step on a line or arc; the heading error is the robot's yaw against the tangent.
  void update(double cross_track_m, double heading_rad, double dt_s);
  bool active() const { return active_; }

 private:
  bool active_ = false;
  double inside_s_ = 0.0;
};

/// Output of the tracker: its command, and the robot's errors against the path.
struct Target {
  double desired_yaw_rad = 0.0;  ///< unwrapped, same branch as the path's yaw
  double yaw_rate_radps = 0.0;   ///< feed-forward
  double speed_mps = 0.0;  ///< reduced to what the turn, which has priority, leaves to the tracks
  double cross_track_m = 0.0;  ///< left positive, across the path's tangent at progress_m
  double off_path_m = 0.0;     ///< distance from the path at progress_m, along it too; not negative
  double heading_error_rad = 0.0;  ///< desired - actual
  double progress_m = 0.0;         ///< along the path; decreases only after a disturbance
  bool recovering = false;         ///< a disturbance was detected and the robot is not back yet
  bool done = false;               ///< path completed and at standstill
};

/// One robot on one path. SI units.
struct DriveModel {
  double speed_mps = 0.1;           ///< of the course
  double slip_angle_rad = 0.0;      ///< crab angle to steer against on straights
  model::TrackParameters tracks{};  ///< gives the turning centre
  TrackLimits limits{};
};

/// Follows one path once. No allocation after construction; safe in the real-time thread.
class Tracker {
 public:
  /// `path` must outlive the tracker.
  Tracker(const Parameters& parameters, const course::Path& path, const DriveModel& drive);

  /// Applies other gains; the path and the progress on it stay.
  void retune(const Parameters& parameters) {
    parameters_ = parameters;
    law_->retune(parameters);
  }
  /// Back to the start of the path.
  void restart();
  /// To where an earlier run ended: its Target::progress_m, and the robot's yaw now.
  void resume(double progress_m, double yaw_rad);
  /// While paused, the robot slows down on the path to a standstill and stays there.
  void pause(bool paused) { paused_ = paused; }
  /// One step of `dt_s` with the steering pose and twist. Whole turns of the pose's yaw change
  /// nothing, except that the desired yaw of a stopping robot is on the pose's branch. `disturbed`:
  /// the robot is being pushed, see DisturbanceDetector.
  const Target& update(const Pose& pose, const Twist& twist, double dt_s, bool disturbed = false);

  /// Distance of a place from the path where progress says the robot is, or at most `slack_m`
  /// before or after that: Target::off_path_m is that of the pose, without slack.
  double off_path_m(double x_m, double y_m, double slack_m = 0.0) const;

  /// Duration of the path at the intended speeds, pivots included. [s]
  double nominal_duration_s() const { return nominal_duration_s_; }

 private:
  void next_segment();
  void begin_segment();
  const Corner& corner() const { return corners_[progress_.next_turn()]; }
  void follow(const Pose& pose, const Twist& twist, double dt_s);
  void steer(const Pose& pose, const Twist& twist, const course::PathPoint& here, double left_m,
             double dt_s);
  void turn(const Pose& pose, const Twist& twist, double dt_s);
  double crab_rad(double curvature_1pm) const;
  /// The course's speed, or less in a narrow curve.
  double curve_mps(double curvature_1pm) const;
  double speed_cap(double left_m) const;
  void come_to_rest(double yaw_rad);
  bool settled(const Twist& twist, bool in_tolerance, double dt_s);

  Parameters parameters_;
  const course::Path& path_;
  DriveModel drive_;
  std::vector<Corner> corners_;  ///< by index of segment; the last one stands for no turn
  std::unique_ptr<Law> law_;
  double nominal_duration_s_ = 0.0;
  Progress progress_;
  PivotProfile pivot_;
  Recovery recovery_;
  double commanded_mps_ = 0.0;
  double settled_s_ = 0.0;
  double waited_s_ = 0.0;
  bool stopping_ = false;
  bool paused_ = false;
  Target target_{};
};

}  // namespace tp100::control
