#pragma once
// What the robot does by all that is measured: belts, gyro, attitude, three poses, ground and grip.

#include <cstdint>

#include "bridge/grip.h"
#include "bridge/grounds.h"
#include "bridge/parameters.h"
#include "bridge/tracks.h"
#include "core/camera_sample.h"
#include "core/snapshot.h"
#include "course/course.h"
#include "estimation/attitude_filter.h"
#include "estimation/obstacle_state.h"
#include "estimation/odometry.h"
#include "estimation/pose_filter.h"
#include "estimation/slope_state.h"
#include "estimation/standstill.h"
#include "model/track_model.h"

namespace tp100::bridge {

/// Speeds for control. Those over one sample interval are a few edges of an encoder: these follow
/// them with a lag of 40 ms.
struct Speeds {
  Twist steering{};  ///< of the steering pose
  estimation::BeltSpeeds belts{};
  double encoder_yaw_rate_radps = 0.0;  ///< of eqs 1-5, by this robot's values
  double gyro_yaw_rate_radps = 0.0;     ///< about the world's vertical, bias taken off
};

/// Takes samples and camera poses, and says where the robot is by the model alone, by odometry and
/// by the filter. Knows nothing of paths, operators and commands. No allocation after construction;
/// safe in the real-time thread.
class Perception {
 public:
  /// `parameters` must outlive this, and may change in what live parameters change. `course` may be
  /// null: a plane without end.
  Perception(const Parameters& parameters, const course::Course* course);

  /// A new session or boot: what comes next does not continue what was.
  void restart();
  /// There is no session: the newest sample says nothing any more.
  void lose_sample() { has_sample_ = false; }
  /// A run begins, at host time `now`, where the robot is known to stand.
  void begin(const Pose& start, HostNs now);
  /// The steering pose in `parameters` has changed.
  void steering_changed() { grounds_.steer_by(parameters_.steering); }
  /// What an external world says; before the samples.
  void tell(const GroundTold& told) { grounds_.tell(told); }
  /// Samples in their order. At rest outside a run the robot stands on a level start; grip is
  /// watched in runs only.
  void take(const Sample& next, bool running);
  /// On a bench, where the robot that the camera sees stays where it is, this is left out.
  void take(const CameraSample& seen);

  /// The newest sample of all, and whether it is of this session.
  const Sample& sample() const { return sample_; }
  bool has_sample() const { return has_sample_; }

  Pose steering_pose() const;
  /// The steering pose in the course's world, which differs where ramps and blocks are virtual.
  Pose world_pose() const { return grounds_.world(steering_pose()); }
  const Speeds& speeds() const { return speeds_; }
  /// False on a bench, where the body does not turn.
  bool gyro_steers() const { return parameters_.setup != Setup::kBench; }
  /// Of the gyro's z axis; 0 until it is known.
  double gyro_bias_radps() const { return standstill_.bias_radps(); }
  bool gyro_bias_known() const { return standstill_.bias_known(); }
  /// Of the real body.
  double pitch_rad() const { return attitude_.pitch_rad(); }
  /// On a ramp or block that is really there, by the map.
  bool on_obstacle() const;
  /// The belts run and the robot stays.
  bool immobilised() const { return grip_.state() == Traction::kImmobilised; }
  /// How often the camera contradicted the filter so much that it began anew.
  std::uint32_t contradictions() const { return filter_.recoveries(); }

  /// All that a snapshot says of samples, poses, ground and attitude at host time `now`.
  void write(Snapshot& snapshot, HostNs now) const;

 private:
  const Twist& steering_twist() const;
  double way_m() const;
  double heading_rate_radps() const;
  double encoder_yaw_rate_radps() const;
  void update_attitude(bool running);
  void update_grounds();
  void update_filter(double rate_radps);
  void update_grip(bool running);
  void update_speeds(double rate_radps);

  const Parameters& parameters_;
  Tracks tracks_;
  estimation::Standstill standstill_;
  estimation::AttitudeFilter attitude_;
  estimation::SlopeState slope_;
  estimation::ObstacleState leans_on_;
  Grounds grounds_;
  Grip grip_;
  model::TrackModel track_model_;
  estimation::Odometry odometry_;
  estimation::PoseFilter filter_;

  Sample sample_{};
  bool has_sample_ = false;
  bool bias_taken_ = false;
  Interval interval_{};
  Speeds speeds_{};
};

}  // namespace tp100::bridge
