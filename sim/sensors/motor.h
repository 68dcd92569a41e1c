#pragma once
// A DC gear motor behind one half of an L293D, seen at the belt.

#include "course/robot.h"

namespace tp100::sim {

/// Speed by voltage, back-EMF, Coulomb friction and load. One step is one millisecond.
class Motor {
 public:
  /// `gain`: this motor's strength against the nominal one.
  Motor(const course::EmulatedMotor& values, double gain);

  /// Advances one step at `duty` (-1..1) from a battery at `battery_v`, while the ground pushes the
  /// body forward with `load_n` through this belt. At duty 0 the driver is off and the motor
  /// coasts.
  void step(double duty, double battery_v, double load_n);

  double belt_mps() const { return belt_mps_; }
  /// Force that the motor makes at the belt; what the battery pays for.
  double force_n() const { return force_n_; }

 private:
  course::EmulatedMotor values_;
  double gain_;
  double damping_nspm_;
  double inertia_kg_;
  double belt_mps_ = 0.0;
  double force_n_ = 0.0;
};

}  // namespace tp100::sim
