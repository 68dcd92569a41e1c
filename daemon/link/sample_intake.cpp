#include "link/sample_intake.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/arithmetic.h"
#include "shared/number.h"

namespace tp100::link {
namespace {

const double kGyroRadpsPerLsb = kRadPerDeg / static_cast<double>(wire::kGyroLsbPerDegps);
const double kAccelMps2PerLsb = kStandardGravityMps2 / static_cast<double>(wire::kAccelLsbPerG);
// A sample cannot have been measured after it was read; this tolerance allows for the clock
// relation.
constexpr HostNs kFutureNs = 50 * kNsPerMs;
constexpr std::uint64_t kNewest = 1;

// After a longer gap it is unknown whether the track continued.
constexpr double kLongestHoldS = 0.1;

bool values_plausible(const wire::Sample& sample) {
  return sample.state <= static_cast<std::uint8_t>(wire::State::kFaulted) &&
         std::abs(int{sample.left_duty}) <= wire::kFullDuty &&
         std::abs(int{sample.right_duty}) <= wire::kFullDuty;
}

}  // namespace

bool EncoderCount::update(std::int32_t value, DeviceUs elapsed_us) {
  if (!known_) {
    *this = EncoderCount(max_per_s_);
    known_ = true;
    counts_ = last_ = value;
    return true;
  }
  const std::int32_t step = shared::wrapped_difference(value, last_);
  last_ = value;
  const double dt_s = static_cast<double>(elapsed_us) * 1e-6;
  jumps_.pass(static_cast<std::uint32_t>(std::clamp<DeviceUs>(elapsed_us, 0, 1'000'000)));
  if (counts_possible(step, max_per_s_, dt_s)) {
    held_in_row_ = 0;
  } else if (held_in_row_ < kHeldInRow && !jumps_.again()) {
    ++held_in_row_;
    if (dt_s <= kLongestHoldS) counts_ += std::llround(per_s_ * dt_s);
    return false;
  }
  counts_ += step;
  if (dt_s > 0.0) per_s_ = static_cast<double>(step) / dt_s;
  return true;
}

void SampleIntake::begin(bool new_boot) {
  started_ = false;
  if (new_boot) {
    left_.forget();
    right_.forget();
  }
  refused_in_row_ = 0;
  count_ = 0;
  dropped_ = 0;
}

bool SampleIntake::in_order(std::uint16_t sequence, DeviceUs device_us, std::uint32_t& missing) {
  missing = 0;
  if (!started_) return true;
  const std::int16_t ahead = shared::wrapped_difference(sequence, last_sequence_);
  if (ahead <= 0) {
    const unsigned back = static_cast<unsigned>(-int{ahead});
    const std::uint64_t bit = back < 64 ? kNewest << back : 0;
    if (bit != 0 && (seen_ & bit) == 0) {
      seen_ |= bit;
      ++counters_.reordered;
      if (counters_.lost > 0) --counters_.lost;
    } else if (bit != 0) {
      ++counters_.duplicated;
    } else {
      ++counters_.reordered;
    }
    return false;
  }
  if (device_us <= last_device_us_) {
    ++counters_.implausible;
    return false;
  }
  missing = static_cast<std::uint32_t>(ahead - 1);
  return true;
}

void SampleIntake::count(const wire::Sample& wire, DeviceUs device_us) {
  const bool left = left_.update(wire.left_counts, device_us - last_device_us_);
  const bool right = right_.update(wire.right_counts, device_us - last_device_us_);
  if (!left || !right) ++counters_.implausible;
}

bool SampleIntake::push(const wire::Sample& wire, DeviceUs device_us, const ClockState& clock,
                        HostNs now) {
  std::uint32_t missing = 0;
  const HostNs measured_ns = clock.valid ? clock.to_host(device_us) : 0;
  if (!values_plausible(wire) || (clock.valid && measured_ns > now + kFutureNs)) {
    ++counters_.implausible;
    ++refused_in_row_;
    return false;
  }
  if (!in_order(wire.sequence, device_us, missing)) {
    ++refused_in_row_;
    return false;
  }
  refused_in_row_ = 0;

  const unsigned ahead = missing + 1;
  seen_ = started_ && ahead < 64 ? (seen_ << ahead) | kNewest
                                 : (started_ ? kNewest : ~std::uint64_t{0});
  started_ = true;
  last_sequence_ = wire.sequence;
  count(wire, device_us);
  last_device_us_ = device_us;
  counters_.lost += missing;
  dropped_ += missing;

  if (!clock.valid) {
    ++counters_.early;
    dropped_ = 0;
    return true;
  }
  Sample sample;
  sample.sequence = wire.sequence;
  sample.left_counts = left_.counts();
  sample.right_counts = right_.counts();
  sample.lost_before = dropped_;
  sample.device_us = device_us;
  sample.measured_ns = measured_ns;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sample.gyro_radps[axis] = wire.gyro[axis] * kGyroRadpsPerLsb;
    sample.accel_mps2[axis] = wire.accel[axis] * kAccelMps2PerLsb;
  }
  sample.temperature_degc = wire.temperature / static_cast<double>(wire::kTemperatureLsbPerDegc) +
                            static_cast<double>(wire::kTemperatureOffsetDegc);
  sample.battery_v = wire.battery_mv * 1e-3;
  sample.left_duty = wire.left_duty / static_cast<double>(wire::kFullDuty);
  sample.right_duty = wire.right_duty / static_cast<double>(wire::kFullDuty);
  sample.state = static_cast<RobotState>(wire.state);
  sample.faults = wire.faults;
  sample.last_command = wire.last_command;
  sample.imu_age = wire.imu_age;
  keep(sample);
  dropped_ = 0;
  return true;
}

void SampleIntake::keep(const Sample& sample) {
  if (count_ == kCapacity) {
    const std::uint32_t gap = samples_[0].lost_before + 1;
    std::move(samples_.begin() + 1, samples_.end(), samples_.begin());
    --count_;
    samples_[0].lost_before += gap;
    ++counters_.lost;
  }
  samples_[count_++] = sample;
}

std::span<const Sample> SampleIntake::take() {
  const std::span<const Sample> result(samples_.data(), count_);
  counters_.samples += count_;
  count_ = 0;
  return result;
}

}  // namespace tp100::link
