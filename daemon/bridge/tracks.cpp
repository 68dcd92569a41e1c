#include "bridge/tracks.h"

namespace tp100::bridge {

std::optional<Interval> Tracks::update(const Sample& sample) {
  if (!has_last_) {
    has_last_ = true;
    last_ = sample;
    return std::nullopt;
  }
  if (sample.device_us <= last_.device_us) return std::nullopt;
  Interval interval;
  interval.dt_s = static_cast<double>(sample.device_us - last_.device_us) * 1e-6;
  const auto speed = [&](std::int64_t counts) {
    return static_cast<double>(counts) * metres_per_count_ / interval.dt_s;
  };
  interval.tracks.left_mps = speed(sample.left_counts - last_.left_counts);
  interval.tracks.right_mps = speed(sample.right_counts - last_.right_counts);
  interval.gyro_z_radps = (gyro_z_radps(sample) + gyro_z_radps(last_)) / 2.0;
  interval.gyro_fresh = sample.imu_age == 0 && last_.imu_age == 0;
  interval.warming_degc = sample.temperature_degc - last_.temperature_degc;
  last_ = sample;
  return interval;
}

}  // namespace tp100::bridge
