#include "control/monitor.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "core/sample.h"

namespace tp100::control {
namespace {

using Limits = shared::HostLimits<double>;

constexpr double kObstacleS = 1.0;
// A robot that may stall for longer is judged as soon as one of the default.
constexpr double kLongestStallS = 1.0;

// The robot itself gives up after 200 ms without a valid command.
constexpr double kNoneTakenS = 0.3;

constexpr double kTiltS = 0.3;
constexpr double kBatteryS = 2.0;
constexpr double kAgainstDutyS = 0.5;
// With a command below kDrivenMps or a duty below kFullyDriven a track may stand still or creep.
constexpr double kDrivenMps = 0.03;
constexpr double kStandingMps = 0.003;
constexpr double kFullyDriven = 0.3;
constexpr double kBackwardsMps = 0.02;
constexpr double kOpposedRad = 6.0 * kRadPerDeg;
constexpr double kAskedRadps = 0.3;
constexpr double kTurningRadps = 0.15;
// Least deceleration of a turn whose command has reversed.
constexpr double kReversalRadps2 = 2.5;
// A robot at standstill turns by its tracks alone.
constexpr double kSlowestMps = 0.02;

bool against(double duty, double track_mps) {
  return std::abs(duty) > kFullyDriven && std::abs(track_mps) > kBackwardsMps &&
         duty * track_mps < 0;
}

double mean_mps(const Observation& seen) {
  return (std::abs(seen.left_mps) + std::abs(seen.right_mps)) / 2.0;
}

bool at_standstill(double commanded_mps, double track_mps) {
  return std::abs(commanded_mps) > kDrivenMps && std::abs(track_mps) < kStandingMps;
}

}  // namespace

bool DutyMonitor::update(double duty, double track_mps, const Load& load, double dt_s) {
  obstacle_s_ = load.on_obstacle ? kObstacleS : std::max(0.0, obstacle_s_ - dt_s);
  const double load_duty = turn_duty_.update(load.turning, dt_s) +
                           Limits::duty_per_slope_rad() * std::abs(load.pitch_rad) +
                           (obstacle_s_ > 0.0 ? shared::obstacle_duty<double>() : 0.0);
  const bool free = load_duty < Limits::free_duty();
  return law_.update(duty, track_mps, load_duty, free, dt_s, motor_.dead_band, motor_.feed_forward,
                     Limits::soonest_share() * std::min(motor_.stall_s, kLongestStallS));
}

bool JumpMonitor::update(const Sample& sample) {
  const double dt_s = static_cast<double>(sample.device_us - device_us_) * 1e-6;
  const auto possible = [&](std::int64_t counts) {
    return counts_possible(static_cast<double>(counts), max_per_s_, dt_s);
  };
  const bool jumped = known_ && !(possible(sample.left_counts - left_counts_) &&
                                  possible(sample.right_counts - right_counts_));
  known_ = true;
  device_us_ = sample.device_us;
  left_counts_ = sample.left_counts;
  right_counts_ = sample.right_counts;
  return jumped;
}

bool tilted(const Sample& sample, const Parameters& parameters) {
  const double horizontal = magnitude(sample.accel_mps2[0], sample.accel_mps2[1]);
  return sample.imu_age == 0 &&
         std::atan2(horizontal, sample.accel_mps2[2]) > parameters.max_tilt_rad;
}

void Monitor::restart() {
  envelope_.restart();
  tilt_ = battery_ = stalled_ = against_duty_ = disagreement_ = none_taken_ = Lasting{};
  opposed_rad_ = running_on_radps_ = 0.0;
  left_duty_.restart();
  right_duty_.restart();
  turn_.restart();
  jumps_.restart();
}

// If tracks are swapped together with their encoders, only the turn shows it.
bool Monitor::turns_against(const Observation& seen) {
  const double asked = (seen.commanded_right_mps - seen.commanded_left_mps) / wheelbase_m_;
  const double turned = std::abs(seen.encoder_yaw_rate_radps);
  const bool against = asked * seen.encoder_yaw_rate_radps < 0.0;
  // After its command has reversed, a turn goes on for a moment.
  running_on_radps_ =
      against ? std::max(0.0, running_on_radps_ - kReversalRadps2 * seen.dt_s) : turned;
  opposed_rad_ = against && std::abs(asked) > kAskedRadps && turned > kTurningRadps
                     ? opposed_rad_ + std::max(0.0, turned - running_on_radps_) * seen.dt_s
                     : 0.0;
  return opposed_rad_ > kOpposedRad;
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
  if (!seen.gyro_in_use) return false;
  const double slip_radps = shared::slip_of_turn<double, Limits>(
      slip_share_, seen.on_obstacle, seen.gyro_yaw_rate_radps, mean_mps(seen) / wheelbase_m_);
  return turn_.update(seen.gyro_yaw_rate_radps * seen.dt_s, seen.encoder_yaw_rate_radps * seen.dt_s,
                      slip_radps * seen.dt_s, seen.dt_s);
}

FaultMask Monitor::update(const Observation& seen) {
  FaultMask faults = 0;
  const auto raise = [&faults](bool condition, Fault fault) {
    if (condition) faults |= fault_bit(fault);
  };
  const double dt = seen.dt_s;
  const Sample& sample = *seen.sample;

  faults |= envelope_.update({.steering = {.pose = seen.pose, .off_path_m = seen.target.off_path_m},
                              .others = seen.others,
                              .by_hand = seen.by_hand,
                              .heading_error_rad = seen.target.heading_error_rad,
                              .elapsed_s = seen.elapsed_s,
                              .dt_s = dt,
                              .recoveries = seen.recoveries});
  raise(turns_against(seen), Fault::heading);
  raise(tilt_.update(tilted(sample, parameters_), dt, kTiltS), Fault::tilt);
  raise(battery_.update(sample.battery_v < parameters_.min_battery_v, dt, kBatteryS),
        Fault::battery_below_minimum);
  raise(stalled_.update(at_standstill(seen.commanded_left_mps, seen.left_mps) ||
                            at_standstill(seen.commanded_right_mps, seen.right_mps),
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
  const bool none_taken = seen.commanded && sample.last_command == last_taken_;
  last_taken_ = sample.last_command;
  raise(none_taken_.update(none_taken, dt, kNoneTakenS), Fault::command_timeout);
  return faults;
}

}  // namespace tp100::control
