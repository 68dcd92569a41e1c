#include "yaw_loop.h"

#include "shared/number.h"
#include "shared/skid_steer.h"

namespace tp100 {
namespace firmware {
namespace {

using shared::clamp;
using shared::wrapped_difference;

// Samples over which the mean speed is taken.
const uint8_t kWindow = 8;

const uint32_t kTimeUnits = 0x1FFFFFFFUL;  // micros() in units of 8 us wraps here
const float kSecondsPerUnit = 8e-6f;

}  // namespace

void TurnHistory::add(uint16_t sequence, uint32_t device_us, int16_t gyro_z, int32_t left_counts,
                      int32_t right_counts) {
  // Differences are taken of the divided times, so that no remainder is lost between samples.
  const uint32_t units = ((device_us >> 3) - (newest_.device_us >> 3)) & kTimeUnits;
  const int32_t mean_twice = static_cast<int32_t>(gyro_z) + last_gyro_z_;
  // A first sample, or one after a long gap, has no interval to integrate over.
  const int32_t turned = size_ == 0 ? 0 : mean_twice * static_cast<int32_t>(units & 0x7FFF) / 2;
  last_gyro_z_ = gyro_z;
  newest_.gyro += static_cast<uint32_t>(turned);
  newest_.device_us = device_us;
  newest_.left_counts = left_counts;
  newest_.right_counts = right_counts;
  last_sequence_ = sequence;
  marks_[sequence % kCapacity] = newest_;
  if (size_ < kCapacity) ++size_;
}

const TurnMark* TurnHistory::find(uint16_t sequence) const {
  const uint16_t back = static_cast<uint16_t>(last_sequence_ - sequence);
  return back < size_ ? &marks_[sequence % kCapacity] : nullptr;
}

const TurnMark& TurnHistory::ago(uint8_t samples) const {
  const uint8_t back = samples < size_ ? samples : static_cast<uint8_t>(size_ - 1);
  return marks_[static_cast<uint16_t>(last_sequence_ - back) % kCapacity];
}

TrackMotion TurnHistory::motion(float metres_per_count) const {
  TrackMotion motion = {};
  if (size_ == 0) return motion;
  const TurnMark& before = ago(1);
  const TurnMark& then = ago(kWindow);
  motion.left_m = static_cast<float>(wrapped_difference(newest_.left_counts, before.left_counts)) *
                  metres_per_count;
  motion.right_m =
      static_cast<float>(wrapped_difference(newest_.right_counts, before.right_counts)) *
      metres_per_count;
  const int32_t window_us = wrapped_difference(newest_.device_us, then.device_us);
  if (window_us <= 0) return motion;
  const float mps_per_count = metres_per_count * 1e6f / static_cast<float>(window_us);
  motion.speeds.left =
      static_cast<float>(wrapped_difference(newest_.left_counts, then.left_counts)) * mps_per_count;
  motion.speeds.right =
      static_cast<float>(wrapped_difference(newest_.right_counts, then.right_counts)) *
      mps_per_count;
  return motion;
}

float turned(const TurnMark& then, const TurnMark& now, bool use_gyro, float gyro_bias_radps,
             const wire::Parameters& p) {
  if (use_gyro) {
    const float raw = static_cast<float>(wrapped_difference(now.gyro, then.gyro)) * kSecondsPerUnit;
    const float elapsed_s =
        static_cast<float>(wrapped_difference(now.device_us, then.device_us)) * 1e-6f;
    return raw * p.gyro_z_radps_per_lsb - gyro_bias_radps * elapsed_s;
  }
  const float left = static_cast<float>(wrapped_difference(now.left_counts, then.left_counts));
  const float right = static_cast<float>(wrapped_difference(now.right_counts, then.right_counts));
  return shared::turn_of(shared::over_ground(left, right, p.slip_left, p.slip_right),
                         p.counts_per_metre * p.wheelbase_m);
}

float turn_rate(float error_rad, float feed_forward_radps, const wire::Parameters& p) {
  return clamp(feed_forward_radps + p.yaw_kp * shared::wrap_angle(error_rad), p.max_yaw_radps);
}

TrackSpeeds approach(const TrackSpeeds& from, const TrackSpeeds& to, float step) {
  const TrackSpeeds result = {from.left + clamp(to.left - from.left, step),
                              from.right + clamp(to.right - from.right, step)};
  return result;
}

}  // namespace firmware
}  // namespace tp100
