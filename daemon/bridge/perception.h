#pragma once
// The robot's state from all measurements: tracks, gyro, attitude, three poses, terrain and
// traction.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "bridge/parameters.h"
#include "bridge/terrain_contacts.h"
#include "bridge/traction_estimator.h"
#include "core/limits.h"
#include "core/sample.h"
#include "core/step_record.h"
#include "course/course.h"
#include "estimation/attitude.h"
#include "estimation/model_covariance.h"
#include "estimation/motion.h"
#include "estimation/odometry.h"
#include "estimation/pose_filter.h"
#include "estimation/standstill.h"
#include "model/track_model.h"

namespace tp100::bridge {

/// One sample interval in device time.
struct Interval {
  double dt_s = 0.0;
  TrackSpeeds tracks{};
  double gyro_z_radps = 0.0;  ///< mean over the interval, calibrated scale, bias included
  bool gyro_fresh = false;    ///< both ends had a new IMU value
  double warming_degc = 0.0;  ///< rise of the gyro's temperature
};

/// Turns consecutive samples into intervals. No allocation; safe in the real-time thread.
class SampleIntervals {
 public:
  SampleIntervals(double counts_per_metre, double gyro_scale)
      : metres_per_count_(1.0 / counts_per_metre), gyro_scale_(gyro_scale) {}

  /// Forgets the last sample (a new session or boot).
  void restart() { has_last_ = false; }
  /// The next interval begins with `last`.
  void resume(const Sample& last) {
    has_last_ = true;
    last_ = last;
  }
  /// The next sample ends an interval.
  bool has_last() const { return has_last_; }
  /// The interval that ends with `sample`; nothing for the first sample or one that is not newer.
  std::optional<Interval> update(const Sample& sample);

  /// Calibrated z rate of a sample, bias included. [rad/s]
  double gyro_z_radps(const Sample& sample) const { return sample.gyro_radps[2] * gyro_scale_; }

 private:
  double metres_per_count_;
  double gyro_scale_;
  bool has_last_ = false;
  Sample last_{};
};

/// Speeds for control. Speeds over one sample interval are only a few encoder edges: these are
/// low-pass filtered with a lag of 40 ms.
struct Speeds {
  Twist steering{};  ///< of the steering pose
  TrackSpeeds tracks{};
  double encoder_yaw_rate_radps = 0.0;  ///< of eqs 1-5, by this robot's values
  double gyro_yaw_rate_radps = 0.0;     ///< about the world's vertical, bias taken off
};

/// Takes samples and camera poses and computes the pose by the model alone, by odometry and by the
/// filter. It knows no paths, operators or commands. No allocation after construction; safe in the
/// real-time thread.
class Perception {
 public:
  /// `parameters` must outlive this; only live parameters may change. `course` may be null: an
  /// unbounded plane.
  Perception(const Parameters& parameters, const course::Course* course);

  /// A new session or boot: the following samples do not continue the previous ones.
  void restart();
  /// The session has ended: the newest sample is no longer valid.
  void lose_sample() { has_sample_ = false; }
  /// A run begins at host time `now` with the robot at a known pose.
  void begin(const Pose& start, HostNs now);
  /// A run begins where the estimates say that the robot is.
  void continue_run() { traction_estimator_.restart(); }
  /// True on level ground at standstill or without a session: carry() and resume() then keep all
  /// that later results depend on.
  bool at_rest() const;
  /// At standstill, or there is no session: the robot may be moved by hand.
  bool at_standstill() const { return standstill_.still() || !has_sample_; }
  /// Writes the state that resume() takes.
  void carry(CarriedState& state) const;
  /// Edits a carried state: the robot is on level ground at `at`, or at its old place.
  void level(const std::optional<Pose>& at, HostNs now, CarriedState& state) const;
  /// As after construction, with this state.
  void resume(const CarriedState& state);
  /// The steering pose in `parameters` has changed.
  void steering_changed() { terrain_contacts_.steer_by(parameters_.steering); }
  /// Terrain of an external world; call before the samples.
  void set_external_terrain(const ExternalTerrain& external) {
    terrain_contacts_.set_external_terrain(external);
  }
  /// Takes samples in order. At standstill outside a run the robot is assumed to be level at the
  /// start; traction is monitored in runs only.
  void take(const Sample& next, bool running);
  /// Ignored on a stand, where the robot that the camera sees does not move.
  void take(const CameraSample& seen);

  /// The newest sample of all, and whether it is of this session.
  const Sample& sample() const { return sample_; }
  bool has_sample() const { return has_sample_; }
  /// There is one that is not older than the time-out.
  bool fresh(HostNs now) const {
    return has_sample_ && now - sample_.measured_ns <= kSampleTimeoutNs;
  }
  /// The gyro steers and its newest value is old.
  bool imu_stale() const { return gyro_steers() && sample_.imu_age > kOldestImu; }

  Estimate estimate(PoseSource source) const;
  Estimate steering_estimate() const { return estimate(parameters_.steering); }
  Pose steering_pose() const { return steering_estimate().pose; }
  /// Standard deviation of its position, per axis.
  double steering_sd_m() const {
    const PlanarCovariance covariance = steering_estimate().covariance;
    return std::sqrt(std::max(covariance.xx, covariance.yy));
  }
  /// The steering pose in the course's world, which differs where ramps and blocks are virtual.
  Pose world_pose() const { return terrain_contacts_.world(steering_pose()); }
  /// Transform from the robot's floor into that world.
  const Transform2d& to_world() const { return terrain_contacts_.transform(); }
  const Speeds& speeds() const { return speeds_; }
  /// False on a stand, where the body does not turn.
  bool gyro_steers() const { return parameters_.setup != Setup::kStand; }
  /// Bias of the gyro's z axis; 0 until it is known.
  double gyro_bias_radps() const { return standstill_.bias_radps(); }
  bool gyro_bias_known() const { return standstill_.bias_known(); }
  /// Pitch of the real body.
  double pitch_rad() const { return attitude_.pitch_rad(); }
  /// On a real ramp or block (not a virtual one), by the map.
  bool on_obstacle() const;
  /// The tracks run but the robot does not move.
  bool immobilised() const { return traction_estimator_.state() == Traction::kImmobilised; }
  /// A camera sample was used since the samples were last interrupted.
  bool camera_known() const { return filter_.camera_known(); }
  /// ... and the last one is not old.
  bool camera_sees() const;
  /// How often the camera contradicted the filter so much that the filter was reset.
  std::uint32_t contradictions() const { return filter_.recoveries(); }

  /// Writes samples, poses, terrain and attitude at host time `now`.
  void write(Snapshot& snapshot, HostNs now) const;

 private:
  PerSource<Estimate> estimates() const;
  double distance_m() const;
  double heading_rate_radps() const;
  double encoder_yaw_rate_radps() const;
  void update_attitude(bool running);
  void update_terrain_contacts();
  void update_estimates(double rate_radps);
  void update_traction(bool running);
  void update_speeds(double rate_radps);

  const Parameters& parameters_;
  SampleIntervals intervals_;
  estimation::Standstill standstill_;
  estimation::AttitudeFilter attitude_;
  estimation::SlopeState slope_;
  estimation::ObstacleState obstacle_class_;
  TerrainContacts terrain_contacts_;
  TractionEstimator traction_estimator_;
  model::TrackModel track_model_;
  estimation::ModelCovariance model_covariance_;
  estimation::Odometry odometry_;
  estimation::PoseFilter filter_;

  Sample sample_{};
  bool has_sample_ = false;
  Interval interval_{};
  Speeds speeds_{};
};

}  // namespace tp100::bridge
