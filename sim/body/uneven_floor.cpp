#include "sim/body/uneven_floor.h"

#include <cmath>
#include <numbers>

#include "sim/body/seed.h"

namespace tp100::sim {
namespace {

/// In [0, 1).
double uniform(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

/// Nearly normal, mean 0 and variance 1, never beyond 3.5: the sum of four uniform numbers.
double normal(std::uint64_t bits) {
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) sum += static_cast<double>((bits >> (16 * i)) & 0xFFFF);
  constexpr double kMean = 2.0 * 65535.0;
  constexpr double kSd = 65536.0 * 0.57735026918962576;  // sqrt(4 / 12)
  return (sum - kMean) / kSd;
}

double lattice_normal(std::uint64_t seed, double i, double j) {
  const auto row = static_cast<std::uint64_t>(static_cast<std::int64_t>(i));
  const auto column = static_cast<std::uint64_t>(static_cast<std::int64_t>(j));
  return normal(numbered(numbered(seed, row), column));
}

/// From 0 to 1 without a kink at either end.
double smooth(double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

/// Interpolated between the four corners around; the variance is 1 everywhere.
double smooth_field(std::uint64_t seed, double u, double v) {
  const double i = std::floor(u), j = std::floor(v);
  const double a = smooth(u - i), b = smooth(v - j);
  const double w00 = (1.0 - a) * (1.0 - b), w10 = a * (1.0 - b), w01 = (1.0 - a) * b, w11 = a * b;
  const double sum = w00 * lattice_normal(seed, i, j) + w10 * lattice_normal(seed, i + 1.0, j) +
                     w01 * lattice_normal(seed, i, j + 1.0) +
                     w11 * lattice_normal(seed, i + 1.0, j + 1.0);
  return sum / std::sqrt(w00 * w00 + w10 * w10 + w01 * w01 + w11 * w11);
}

enum Stream : std::uint64_t {
  kAngle,
  kOriginX,
  kOriginY,
  kFriction,
  kSlip,
  kFrictionTiles,
  kSlipTiles,
  kTensionLeft,
  kTensionRight,
  kForward,
  kLeft,
  kBattery,
  kPlacedX,
  kPlacedY,
  kPlacedYaw,
  kGyroScale,
  kGyroDrift,
};

constexpr double kLeastFriction = 0.1;  // as share of the mean

}  // namespace

UnevenFloor::UnevenFloor(const course::Emulated& values, std::uint64_t seed) : seed_(seed) {
  if (values.floor == course::Floor::kEven) return;
  variation_ = values.variation;
  const double angle_rad = 2.0 * std::numbers::pi * uniform(numbered(seed, kAngle));
  cos_ = std::cos(angle_rad);
  sin_ = std::sin(angle_rad);
  const double side_m = std::fmax(variation_->correlation_m, variation_->tile_m);
  origin_x_m_ = side_m * uniform(numbered(seed, kOriginX));
  origin_y_m_ = side_m * uniform(numbered(seed, kOriginY));
}

FloorVariation UnevenFloor::at(double x_m, double y_m) const {
  if (!variation_) return {};
  const double u_m = cos_ * x_m + sin_ * y_m + origin_x_m_;
  const double v_m = cos_ * y_m - sin_ * x_m + origin_y_m_;
  const auto field = [&](double sd, Stream stream, Stream tiles) {
    if (sd <= 0.0) return 0.0;
    const double length_m = variation_->correlation_m, tile_m = variation_->tile_m;
    const double between = smooth_field(numbered(seed_, stream), u_m / length_m, v_m / length_m);
    if (tile_m <= 0.0) return sd * between;
    const double tile =
        lattice_normal(numbered(seed_, tiles), std::floor(u_m / tile_m), std::floor(v_m / tile_m));
    return sd * std::numbers::sqrt2 / 2.0 * (between + tile);
  };
  return {.friction_factor = std::fmax(
              1.0 + field(variation_->friction_sd, kFriction, kFrictionTiles), kLeastFriction),
          .slip_offset = field(variation_->slip_sd, kSlip, kSlipTiles)};
}

course::Emulated sampled(const course::Emulated& values, std::uint64_t seed) {
  course::Emulated robot = values;
  if (values.floor == course::Floor::kEven) return robot;
  const course::EmulatedVariation& variation = values.variation;
  const auto sample = [&](double sd, Stream stream) { return sd * normal(numbered(seed, stream)); };
  robot.body.track_deficit_left += sample(variation.tension_sd, kTensionLeft);
  robot.body.track_deficit_right += sample(variation.tension_sd, kTensionRight);
  robot.body.com_forward_m += sample(variation.payload_sd_m, kForward);
  robot.body.com_left_m += sample(variation.payload_sd_m, kLeft);
  robot.battery.full_v -= std::abs(sample(variation.battery_sd_v, kBattery));
  robot.imu.gyro_scale_error += sample(variation.gyro_scale_sd, kGyroScale);
  robot.imu.gyro_bias_per_degc += sample(variation.gyro_drift_sd_radps_per_degc, kGyroDrift);
  return robot;
}

Pose placed(const Pose& start, const course::Emulated& values, std::uint64_t seed) {
  if (values.floor == course::Floor::kEven) return start;
  Pose pose = start;
  const course::EmulatedVariation& variation = values.variation;
  pose.x_m += variation.placed_sd_m * normal(numbered(seed, kPlacedX));
  pose.y_m += variation.placed_sd_m * normal(numbered(seed, kPlacedY));
  pose.yaw_rad += variation.placed_sd_rad * normal(numbered(seed, kPlacedYaw));
  return pose;
}

}  // namespace tp100::sim
