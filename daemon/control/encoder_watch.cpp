#include "control/encoder_watch.h"

#include <algorithm>
#include <cmath>

#include "core/belt_speed.h"

namespace tp100::control {
namespace {

// Duty that a track may take beyond what it usually does: always, in a turn that scrubs its belt
// over the floor, on a slope, and with all the load that traction can put on it.
constexpr double kMarginDuty = 0.02;
constexpr double kMarginShare = 0.1;
constexpr double kTurningDuty = 0.4;
constexpr double kFullTurning = 0.4;
constexpr double kDutyPerSlopeRad = 0.8;
constexpr double kObstacleDuty = 0.4;
constexpr double kObstacleS = 1.0;
// A load goes slower than it comes.
constexpr double kTurningFallPerS = 0.5;

// A gain is learnt from a track that runs evenly and freely, not from one that brakes; quickly
// downwards, and upwards only as a battery sags, or a fault would be learnt.
constexpr double kLeastGain = 0.7;
constexpr double kGainDownS = 0.3;
constexpr double kGainUpPerS = 0.005;
constexpr double kSlowS = 0.2;
constexpr double kSlowest = 0.95, kFastest = 1.1;
// At a creep, duty and speed are mostly noise and lag that is worked off.
constexpr double kLeastMps = 0.028;
constexpr double kStraight = 0.05;
constexpr double kLevelRad = 0.03;

// Slip takes some of the way of one track too, in parts of what it may take of a turn.
constexpr double kOfWay = 0.8;
// One track may stand on a block while the other slips.
constexpr double kObstacleShare = 0.25;
// A push is faster.
constexpr double kSlowRadps = 10.0 * kRadPerDeg;

double drained(double balance_rad, double by_rad) {
  return std::copysign(std::max(0.0, std::abs(balance_rad) - by_rad), balance_rad);
}

}  // namespace

bool DutyWatch::update(double duty, double track_mps, const Load& load, double dt_s) {
  constexpr double kMostMps = kMissingM / kSoonestS;
  const double size = std::abs(duty);
  const double mps = std::max(0.0, duty < 0.0 ? -track_mps : track_mps);
  turning_ = std::max(std::min(load.turning, kFullTurning), turning_ - kTurningFallPerS * dt_s);
  obstacle_s_ = load.on_obstacle ? kObstacleS : std::max(0.0, obstacle_s_ - dt_s);
  slow_mps_ += (mps - slow_mps_) * std::min(1.0, dt_s / kSlowS);
  if (size <= motor_.dead_band || motor_.feed_forward <= 0.0) {
    missing_m_ = std::max(0.0, missing_m_ - kMostMps * dt_s);
    return false;
  }
  const double above = size - motor_.dead_band;
  const double usual = gain_ * motor_.feed_forward * mps;
  const double margin =
      kMarginDuty + kMarginShare * usual + kTurningDuty * turning_ / kFullTurning +
      kDutyPerSlopeRad * std::abs(load.pitch_rad) + (obstacle_s_ > 0.0 ? kObstacleDuty : 0.0);
  const double unexplained = above - usual - margin;
  missing_m_ =
      std::max(0.0, missing_m_ + std::min(unexplained / motor_.feed_forward, kMostMps) * dt_s);
  learn(above, mps, load, dt_s);
  return missing_m_ > kMissingM;
}

void DutyWatch::learn(double above_dead_band, double track_mps, const Load& load, double dt_s) {
  const bool free =
      turning_ < kStraight && std::abs(load.pitch_rad) < kLevelRad && obstacle_s_ <= 0.0;
  const bool even =
      track_mps > kLeastMps && track_mps > kSlowest * slow_mps_ && track_mps < kFastest * slow_mps_;
  if (!free || !even) return;
  const double gain =
      std::clamp(above_dead_band / (motor_.feed_forward * track_mps), kLeastGain, kMostGain);
  gain_ += gain < gain_ ? (gain - gain_) * std::min(1.0, dt_s / kGainDownS)
                        : std::min(gain - gain_, kGainUpPerS * dt_s);
}

bool TurnBalance::update(double gyro_radps, double encoder_radps, double track_mps,
                         bool on_obstacle, double dt_s) {
  const double share = slip_share_ + (on_obstacle ? kObstacleShare : 0.0);
  const double difference = gyro_radps - encoder_radps;
  const double slip_rad = share * (std::abs(gyro_radps) + kOfWay * track_mps / wheelbase_m_) * dt_s;
  all_rad_ = drained(all_rad_ + difference * dt_s, slip_rad);
  slow_rad_ = drained(slow_rad_ + std::clamp(difference, -kSlowRadps, kSlowRadps) * dt_s, slip_rad);
  return std::abs(all_rad_) > kMostRad || std::abs(slow_rad_) > kMostSlowRad;
}

bool JumpWatch::update(const Sample& sample) {
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

}  // namespace tp100::control
