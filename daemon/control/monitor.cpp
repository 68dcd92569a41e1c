#include "control/monitor.h"

#include <algorithm>
#include <cmath>

namespace tp100::control {
namespace {

constexpr double kHeadingS = 0.5;
constexpr double kTiltS = 0.3;
constexpr double kBatteryS = 2.0;
constexpr double kAgainstDutyS = 0.5;
// Below these a belt may well stand still or creep for good reasons.
constexpr double kDrivenMps = 0.03;
constexpr double kStandingMps = 0.003;
constexpr double kFullyDriven = 0.3;
constexpr double kBackwardsMps = 0.02;
constexpr double kOpposedRad = 6.0 * kRadPerDeg;
constexpr double kAskedRadps = 0.3;
constexpr double kTurningRadps = 0.15;
// A robot that stands turns by its tracks alone.
constexpr double kSlowestMps = 0.02;

bool against(double duty, double belt_mps) {
  return std::abs(duty) > kFullyDriven && std::abs(belt_mps) > kBackwardsMps && duty * belt_mps < 0;
}

// Tracks that are swapped with their encoders: only the turn shows it.
bool opposed(const Observation& seen, double wheelbase_m) {
  const double asked = (seen.commanded_right_mps - seen.commanded_left_mps) / wheelbase_m;
  return std::abs(asked) > kAskedRadps && std::abs(seen.encoder_yaw_rate_radps) > kTurningRadps &&
         asked * seen.encoder_yaw_rate_radps < 0.0;
}

double mean_mps(const Observation& seen) {
  return (std::abs(seen.left_mps) + std::abs(seen.right_mps)) / 2.0;
}

bool stands(double commanded_mps, double belt_mps) {
  return std::abs(commanded_mps) > kDrivenMps && std::abs(belt_mps) < kStandingMps;
}

}  // namespace

bool tilted(const Sample& sample, const Parameters& parameters) {
  const double horizontal = std::hypot(sample.accel_mps2[0], sample.accel_mps2[1]);
  return sample.imu_age == 0 &&
         std::atan2(horizontal, sample.accel_mps2[2]) > parameters.max_tilt_rad;
}

void Monitor::restart() {
  heading_ = tilt_ = battery_ = stalled_ = against_duty_ = disagreement_ = Lasting{};
  opposed_rad_ = 0.0;
  left_duty_.restart();
  right_duty_.restart();
  turn_.restart();
  jumps_.restart();
}

bool Monitor::duty_disagrees(const Observation& seen) {
  const Load load = {
      .turning = std::abs(seen.gyro_yaw_rate_radps) * wheelbase_m_ / 2.0 /
                 std::max(mean_mps(seen), kSlowestMps),
      .pitch_rad = seen.pitch_rad,
      .on_obstacle = seen.on_obstacle,
  };
  const Load free = {};
  const Load& taken = seen.gyro_in_use ? load : free;
  const bool left = left_duty_.update(seen.sample->left_duty, seen.left_mps, taken, seen.dt_s);
  const bool right = right_duty_.update(seen.sample->right_duty, seen.right_mps, taken, seen.dt_s);
  return left || right;
}

bool Monitor::turn_disagrees(const Observation& seen) {
  return seen.gyro_in_use && turn_.update(seen.gyro_yaw_rate_radps, seen.encoder_yaw_rate_radps,
                                          mean_mps(seen), seen.on_obstacle, seen.dt_s);
}

FaultMask Monitor::update(const Observation& seen) {
  FaultMask faults = 0;
  const auto raise = [&faults](bool condition, Fault fault) {
    if (condition) faults |= fault_bit(fault);
  };
  const double dt = seen.dt_s;
  const Sample& sample = *seen.sample;

  raise(seen.target.off_path_m > parameters_.max_cross_track_m, Fault::cross_track);
  raise(heading_.update(std::abs(seen.target.heading_error_rad) > parameters_.max_heading_error_rad,
                        dt, kHeadingS),
        Fault::heading);
  opposed_rad_ =
      opposed(seen, wheelbase_m_) ? opposed_rad_ + std::abs(seen.encoder_yaw_rate_radps) * dt : 0.0;
  raise(opposed_rad_ > kOpposedRad, Fault::heading);
  raise(tilt_.update(tilted(sample, parameters_), dt, kTiltS), Fault::tilt);
  raise(seen.pose.x_m < fence_.min_x_m || seen.pose.x_m > fence_.max_x_m ||
            seen.pose.y_m < fence_.min_y_m || seen.pose.y_m > fence_.max_y_m,
        Fault::fence);
  raise(seen.elapsed_s > parameters_.time_limit_factor * nominal_duration_s_, Fault::time_limit);
  raise(battery_.update(sample.battery_v < parameters_.min_battery_v, dt, kBatteryS),
        Fault::low_cell_voltage);
  raise(stalled_.update(stands(seen.commanded_left_mps, seen.left_mps) ||
                            stands(seen.commanded_right_mps, seen.right_mps),
                        dt, parameters_.stall_s),
        Fault::stalled_track);
  raise(against_duty_.update(
            against(sample.left_duty, seen.left_mps) || against(sample.right_duty, seen.right_mps),
            dt, kAgainstDutyS),
        Fault::encoders_against_duty);
  raise(duty_disagrees(seen), Fault::encoders_against_duty);
  raise(jumps_.update(sample), Fault::encoders_against_duty);
  const double disagreement = std::abs(seen.gyro_yaw_rate_radps - seen.encoder_yaw_rate_radps);
  raise(disagreement_.update(seen.gyro_in_use && disagreement > parameters_.disagreement_radps, dt,
                             parameters_.disagreement_s),
        Fault::gyro_against_encoders);
  raise(turn_disagrees(seen), Fault::gyro_against_encoders);
  raise(seen.immobilised, Fault::immobilised);
  return faults;
}

}  // namespace tp100::control
