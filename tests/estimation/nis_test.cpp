#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <random>

#include "core/arithmetic.h"
#include "estimation/kalman.h"
#include "estimation/pose_filter.h"
#include "interval.h"

namespace tp100::estimation {
namespace {

constexpr int kSamplesPerWindow = 10;
constexpr int kSamplesPerFrame = 6;

/// A robot whose noise is drawn as the filter assumes it. It is an independent implementation and
/// uses none of the filter's code.
class MatchedRobot {
 public:
  MatchedRobot(const model::TrackParameters& tracks, const FilterParameters& noise,
               std::uint64_t seed)
      : tracks_(tracks), noise_(noise), random_(seed) {
    x_m = noise.start_sd_m * normal();
    y_m = noise.start_sd_m * normal();
    yaw_rad = noise.start_sd_rad * normal();
    bias_ = noise.bias_sd_radps * normal();
    common_slip_ = noise.slip_sd * normal();
    slip_difference_ = noise.slip_difference_sd * normal();
    turn_gain_ = noise.turn_gain_sd * normal();
  }

  double normal() { return normal_(random_); }

  /// One interval at `speed_mps` over the ground, turning at `rate_radps`.
  FilterInput drive(double speed_mps, double rate_radps, HostNs end_ns) {
    if (count_++ % kSamplesPerWindow == 0) {
      track_error_ =
          (noise_.residual_sd_radps + noise_.residual_share * std::abs(rate_radps)) * normal();
    }
    const double left = (1.0 - tracks_.slip_left) * (1.0 - common_slip_ - slip_difference_);
    const double right = (1.0 - tracks_.slip_right) * (1.0 - common_slip_ + slip_difference_);
    const double half =
        (rate_radps / (1.0 + turn_gain_) + track_error_) * tracks_.wheelbase_m / 2.0;
    FilterInput in;
    in.end_ns = end_ns;
    in.dt_s = kDt;
    in.tracks = {(speed_mps - half) / left, (speed_mps + half) / right};
    in.gyro_z_radps = rate_radps + bias_ + noise_.gyro_sd_rad_rts / std::sqrt(kDt) * normal();
    in.gyro = true;
    in.ground.slip = {tracks_.slip_left, tracks_.slip_right};

    const double way = speed_mps * kDt, turn = rate_radps * kDt;
    const double middle = yaw_rad + turn / 2.0;
    const double shift = noise_.turn_sd_m_rtrad * std::sqrt(std::abs(turn));
    const double along = way + noise_.along_sd_m_rtm * std::sqrt(way) * normal() + shift * normal();
    const double across = noise_.across_sd_m_rtm * std::sqrt(way) * normal() + shift * normal();
    x_m += along * std::cos(middle) - across * std::sin(middle);
    y_m += along * std::sin(middle) + across * std::cos(middle);
    yaw_rad += turn;
    bias_ += noise_.bias_walk_radps_rts * std::sqrt(kDt) * normal();
    const double kept = std::exp(-kDt / noise_.slip_s);
    common_slip_ = common_slip_ * kept + noise_.slip_sd * std::sqrt(1.0 - kept * kept) * normal();
    return in;
  }

  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;

 private:
  model::TrackParameters tracks_;
  FilterParameters noise_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  double bias_ = 0.0, common_slip_ = 0.0, slip_difference_ = 0.0, turn_gain_ = 0.0;
  double track_error_ = 0.0;
  int count_ = 0;
};

/// Half-width of the 95 % band of the mean of this many values: the sum of many chi-squared values
/// is nearly normal.
double half_band(std::uint32_t count) { return 1.96 * std::sqrt(2.0 * 3.0 / count); }

/// NIS of every camera sample, including those beyond the gate, over many runs.
NisMean monte_carlo(double camera_noise_factor) {
  model::TrackParameters tracks;
  tracks.slip_angle_straight_rad = 0.0;
  FilterParameters noise;
  noise.gyro_scale_sd = 0.0;
  // The window holds ten samples, regardless of the rounding of their sum.
  noise.residual_window_s = kDt * (kSamplesPerWindow - 0.5);
  noise.bias_sd_radps = 0.01;
  CameraParameters camera;
  camera.time_sd_s = 0.0;

  NisMean nis;
  for (std::uint64_t run = 1; run <= 40; ++run) {
    MatchedRobot robot(tracks, noise, run);
    PoseFilter filter(tracks, noise, camera, {});
    std::deque<CameraSample> under_way;
    HostNs now = kNsPerS;
    for (int i = 0; i < 3000; ++i) {
      now += kPeriod;
      const double rate = 0.4 * std::sin(i * kDt * 0.7 + static_cast<double>(run));
      filter.advance(robot.drive(0.1, rate, now));
      if (i % kSamplesPerFrame == 0) {
        const double sd_m = camera.position_sd_m * camera_noise_factor;
        under_way.push_back({robot.x_m + sd_m * robot.normal(), robot.y_m + sd_m * robot.normal(),
                             robot.yaw_rad + camera.yaw_sd_rad * robot.normal(), now});
      }
      if (!under_way.empty() && now - under_way.front().measured_ns >= 60 * kNsPerMs) {
        filter.camera(under_way.front());
        under_way.pop_front();
        nis.add(filter.figures(now).nis);
      }
    }
  }
  return nis;
}

TEST(Nis, IsOnAverageItsDegreesOfFreedomWhenAllNoiseIsAsAssumed) {
  const NisMean nis = monte_carlo(1.0);
  ASSERT_GT(nis.count(), 15000u);
  EXPECT_NEAR(nis.mean(), 3.0, half_band(nis.count()));
}

TEST(Nis, LeavesItsBandWhenTheCameraIsWorseThanAssumed) {
  const NisMean nis = monte_carlo(1.3);
  EXPECT_GT(nis.mean(), 3.0 + half_band(nis.count()));
}

}  // namespace
}  // namespace tp100::estimation
