#pragma once
// Battery and motors.

#include "course/robot_file.h"

namespace tp100::sim {

/// Two lithium cells in series. Open-circuit voltage falls with the charge taken, terminal voltage
/// with the current.
class Battery {
 public:
  explicit Battery(const course::EmulatedBattery& values) : values_(values) {}

  /// Advances one millisecond with this motor force (sum of both tracks' magnitudes). [N]
  void step(double force_n);
  /// Terminal voltage under the present load.
  double volts() const;

 private:
  course::EmulatedBattery values_;
  double taken_as_ = 0.0;
  double amps_ = 0.0;
};

/// A DC gear motor driven by one half of an L293D, seen at the track: speed by voltage, back-EMF,
/// Coulomb friction and load. One step is one millisecond.
class Motor {
 public:
  /// `gain`: this motor's strength relative to the nominal one.
  Motor(const course::EmulatedMotor& values, double gain);

  /// Advances one step at `duty` (-1..1) from a battery at `battery_v`; `load_n` is the force that
  /// the ground exerted on the body through this track in the step before, forward positive. At
  /// duty 0 the driver is off and the motor coasts.
  void step(double duty, double battery_v, double load_n);

  double track_mps() const { return track_mps_; }
  /// Force of the motor at the track; it determines the battery current.
  double force_n() const { return force_n_; }

 private:
  course::EmulatedMotor values_;
  double gain_;
  double damping_nspm_;
  double inertia_kg_;
  double track_mps_ = 0.0;
  double force_n_ = 0.0;
  double last_load_n_ = 0.0;
};

}  // namespace tp100::sim
