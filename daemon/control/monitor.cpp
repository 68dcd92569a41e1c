#include "control/monitor.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "core/sample.h"

namespace tp100::control {
namespace {

// Limit of the distance that the duty implies beyond the counted one, and the shortest time until a
// blocked track is reported, whatever its duty.
constexpr double kMissingM = 0.04, kSoonestS = 0.7;

// Duty that a track may need beyond its usual one: always; in a turn, where it scrubs over the
// floor; on a slope; and with the greatest load that traction can put on it.
constexpr double kMarginDuty = 0.02;
constexpr double kMarginShare = 0.1;
constexpr double kTurningDuty = 0.4;
// Track speed due to the turn alone, as a fraction of the mean speed, from which on a turn takes
// half and all of its duty: the resistance against turning falls slowly with the radius.
constexpr double kHalfTurning = 0.12;
constexpr double kFullTurning = 0.4;
constexpr double kDutyPerSlopeRad = 0.8;
constexpr double kObstacleDuty = 0.4;
constexpr double kObstacleS = 1.0;
// A load decays more slowly than it rises.
constexpr double kTurningFallPerS = 0.5;

// The robot itself gives up after 200 ms without a valid command.
constexpr double kNoneTakenS = 0.3;

// A gain is learned only from a track that runs evenly and freely and does not brake. It may fall
// quickly, but rise only as fast as a battery sags: otherwise a fault would be learned as normal.
constexpr double kMinGain = 0.7;
constexpr double kGainDownS = 0.3;
constexpr double kGainUpPerS = 0.005;
// Friction takes a smaller share of the duty at higher speed: beyond this factor the gain differs.
constexpr double kBeyond = 1.25;
constexpr double kSlowS = 0.2;
constexpr double kSlowest = 0.95, kFastest = 1.1;
// At very low speed, duty and speed consist mostly of noise and of corrections of lag.
constexpr double kMinMps = 0.028;
constexpr double kStraight = 0.05;
constexpr double kLevelRad = 0.03;

// Slip also takes part of one track's distance, as a fraction of what it may take of a turn.
constexpr double kDistanceShare = 0.8;
// One track may stand on a block while the other slips.
constexpr double kObstacleShare = 0.25;
// A disturbance turns the robot faster.
constexpr double kSlowRadps = 10.0 * kRadPerDeg;

/// Duty that a turn takes from one track and gives the other.
double turn_duty(double turning) {
  const double share =
      turning < kHalfTurning
          ? 0.5 * turning / kHalfTurning
          : std::lerp(0.5, 1.0, (turning - kHalfTurning) / (kFullTurning - kHalfTurning));
  return kTurningDuty * share;
}

double drained(double balance_rad, double by_rad) {
  return std::copysign(std::max(0.0, std::abs(balance_rad) - by_rad), balance_rad);
}

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
  constexpr double kMaxMps = kMissingM / kSoonestS;
  const double size = std::abs(duty);
  const double mps = std::max(0.0, duty < 0.0 ? -track_mps : track_mps);
  turning_ = std::max(std::min(load.turning, kFullTurning), turning_ - kTurningFallPerS * dt_s);
  obstacle_s_ = load.on_obstacle ? kObstacleS : std::max(0.0, obstacle_s_ - dt_s);
  slow_mps_ += (mps - slow_mps_) * std::min(1.0, dt_s / kSlowS);
  if (size <= motor_.dead_band || motor_.feed_forward <= 0.0) {
    missing_m_ = drained(missing_m_, kMaxMps * dt_s);
    return false;
  }
  const double above = size - motor_.dead_band;
  const double beyond_mps = std::max(0.0, mps - kBeyond * learned_mps_);
  const double usual = motor_.feed_forward * (gain_ * (mps - beyond_mps) + kMaxGain * beyond_mps);
  const double turn = turn_duty(turning_);
  const double margin = kMarginDuty + kMarginShare * usual + turn +
                        kDutyPerSlopeRad * std::abs(load.pitch_rad) +
                        (obstacle_s_ > 0.0 ? kObstacleDuty : 0.0);
  const double unexplained = above - usual - margin;
  const double missing_mps = std::min(unexplained / motor_.feed_forward, kMaxMps);
  if (missing_mps < 0.0)
    missing_m_ = drained(missing_m_, -missing_mps * dt_s);
  else
    missing_m_ += std::copysign(missing_mps, duty) * dt_s;
  learn(above, mps, turn, load, dt_s);
  return std::abs(missing_m_) > kMissingM;
}

void DutyMonitor::learn(double above_dead_band, double track_mps, double turn_duty,
                        const Load& load, double dt_s) {
  const bool free =
      turning_ < kStraight && std::abs(load.pitch_rad) < kLevelRad && obstacle_s_ <= 0.0;
  const bool even =
      track_mps > kMinMps && track_mps > kSlowest * slow_mps_ && track_mps < kFastest * slow_mps_;
  if (!free || !even) return;
  const auto gain_at = [&](double duty) {
    return std::clamp(duty / (motor_.feed_forward * track_mps), kMinGain, kMaxGain);
  };
  // A small turn loads one track and relieves the other: such samples do not update the gain.
  const double gain =
      std::clamp(gain_, gain_at(above_dead_band - turn_duty), gain_at(above_dead_band + turn_duty));
  const double towards = std::min(1.0, dt_s / kGainDownS);
  if (gain < gain_) {
    gain_ += (gain - gain_) * towards;
    learned_mps_ += (track_mps - learned_mps_) * towards;
  } else if (track_mps > kBeyond * learned_mps_) {
    const double before_mps = learned_mps_;
    learned_mps_ += (track_mps - learned_mps_) * towards;
    gain_ = gain + (gain_ - gain) * before_mps / learned_mps_;
  } else {
    gain_ += std::min(gain - gain_, kGainUpPerS * dt_s);
  }
}

bool TurnBalance::update(double gyro_radps, double encoder_radps, double track_mps,
                         bool on_obstacle, double dt_s) {
  const double share = slip_share_ + (on_obstacle ? kObstacleShare : 0.0);
  const double difference = gyro_radps - encoder_radps;
  const double slip_rad =
      share * (std::abs(gyro_radps) + kDistanceShare * track_mps / wheelbase_m_) * dt_s;
  all_rad_ = drained(all_rad_ + difference * dt_s, slip_rad);
  slow_rad_ = drained(slow_rad_ + std::clamp(difference, -kSlowRadps, kSlowRadps) * dt_s, slip_rad);
  return std::abs(all_rad_) > kMaxRad || std::abs(slow_rad_) > kMaxSlowRad;
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
