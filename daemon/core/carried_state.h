#pragma once
// State that survives a restart of the step at standstill. Everything else in the step is then as
// after its construction, so that a recording may begin there and is replayable without earlier
// input.

#include <array>
#include <cstdint>

#include "core/bounded_list.h"
#include "core/command.h"
#include "core/estimates.h"
#include "core/faults.h"
#include "core/run_state.h"
#include "core/sample.h"

namespace tp100 {

/// State of an estimate; places and units as in estimation/kalman.h.
struct CarriedEstimate {
  std::array<double, 8> mean{};
  std::array<double, 64> covariance{};  ///< row by row
  std::array<double, 8> slip_walk{};    ///< log-likelihoods, see estimation::SlipWalk
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
  std::uint32_t camera_used = 0;
  std::uint32_t camera_rejected = 0;
  std::uint32_t recoveries = 0;
};

/// Roll and pitch of the body, and the offsets learnt at standstill.
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
  /// The values in force of all live parameters.
  BoundedList<ParameterChange, kLiveParameters> parameters{};
  double cross_track_m = 0.0;  ///< where the last run ended
  double progress_m = 0.0;
  Sample sample{};          ///< the newest
  bool has_sample = false;  ///< it is of this session
  bool continues = false;   ///< the next sample continues it
  Pose model{};             ///< the model's pose
  CarriedEstimate odometry{};
  double virtual_x_m = 0.0;  ///< from the robot's floor into the course's world
  double virtual_y_m = 0.0;
  double virtual_turn_rad = 0.0;
  CarriedFilter filter{};
  CarriedAttitude attitude{};
  double gyro_bias_radps = 0.0;
  bool gyro_bias_known = false;
};

}  // namespace tp100
