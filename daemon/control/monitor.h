#pragma once
// The aborts: conditions under which a run ends, each with its own fault.

#include "control/encoder_watch.h"
#include "control/parameters.h"
#include "control/tracker.h"
#include "core/faults.h"
#include "core/sample.h"

namespace tp100::control {

/// What one step looks like to the monitor. SI units.
struct Observation {
  const Sample* sample = nullptr;  ///< newest sample; never null while a run is on
  Pose pose{};                     ///< steering pose
  double left_mps = 0.0;           ///< measured belt speeds
  double right_mps = 0.0;
  double encoder_yaw_rate_radps = 0.0;  ///< eq 5, by this robot's values
  double gyro_yaw_rate_radps = 0.0;     ///< bias removed
  bool gyro_in_use = false;  ///< the body turns as the gyro says; else the tracks spin free
  double pitch_rad = 0.0;    ///< of the real body
  bool on_obstacle = false;  ///< a ramp or block that is really there
  bool immobilised = false;  ///< the belts run, the robot does not
  Target target{};
  double commanded_left_mps = 0.0;  ///< belt speeds that the command means
  double commanded_right_mps = 0.0;
  double elapsed_s = 0.0;  ///< since the run began
  double dt_s = 0.0;       ///< since the last observation
};

/// The IMU's newest value says that the robot leans by more than control.max_tilt_deg.
bool tilted(const Sample& sample, const Parameters& parameters);

/// A condition that must last before it counts.
class Lasting {
 public:
  /// True once `condition` has held for `needed_s`.
  bool update(bool condition, double dt_s, double needed_s) {
    held_s_ = condition ? held_s_ + dt_s : 0.0;
    return condition && held_s_ >= needed_s;
  }

 private:
  double held_s_ = 0.0;
};

/// What the monitor knows of the robot.
struct MonitoredRobot {
  MotorModel motor{};
  double wheelbase_m = 0.2742;    ///< equivalent, eq 5
  bool identified = true;         ///< else gyro and encoders may disagree about a turn
  double max_counts_per_s = 0.0;  ///< of a track, see counts_possible(); 0: any
};

/// Watches one run. No allocation; safe in the real-time thread.
class Monitor {
 public:
  Monitor(const Parameters& parameters, const course::Fence& fence, double nominal_duration_s,
          const MonitoredRobot& robot)
      : parameters_(parameters),
        fence_(fence),
        nominal_duration_s_(nominal_duration_s),
        wheelbase_m_(robot.wheelbase_m),
        left_duty_(robot.motor),
        right_duty_(robot.motor),
        turn_(robot.wheelbase_m, robot.identified ? parameters.turn_slip_share : 1.0),
        jumps_(robot.max_counts_per_s) {}

  /// Forgets what has lasted; call when a run begins.
  void restart();
  /// The faults that end the run now; 0 to go on.
  FaultMask update(const Observation& seen);

 private:
  bool duty_disagrees(const Observation& seen);
  bool turn_disagrees(const Observation& seen);

  Parameters parameters_;
  course::Fence fence_;
  double nominal_duration_s_;
  double wheelbase_m_;
  DutyWatch left_duty_, right_duty_;
  TurnBalance turn_;
  JumpWatch jumps_;
  double opposed_rad_ = 0.0;  ///< turned against what was asked for
  Lasting heading_, tilt_, battery_, stalled_, against_duty_, disagreement_;
};

}  // namespace tp100::control
