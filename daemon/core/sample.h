#pragma once
// Measurements that reach the step, in SI units: of the robot, an overhead camera, an external
// world.

#include <array>
#include <cmath>
#include <cstdint>

#include "core/enum_names.h"
#include "core/faults.h"
#include "core/pose.h"
#include "core/time.h"
#include "shared/monitors.h"

namespace tp100 {

/// Robot states, as on the wire (wire/messages.h).
enum class RobotState : std::uint8_t { kHello, kParameters, kDisarmed, kArmed, kRunning, kFaulted };

/// Names as in messages.
inline constexpr std::array<EnumName<RobotState>, 6> kRobotStateNames = {{
    {RobotState::kHello, "hello"},
    {RobotState::kParameters, "parameters"},
    {RobotState::kDisarmed, "disarmed"},
    {RobotState::kArmed, "armed"},
    {RobotState::kRunning, "running"},
    {RobotState::kFaulted, "faulted"},
}};
constexpr const char* to_string(RobotState state) { return name_in(kRobotStateNames, state); }

/// One sample. Counts and times are extended to 64 bit and never wrap within a boot.
struct Sample {
  std::uint16_t sequence = 0;     ///< as on the wire; commands answer it
  std::uint32_t lost_before = 0;  ///< samples missing between this one and the one before
  DeviceUs device_us = 0;         ///< when it was measured, robot's clock
  HostNs measured_ns = 0;         ///< the same instant on the host's clock, by clock sync
  std::int64_t left_counts = 0;   ///< encoder edges
  std::int64_t right_counts = 0;
  std::array<double, 3> gyro_radps{};  ///< body axes x, y, z; nominal scale, bias included
  std::array<double, 3> accel_mps2{};  ///< specific force, body axes
  double temperature_degc = 0.0;
  double battery_v = 0.0;  ///< of the whole battery
  double left_duty = 0.0;  ///< -1..1, as applied
  double right_duty = 0.0;
  RobotState state = RobotState::kHello;
  FaultMask faults = 0;            ///< latched by the robot
  std::uint16_t last_command = 0;  ///< sequence of the last command that it accepted
  std::uint8_t imu_age = 255;      ///< samples since the IMU values were new; 0 is fresh
};

/// The robot reports that its motors are enabled.
inline bool enabled(const Sample& sample) {
  return sample.state == RobotState::kArmed || sample.state == RobotState::kRunning;
}

/// The robot is enabled or has a duty. If its tracks turn without either, a hand turns them.
inline bool motors_on(const Sample& sample) {
  return enabled(sample) || sample.left_duty != 0.0 || sample.right_duty != 0.0;
}

// One detection of the robot's marker by an overhead camera.

/// Place and direction of the marker in the world frame, found through a plane homography at the
/// marker's height over a flat floor. Where the robot climbs or tilts, the marker leaves that
/// plane: the sample includes that shift, and users must correct for it. Arrives late;
/// `measured_ns` is when the image was taken.
struct CameraSample {
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;  ///< any branch
  HostNs measured_ns = 0;
  std::uint32_t sequence = 0;  ///< of the frame; grows
};

// One message of an external world (a game engine, a simulator).

/// In the frame of the course, REP-103, already checked: finite and in range.
struct WorldSample {
  std::uint32_t session = 0;  ///< +1 each time a world connects; a change means a new world
  /// The `now` of the step whose pose this answers; of a file, which answers none, when it was
  /// read.
  HostNs answered_ns = 0;
  bool stop = false;  ///< the world requests a standstill, like an operator's stop
  bool has_ground = false;
  double height_m = 0.0;  ///< of the reference point above the floor
  double roll_rad = 0.0;
  double pitch_rad = 0.0;      ///< nose-up negative
  double slip_offset = 0.0;    ///< of the surface, added to both slip ratios
  double step_height_m = 0.0;  ///< of the block that the tracks touch; 0: none
  bool blocked = false;        ///< the robot cannot move on, whatever its tracks do
  bool has_pose = false;       ///< only if the world owns the pose
  Pose pose{};
};

// Standstill by encoder counts.

/// Counts of a track at standstill differ by this at most: one edge may flicker.
inline constexpr std::int64_t kStandstillCounts = 1;
/// A shorter standstill gives no useful bias of the gyro.
inline constexpr double kBiasStandstillS = 0.3;

// Greatest distance that a track can travel between two samples.

/// Counts per second that no track reaches, whether driven, pushed or rolling down a ramp.
constexpr double max_counts_per_s(double max_track_mps, double counts_per_metre) {
  return shared::HostLimits<double>::jump_speeds() * max_track_mps * counts_per_metre;
}

/// True if a track can have made so many counts in `dt_s`; always true if `max_per_s` is 0.
inline bool counts_possible(double counts, double max_per_s, double dt_s) {
  // Edges that an interrupt moved from one sample to the next.
  constexpr double kSlackCounts = 4.0;
  return max_per_s <= 0.0 || dt_s <= 0.0 || std::abs(counts) <= max_per_s * dt_s + kSlackCounts;
}

}  // namespace tp100
