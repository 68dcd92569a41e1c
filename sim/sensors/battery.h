#pragma once
// Two lithium cells in series.

#include "course/robot.h"

namespace tp100::sim {

/// Open-circuit voltage falls with the charge taken, terminal voltage with the current.
class Battery {
 public:
  explicit Battery(const course::EmulatedBattery& values) : values_(values) {}

  /// One millisecond with this much motor force (both belts, absolute values added). [N]
  void step(double force_n);
  /// At the terminals, under the present load.
  double volts() const;

 private:
  course::EmulatedBattery values_;
  double taken_as_ = 0.0;
  double amps_ = 0.0;
};

}  // namespace tp100::sim
