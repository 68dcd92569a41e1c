#pragma once
// Conditions that end a run, each with its own fault.

#include <cstdint>

#include "control/envelope.h"
#include "control/parameters.h"
#include "control/tracker.h"
#include "core/arithmetic.h"
#include "core/faults.h"
#include "core/sample.h"
#include "shared/monitors.h"

namespace tp100::control {

// Three monitors check the encoders. Two, which the robot runs too, compare them with each track's
// duty and with the gyro. The third finds counts that are impossible for a track.

/// Relation of duty and speed, by the robot's file.
struct MotorModel {
  double dead_band = 0.15;    ///< duty at which a track just moves
  double feed_forward = 4.0;  ///< duty per m/s above it; 0: no relation known
  double stall_s = 1.0;       ///< time after which the robot reports a track that stands
};

/// Loads that need duty without adding speed. A freely spinning track has none.
struct Load {
  double turning = 0.0;      ///< track speed due to the turn alone, as a fraction of the mean speed
  double pitch_rad = 0.0;    ///< of the floor under the robot
  bool on_obstacle = false;  ///< a real ramp or block
};

/// Checks that one track moves according to its duty, see shared/monitors.h. No allocation; safe in
/// the real-time thread.
class DutyMonitor {
 public:
  explicit DutyMonitor(const MotorModel& motor) : motor_(motor) {}

  /// A run begins.
  void restart() { *this = DutyMonitor(motor_); }
  /// Takes duty (-1..1) and measured speed, forward positive, over `dt_s`. True: too much is
  /// missing.
  bool update(double duty, double track_mps, const Load& load, double dt_s);

 private:
  MotorModel motor_;
  shared::DutyMonitor<double> law_;
  shared::TurnDuty<double, shared::HostLimits<double>> turn_duty_;
  double obstacle_s_ = 0.0;  ///< until the last obstacle is forgotten
};

/// Finds jumps of both tracks' counts. An isolated jump never gets here: link::EncoderCount removes
/// it. No allocation; safe in the real-time thread.
class JumpMonitor {
 public:
  /// Greatest counts per second of a track; 0: unlimited.
  explicit JumpMonitor(double max_per_s) : max_per_s_(max_per_s) {}

  /// A run begins.
  void restart() { known_ = false; }
  /// Takes the newest sample, new or not. True: it cannot follow the one before.
  bool update(const Sample& sample);

 private:
  double max_per_s_;
  bool known_ = false;
  DeviceUs device_us_ = 0;
  std::int64_t left_counts_ = 0, right_counts_ = 0;
};

/// Inputs of the monitor in one step. SI units.
struct Observation {
  const Sample* sample = nullptr;  ///< newest sample; never null while a run is on
  Pose pose{};                     ///< steering pose in the course's world
  double left_mps = 0.0;           ///< measured track speeds
  double right_mps = 0.0;
  double encoder_yaw_rate_radps = 0.0;  ///< eq 5, by this robot's values
  double gyro_yaw_rate_radps = 0.0;     ///< bias removed
  bool gyro_in_use = false;  ///< the body turns as the gyro measures; else the tracks spin free
  double pitch_rad = 0.0;    ///< of the real body
  bool on_obstacle = false;  ///< a real ramp or block
  bool immobilised = false;  ///< the tracks run but the robot does not move
  bool by_hand = false;      ///< no path, fence or time limit applies: see HandDrive
  /// Other poses that tell where the robot is, see Witness.
  Witnesses others{};
  std::uint32_t recoveries = 0;  ///< how often the camera reset the fused pose
  bool commanded = false;        ///< a command went out in the last step
  Target target{};
  double commanded_left_mps = 0.0;  ///< track speeds according to the command
  double commanded_right_mps = 0.0;
  double elapsed_s = 0.0;  ///< since the run began
  double dt_s = 0.0;       ///< since the last observation
};

/// True if the IMU's newest value shows a tilt of more than control.max_tilt_deg.
bool tilted(const Sample& sample, const Parameters& parameters);

/// The robot's values that the monitor uses.
struct MonitoredRobot {
  MotorModel motor{};
  double wheelbase_m = 0.2742;    ///< equivalent, eq 5
  bool identified = true;         ///< else gyro and encoders may disagree about a turn
  double max_counts_per_s = 0.0;  ///< of a track, see counts_possible(); 0: any
};

/// Monitors one run, or one drive by hand. No allocation; safe in the real-time thread.
class Monitor {
 public:
  Monitor(const Parameters& parameters, const course::Fence& fence, double nominal_duration_s,
          const MonitoredRobot& robot)
      : parameters_(parameters),
        envelope_(parameters, fence, nominal_duration_s),
        wheelbase_m_(robot.wheelbase_m),
        left_duty_(robot.motor),
        right_duty_(robot.motor),
        slip_share_(robot.identified ? parameters.turn_slip_share : 1.0),
        jumps_(robot.max_counts_per_s) {}

  /// Forgets all durations; call when a run begins.
  void restart();
  /// The faults that end the run now; 0 to go on.
  FaultMask update(const Observation& seen);

 private:
  bool turns_against(const Observation& seen);
  bool duty_disagrees(const Observation& seen);
  bool turn_disagrees(const Observation& seen);

  Parameters parameters_;
  Envelope envelope_;
  double wheelbase_m_;
  DutyMonitor left_duty_, right_duty_;
  double slip_share_;  ///< part of a turn that slip may take; see Parameters
  shared::TurnBalance<double, shared::HostLimits<double>> turn_;
  JumpMonitor jumps_;
  double opposed_rad_ = 0.0;       ///< rotation against the command
  double running_on_radps_ = 0.0;  ///< turn rate that a reversal explains
  std::uint16_t last_taken_ = 0;   ///< last command that the robot accepted
  Lasting tilt_, battery_, stalled_, against_duty_, disagreement_, none_taken_;
};

}  // namespace tp100::control
