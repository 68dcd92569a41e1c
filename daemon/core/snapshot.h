#pragma once
// Everything that one step produced, for publishing, logging and scoring. Plain data, fixed size.

#include "core/command.h"
#include "core/estimates.h"
#include "core/faults.h"
#include "core/pose.h"
#include "core/run_state.h"
#include "core/sample.h"

namespace tp100 {

/// One step's result.
struct Snapshot {
  HostNs now_ns = 0;
  Sample sample{};  ///< newest sample; sample.sequence is valid only if has_sample
  bool has_sample = false;
  std::int64_t age_us = 0;  ///< now - when the newest sample was measured
  PerSource<Estimate> estimates{};
  FilterFigures filter{};  ///< of the fused estimate
  /// The steering pose in the course's world. Where ramps and blocks are virtual, the robot on them
  /// is slower than the one on the floor: x and y lag behind. Elsewhere it equals the steering
  /// pose.
  Pose world{};
  TerrainContact terrain_contact{};
  double left_mps = 0.0;  ///< track speeds over the last sample interval
  double right_mps = 0.0;
  double slip_left = 0.0;  ///< slip ratios in use
  double slip_right = 0.0;
  double gyro_bias_radps = 0.0;
  double imu_roll_rad = 0.0;  ///< of the real body, independent of the virtual world
  double imu_pitch_rad = 0.0;
  Slope imu_slope = Slope::kFlat;
  Obstacle imu_obstacle = Obstacle::kNone;  ///< obstacle that tilts the body, found without a map
  Command command{};
  /// Track speeds that the firmware's yaw loop will request for the command, within the track's
  /// limit.
  double commanded_left_mps = 0.0;
  double commanded_right_mps = 0.0;
  double cross_track_m = 0.0;      ///< steering pose against the path, left positive
  double heading_error_rad = 0.0;  ///< desired - actual
  double progress_m = 0.0;         ///< along the path
  bool recovering = false;         ///< a disturbance was noticed; not back on the path yet
  PoseSource steering = PoseSource::kOdometry;
  RunState run_state = RunState::kIdle;
  StartRefusal start_refusal = StartRefusal::kNone;  ///< reason that refuses a start now
  StartRefusal drive_refusal = StartRefusal::kNone;  ///< ... and driving by hand
  bool at_fence = false;                             ///< the fence limits the speed by hand
  double pause_left_s = 0.0;  ///< the run pauses, and ends after this time; 0: it does not pause
  FaultMask faults = 0;       ///< robot's and daemon's
};

}  // namespace tp100
