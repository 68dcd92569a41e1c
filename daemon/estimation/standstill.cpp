#include "estimation/standstill.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace tp100::estimation {
namespace {

// The sensor's zero-rate offset is at most 20 deg/s (MPU6050 data sheet rev 3.4, 6.1), with some
// room for temperature: anything faster is a turn.
constexpr double kMaxBiasRadps = 0.45;
// Noise of one sample at rest, and of the mean over the first window with the drift of the warm-up.
constexpr double kSampleSdRadps = 0.003;
constexpr double kWindowSdRadps = 0.0005;

}  // namespace

void Standstill::begin_window(const Sample& sample, double gyro_z_radps) {
  started_ = true;
  still_ = false;
  left_counts_ = sample.left_counts;
  right_counts_ = sample.right_counts;
  window_start_us_ = sample.device_us;
  window_size_ = 1;
  window_mean_ = gyro_z_radps;
  window_squares_ = 0.0;
}

void Standstill::update(const Sample& sample, double gyro_z_radps) {
  const double dt_s = static_cast<double>(sample.device_us - last_us_) * 1e-6;
  last_us_ = sample.device_us;
  rest_.reset();
  // A track may turn before its encoder's first edge.
  const bool driven = sample.left_duty != 0.0 || sample.right_duty != 0.0;
  const bool moved = driven || std::abs(sample.left_counts - left_counts_) > kStandstillCounts ||
                     std::abs(sample.right_counts - right_counts_) > kStandstillCounts;
  if (!started_ || moved || sample.imu_age != 0) {
    begin_window(sample, gyro_z_radps);
    return;
  }
  // Welford's running mean and variance.
  ++window_size_;
  const double difference = gyro_z_radps - window_mean_;
  window_mean_ += difference / static_cast<double>(window_size_);
  window_squares_ += difference * (gyro_z_radps - window_mean_);
  const double sd = std::sqrt(window_squares_ / static_cast<double>(window_size_));
  const bool quiet = std::abs(window_mean_) <= kMaxBiasRadps &&
                     sd < parameters_.still_gyro_sd_radps &&
                     std::abs(difference) < 6.0 * parameters_.still_gyro_sd_radps;
  if (!quiet) {
    begin_window(sample, gyro_z_radps);
    return;
  }
  const double window_s = static_cast<double>(sample.device_us - window_start_us_) * 1e-6;
  if (window_s < parameters_.still_s) return;
  rest_ = still_ ? RestRate{gyro_z_radps, kSampleSdRadps} : RestRate{window_mean_, kWindowSdRadps};
  still_ = true;
  if (!bias_known_) {
    bias_radps_ = window_mean_;
    bias_known_ = true;
    return;
  }
  bias_radps_ += (gyro_z_radps - bias_radps_) * std::min(1.0, dt_s / parameters_.bias_time_s);
}

}  // namespace tp100::estimation
