#include "sim/sensors/drive_train.h"

#include <algorithm>

#include "sim/body/body.h"

namespace tp100::sim {
namespace {

// Voltage swing of the battery from full to empty.
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

Motor::Motor(const course::EmulatedMotor& values, double gain)
    : values_(values),
      gain_(gain),
      damping_nspm_(values.stall_n_per_v / values.no_load_mps_per_v),
      inertia_kg_(values.lag_s * damping_nspm_) {}

void Motor::step(double duty, double battery_v, double load_n) {
  constexpr double kStepS = static_cast<double>(kPhysicsStepNs) * 1e-9;
  const double volts = duty * gain_ * std::max(0.0, battery_v - values_.bridge_drop_v);
  force_n_ = duty == 0.0 ? 0.0
                         : std::clamp(volts * values_.stall_n_per_v - damping_nspm_ * track_mps_,
                                      -values_.current_limit_n, values_.current_limit_n);
  // Motor and ground exchange speed and force one step apart. With the last force alone, a track at
  // standstill could oscillate for ever with a period of two steps, which the mean cancels.
  const double driving_n = force_n_ - 0.5 * (load_n + last_load_n_);
  last_load_n_ = load_n;
  // Coulomb friction stops the track within this step if it is strong enough, else it acts in full.
  const double to_rest_n = -(track_mps_ * inertia_kg_ / kStepS + driving_n);
  const double friction_n = std::clamp(to_rest_n, -values_.friction_n, values_.friction_n);
  if (friction_n == to_rest_n) {
    track_mps_ = 0.0;
    return;
  }
  track_mps_ += (driving_n + friction_n) / inertia_kg_ * kStepS;
}

}  // namespace tp100::sim
