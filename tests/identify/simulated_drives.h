#pragma once
// Drives of a simulated robot, to test identify on. Eqs 1-5 are integrated here in small steps,
// without the closed form or any code of the model under test; noise, outliers and delay are added.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/arithmetic.h"
#include "identify/identify.h"

namespace tp100::identify {

struct Truth {
  double slip_left = 0.13, slip_right = 0.17, wheelbase_m = 0.23, x_icr_m = 0.012;
  double gyro_scale = 1.02, slip_angle_rad = 0.02, late_s = 0.0;
  double noise_m = 0.0015, noise_rad = 0.4 * kRadPerDeg, outliers = 0.0;
  double counts_per_metre = 20000.0;
};

/// A drive that consists of standstill, constant track speeds and standstill again.
inline RecordedDrive simulated_drive(const Truth& truth, const std::string& name, double left_mps,
                                     double right_mps, double duration_s, unsigned seed) {
  constexpr double kStandstillS = 1.0, kStepS = 5e-4;
  constexpr int kStepsPerSample = 20, kStepsPerImage = 60;
  // Half-way between two samples, so that the sum of the rates is the angle.
  constexpr double kBeginsS = kStandstillS + kStepS * kStepsPerSample / 2;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const double bias = 0.02 * normal(random);
  RecordedDrive drive;
  drive.name = name;
  double x = 0.3 * uniform(random), y = 0.3 * uniform(random), yaw = 3.0 * uniform(random);
  double left_m = 0.0, right_m = 0.0;
  const auto steps = static_cast<int>((2.0 * kStandstillS + duration_s) / kStepS);
  for (int i = 0; i < steps; ++i) {
    const double t = i * kStepS;
    const bool moves = t >= kBeginsS && t < kBeginsS + duration_s;
    const double left = moves ? left_mps : 0.0, right = moves ? right_mps : 0.0;
    const double l = left * (1.0 - truth.slip_left), r = right * (1.0 - truth.slip_right);
    const double rate = (r - l) / truth.wheelbase_m, vx = (l + r) / 2.0;
    const double vy = vx * std::tan(truth.slip_angle_rad) - truth.x_icr_m * rate;
    if (i % kStepsPerSample == 0)
      drive.samples.push_back({t, std::lround(left_m * truth.counts_per_metre),
                               std::lround(right_m * truth.counts_per_metre),
                               rate / truth.gyro_scale + bias + 7e-4 * normal(random)});
    if (i % kStepsPerImage == 0) {
      SeenPose seen{t + truth.late_s, x + truth.noise_m * normal(random),
                    y + truth.noise_m * normal(random),
                    wrap_angle(yaw + truth.noise_rad * normal(random))};
      if (std::abs(uniform(random)) < truth.outliers) {
        seen.x_m += 0.3 * uniform(random);
        seen.yaw_rad = kPi * uniform(random);
      }
      drive.camera.push_back(seen);
    }
    const double middle = yaw + rate * kStepS / 2.0;
    x += (vx * std::cos(middle) - vy * std::sin(middle)) * kStepS;
    y += (vx * std::sin(middle) + vy * std::cos(middle)) * kStepS;
    yaw += rate * kStepS;
    left_m += left * kStepS;
    right_m += right * kStepS;
  }
  return drive;
}

inline std::vector<RecordedDrive> all_kinds(const Truth& truth, unsigned seed = 1) {
  std::vector<RecordedDrive> drives;
  for (int repeat = 0; repeat < 2; ++repeat) {
    drives.push_back(simulated_drive(truth, "straight", 0.117, 0.123, 12.0, ++seed));
    drives.push_back(simulated_drive(truth, "arc left", 0.09, 0.15, 10.0, ++seed));
    drives.push_back(simulated_drive(truth, "arc right", 0.15, 0.09, 10.0, ++seed));
    drives.push_back(simulated_drive(truth, "tight left", 0.06, 0.15, 8.0, ++seed));
    drives.push_back(simulated_drive(truth, "tight right", 0.15, 0.06, 8.0, ++seed));
    drives.push_back(simulated_drive(truth, "spin left", -0.1, 0.1, 8.0, ++seed));
    drives.push_back(simulated_drive(truth, "spin right", 0.1, -0.1, 8.0, ++seed));
    drives.push_back(simulated_drive(truth, "wide left", 0.123, 0.15, 12.0, ++seed));
    drives.push_back(simulated_drive(truth, "wide right", 0.15, 0.123, 12.0, ++seed));
  }
  return drives;
}

inline Prior unknown() { return {.counts_per_metre = Truth{}.counts_per_metre}; }

inline void expect_found(const Fit& fit, model::TrackParameter parameter, double truth,
                         double within) {
  SCOPED_TRACE(model::kTrackParameters[model::row_of(parameter)].key);
  EXPECT_TRUE(fit[parameter].found);
  EXPECT_NEAR(fit[parameter].value, truth, within);
  EXPECT_NEAR(fit[parameter].value, truth, 1.5 * fit[parameter].half_interval);
}

inline void expect_all_found(const Identification& found, const Truth& truth) {
  using model::TrackParameters;
  const struct {
    model::TrackParameter parameter;
    double truth, within;
  } all[] = {{&TrackParameters::slip_left, truth.slip_left, 0.003},
             {&TrackParameters::slip_right, truth.slip_right, 0.003},
             {&TrackParameters::wheelbase_m, truth.wheelbase_m, 0.01 * truth.wheelbase_m},
             {&TrackParameters::wheelbase_medium_m, truth.wheelbase_m, 0.01 * truth.wheelbase_m},
             {&TrackParameters::wheelbase_tight_m, truth.wheelbase_m, 0.01 * truth.wheelbase_m},
             {&TrackParameters::wheelbase_spin_m, truth.wheelbase_m, 0.01 * truth.wheelbase_m},
             {&TrackParameters::x_icr_m, truth.x_icr_m, 0.002},
             {&TrackParameters::gyro_scale, truth.gyro_scale, 0.004},
             {&TrackParameters::slip_angle_straight_rad, truth.slip_angle_rad, 0.3 * kRadPerDeg},
             {&TrackParameters::slip_angle_turning_rad, truth.slip_angle_rad, 0.3 * kRadPerDeg}};
  for (const auto& one : all) expect_found(found.extended, one.parameter, one.truth, one.within);
  EXPECT_TRUE(found.extended.confused.empty());
}

/// What a person measures with tape and protractor, in place of the camera's poses: from the first
/// of them to the last.
inline void measure_by_hand(RecordedDrive& drive) {
  const SeenPose a = drive.camera.front(), b = drive.camera.back();
  const double dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
  drive.measured.ahead_m = std::cos(a.yaw_rad) * dx + std::sin(a.yaw_rad) * dy;
  drive.measured.left_m = -std::sin(a.yaw_rad) * dx + std::cos(a.yaw_rad) * dy;
  double turned_rad = 0.0;
  for (std::size_t i = 1; i < drive.camera.size(); ++i)
    turned_rad += wrap_angle(drive.camera[i].yaw_rad - drive.camera[i - 1].yaw_rad);
  drive.measured.turned_rad = turned_rad;
  drive.camera.clear();
}

}  // namespace tp100::identify
