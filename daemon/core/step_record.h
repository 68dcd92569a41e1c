#pragma once
// One step with everything that went in and came out, as plain data of fixed size: what the
// real-time thread hands to recorders and viewers.

#include <array>
#include <cstdint>

#include "core/bounded_list.h"
#include "core/command.h"
#include "core/estimates.h"
#include "core/faults.h"
#include "core/link_state.h"
#include "core/pose.h"
#include "core/run_state.h"
#include "core/sample.h"

namespace tp100 {

// State that survives a restart of the step at standstill. Everything else in the step is then as
// after its construction, so that a recording may begin there and is replayable without earlier
// input.

/// State of an estimate; order and units as in estimation/kalman.h.
struct CarriedEstimate {
  std::array<double, 8> mean{};
  std::array<double, 64> covariance{};   ///< row by row
  std::array<double, 36> track_trust{};  ///< log-likelihoods, see estimation::TrackTrust
};

/// State of the covariance of the model's pose, see estimation/model_covariance.h.
struct CarriedModelCovariance {
  std::array<double, 25> errors{};  ///< of x, y, yaw, common slip and wheelbase (relative)
};

/// State of the pose filter.
struct CarriedFilter {
  CarriedEstimate estimate{};
  double branch_rad = 0.0;  ///< full turns between the filter's yaw and the course's
  HostNs camera_ns = 0;     ///< when the last used camera sample was taken
  HostNs last_seen_ns = 0;  ///< when the newest camera sample was taken
  bool camera_known = false;
  double nis = 0.0;
  double nis_sum = 0.0;
  std::uint32_t nis_count = 0;
  double shift_scale = 1.0;  ///< see estimation::Motion
  std::uint32_t camera_used = 0;
  std::uint32_t camera_rejected = 0;
  std::uint32_t recoveries = 0;
};

/// Roll and pitch of the body, and the offsets learned at standstill.
struct CarriedAttitude {
  double levelled_s = 0.0;
  std::array<double, 3> gyro_offset_radps{};
  std::array<double, 3> accel_offset_mps2{};
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
};

struct CarriedState {
  std::uint32_t session_number = 0;
  RunState run_state = RunState::kIdle;  ///< not under_way()
  FaultMask faults = 0;                  ///< latched by the daemon
  /// The present values of all live parameters.
  BoundedList<ParameterChange, kLiveParameters> parameters{};
  double cross_track_m = 0.0;  ///< where the last run ended
  double progress_m = 0.0;
  bool moved = false;       ///< see PlaceFacts in core/start_rule.h
  Sample sample{};          ///< the newest
  bool has_sample = false;  ///< it is of this session
  bool continues = false;   ///< the next sample ends an interval that begins with it
  Pose model{};             ///< the model's pose
  CarriedModelCovariance model_covariance{};
  CarriedEstimate odometry{};
  double virtual_x_m = 0.0;  ///< transform from the robot's floor into the course's world
  double virtual_y_m = 0.0;
  double virtual_turn_rad = 0.0;
  CarriedFilter filter{};
  CarriedAttitude attitude{};
  double gyro_bias_radps = 0.0;
  bool gyro_bias_known = false;
};

/// One step's result.
struct Snapshot {
  HostNs now_ns = 0;
  Sample sample{};  ///< newest sample; sample.sequence is valid only if has_sample
  bool has_sample = false;
  std::int64_t age_us = 0;  ///< now - when the newest sample was measured
  PerSource<Estimate> estimates{};
  PlanarCovariance odometry_twist_covariance{};  ///< in the body frame: mean over the last sample
                                                 ///< interval
  FilterFigures filter{};                        ///< of the fused estimate
  /// The steering pose in the course's world. Where ramps and blocks are virtual, the robot on them
  /// is slower than the one on the floor: x and y lag behind. An external world may own this pose.
  /// Otherwise it equals the steering pose.
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
  ObstacleClass imu_obstacle = ObstacleClass::kNone;  ///< what tilts the body, found without a map
  Command command{};
  /// Track speeds that the firmware's yaw loop will request for the command, within the track's
  /// limit.
  double commanded_left_mps = 0.0;
  double commanded_right_mps = 0.0;
  double cross_track_m = 0.0;      ///< steering pose in the world against the path, left positive
  double heading_error_rad = 0.0;  ///< desired - actual
  double progress_m = 0.0;         ///< along the path
  bool recovering = false;         ///< a disturbance was detected; not back on the path yet
  PoseSource steering = PoseSource::kOdometry;
  RunState run_state = RunState::kIdle;
  StartRefusal start_refusal = StartRefusal::kNone;  ///< reason that refuses a start now
  StartRefusal drive_refusal = StartRefusal::kNone;  ///< ... and driving by hand
  StartPlaces start_places{};                        ///< ... for where the robot stands
  double onward_m = 0.0;  ///< along the path, where a run from here would go on; 0: nowhere, too
  bool at_fence = false;  ///< the fence limits the speed by hand
  double pause_left_s = 0.0;  ///< the run is paused, and ends after this time; 0: it is not
  FaultMask faults = 0;       ///< robot's and daemon's
};

/// What happened since the last step. It is filled by the cycle, taken by the step, recorded and
/// replayed as it is.
struct StepInputs {
  using Samples = BoundedList<Sample, 64>;
  using Camera = BoundedList<CameraSample, 8>;
  using Changes = BoundedList<ParameterChange, 8>;
  using Velocities = BoundedList<VelocityInput, 8>;

  BoundedList<CarriedState, 1> restart{};  ///< before anything else, the step restarts with this
  Samples samples{};                       ///< oldest first; may be empty
  BoundedList<OperatorRequest, 16> requests{};  ///< oldest first
  Camera camera{};                              ///< as they arrived; empty without a camera
  BoundedList<WorldSample, 8> world{};          ///< oldest first; empty without an external world
  Changes changes{};                            ///< oldest first; applied before the requests
  Velocities velocities{};  ///< oldest first; empty unless the robot is driven by hand
  SessionState session = SessionState::kClosed;
  ClockState clock{};
  std::uint32_t session_number = 0;             ///< +1 each time a session becomes ready
  bool robot_rebooted = false;                  ///< a new boot nonce since the last step
  RequestAnswer answer = RequestAnswer::kNone;  ///< to the last arm or disarm
};

/// Inputs and results of one step. Replaying the inputs in order through a step with the same
/// parameters and course gives the same results bit for bit (on which processors:
/// record/RECORDINGS.md).
struct StepRecord {
  HostNs now_ns = 0;
  std::uint64_t step = 0;  ///< counts the steps since the start; a gap is a dropped record
  StepInputs inputs{};

  LinkCounters link{};         ///< counters after the step
  bool command_valid = false;  ///< snapshot.command was sent
  RobotRequest request = RobotRequest::kNone;
  Snapshot snapshot{};
};

}  // namespace tp100
