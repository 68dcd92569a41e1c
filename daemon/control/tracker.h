#pragma once
// Trajectory tracking along the pieces of a path: progress, speed, stops, turns on the spot and the
// way back after a disturbance are here; how lines and arcs are steered is a law's (law.h).

#include <memory>
#include <vector>

#include "control/belt_limits.h"
#include "control/corner.h"
#include "control/law.h"
#include "control/parameters.h"
#include "control/pivot.h"
#include "control/progress.h"
#include "control/recovery.h"
#include "core/pose.h"
#include "course/path.h"
#include "model/track_model.h"

namespace tp100::control {

/// What the tracker asks for, and where the robot is against the path.
struct Target {
  double desired_yaw_rad = 0.0;  ///< unwrapped, same branch as the path's yaw
  double yaw_rate_radps = 0.0;   ///< feed-forward
  double speed_mps = 0.0;        ///< what the belts can do beside the turn, turns have priority
  double cross_track_m = 0.0;    ///< left positive, across the path's tangent at progress_m
  double off_path_m = 0.0;  ///< distance from the path at progress_m, along it too; not negative
  double heading_error_rad = 0.0;  ///< desired - actual
  double progress_m = 0.0;  ///< along the path; goes back only when a disturbance was noticed
  bool recovering = false;  ///< a disturbance was noticed and the robot is not back yet
  bool done = false;        ///< path completed and at rest
};

/// One robot on one path. SI units.
struct Drive {
  double speed_mps = 0.1;           ///< of the course
  double slip_angle_rad = 0.0;      ///< crab angle to steer against on straights
  model::TrackParameters tracks{};  ///< says where the turning centre lies
  BeltLimits limits{};
};

/// Follows one path once. No allocation after construction; safe in the real-time thread.
class Tracker {
 public:
  /// `path` must outlive the tracker.
  Tracker(const Parameters& parameters, const course::Path& path, const Drive& drive);

  /// Other gains from now on; the path and what is done of it stay.
  void retune(const Parameters& parameters) {
    parameters_ = parameters;
    law_->retune(parameters);
  }
  /// Back to the start of the path.
  void restart();
  /// One step of `dt_s` with the steering pose and twist. Whole turns of the pose's yaw change
  /// nothing, except that the desired yaw of a robot that stops is on the pose's branch.
  /// `disturbed`: someone pushes the robot, see Disturbance.
  const Target& update(const Pose& pose, const Twist& twist, double dt_s, bool disturbed = false);

  /// Duration of the path at the speeds that are meant, pivots included. [s]
  double nominal_duration_s() const { return nominal_duration_s_; }

 private:
  void next_piece();
  void begin_piece();
  const Corner& corner() const { return corners_[progress_.next_turn()]; }
  void follow(const Pose& pose, const Twist& twist, double dt_s);
  void steer(const Pose& pose, const Twist& twist, const course::PathPoint& here, double left_m,
             double dt_s);
  void turn(const Pose& pose, const Twist& twist, double dt_s);
  double crab_rad(double curvature_1pm) const;
  /// The course's speed, or less in a narrow curve.
  double curve_mps(double curvature_1pm) const;
  double speed_cap(double left_m) const;
  void stand(double yaw_rad);
  bool settled(const Twist& twist, bool in_tolerance, double dt_s);

  Parameters parameters_;
  const course::Path& path_;
  Drive drive_;
  std::vector<Corner> corners_;  ///< one a piece, of its turn on the spot, and one for none
  std::unique_ptr<Law> law_;
  double nominal_duration_s_ = 0.0;
  Progress progress_;
  Pivot pivot_;
  Recovery recovery_;
  double commanded_mps_ = 0.0;
  double settled_s_ = 0.0;
  double waited_s_ = 0.0;
  bool stopping_ = false;
  Target target_{};
};

}  // namespace tp100::control
