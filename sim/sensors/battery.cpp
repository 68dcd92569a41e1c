#include "sim/sensors/battery.h"

#include <algorithm>

#include "sim/body/body.h"

namespace tp100::sim {
namespace {

// From full to empty, both cells together.
constexpr double kSwingV = 2.2;

}  // namespace

void Battery::step(double force_n) {
  amps_ = values_.idle_a + values_.amps_per_n * force_n;
  taken_as_ += amps_ * static_cast<double>(kPhysicsStepNs) * 1e-9;
}

double Battery::volts() const {
  const double share = std::min(1.0, taken_as_ / values_.capacity_as);
  return values_.full_v - kSwingV * share - values_.internal_ohm * amps_;
}

}  // namespace tp100::sim
