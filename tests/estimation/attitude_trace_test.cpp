// Golden traces of what the IMU shows: attitude, slope, obstacle and standstill.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "core/arithmetic.h"
#include "estimation/attitude.h"
#include "estimation/standstill.h"
#include "trace_rows.h"

namespace tp100::estimation {
namespace {

void add(TraceRows& rows, const AttitudeFilter& filter) {
  rows.add("roll", filter.roll_rad());
  rows.add("pitch", filter.pitch_rad());
  rows.add("pitch_rate", filter.pitch_rate_radps());
  rows.add("yaw_rate", filter.yaw_rate_radps(0.7));
  const CarriedAttitude carried = filter.carried();
  rows.add("levelled", carried.levelled_s);
  for (std::size_t i = 0; i < 3; ++i) {
    rows.add("gyro" + std::to_string(i), carried.gyro_offset_radps[i]);
    rows.add("accel" + std::to_string(i), carried.accel_offset_mps2[i]);
  }
  rows.end_row();
}

/// What an accelerometer with offsets reads on a body with these angles; `share` of gravity.
AttitudeFilter::Vector felt(double roll_rad, double pitch_rad, double share = 1.0) {
  const double g = kStandardGravityMps2 * share;
  return {0.21 - g * std::sin(pitch_rad), -0.17 + g * std::sin(roll_rad) * std::cos(pitch_rad),
          0.11 + g * std::cos(roll_rad) * std::cos(pitch_rad)};
}

TEST(AttitudeTrace, ATiltingBodyKeepsItsAngles) {
  AttitudeFilter filter(AttitudeParameters{});
  TraceRows rows;
  for (int i = 0; i < 60; ++i)
    filter.level({0.02 + 0.001 * (i % 3), -0.03, 0.01}, felt(0.0, 0.0), 0.0103);
  add(rows, filter);
  for (int i = 0; i < 1200; ++i) {
    const double t_s = 0.0103 * i;
    const double roll = 0.6 * std::sin(1.3 * t_s), pitch = 0.8 * std::sin(0.9 * t_s + 0.4);
    // Jolts that reach from 0.8 to 1.2 of gravity.
    const double share = i % 5 == 0 ? 1.0 + 0.2 * std::sin(0.37 * i) : 1.0;
    filter.update({0.02 + 0.78 * std::cos(1.3 * t_s), -0.03 + 0.72 * std::cos(0.9 * t_s + 0.4),
                   0.01 + 0.5 * std::sin(0.5 * t_s)},
                  felt(roll, pitch, share), 0.0103);
    if (i == 700) filter.resume(filter.carried());
    if (i % 10 == 0 || i == 700) add(rows, filter);
  }
  // Over the vertical.
  for (int i = 0; i < 90; ++i) {
    filter.update({0.0, 1.9, 0.0}, {0.0, 0.0, 0.0}, 0.0203);
    add(rows, filter);
  }
  EXPECT_EQ(rows.difference("attitude.csv"), "");
}

TEST(AttitudeTrace, ALevelKeepsBeingLearnedUpToItsBounds) {
  TraceRows rows;
  for (int i = -25; i <= 25; ++i) {
    for (const bool levelled : {false, true}) {
      for (const std::size_t axis : {0UL, 1UL}) {
        AttitudeFilter filter(AttitudeParameters{});
        // The least time after which the gyro counts is 0.2 s.
        for (int k = 0; k < (levelled ? 30 : 17) + i / 5; ++k)
          filter.level({0.006, -0.009, 0.004}, {0.0, 0.0, kStandardGravityMps2}, 0.0103);
        AttitudeFilter::Vector gyro{0.01, 0.02, 0.03};
        gyro[axis] = levelled || i % 2 == 0 ? 0.0041 * i : 0.2;
        const double tilt = i % 2 == 0 ? 0.0 : 0.0067 * i;
        AttitudeFilter::Vector accel{0.0, 0.0, 9.9};
        accel[axis] = 9.9 * std::tan(tilt);
        filter.level(gyro, accel, 0.05);
        filter.level(gyro, accel, 0.0);
        filter.level(gyro, accel, -0.01);
        rows.add("levelled", filter.carried().levelled_s);
        for (std::size_t k = 0; k < 3; ++k) {
          rows.add("gyro" + std::to_string(k), filter.carried().gyro_offset_radps[k]);
          rows.add("accel" + std::to_string(k), filter.carried().accel_offset_mps2[k]);
        }
        rows.end_row();
      }
    }
  }
  // Long enough that old readings are forgotten.
  AttitudeFilter filter(AttitudeParameters{});
  for (int i = 0; i < 800; ++i) {
    filter.level({0.01 + 1e-5 * i, 0.02, 0.03 - 1e-5 * i}, {0.1, 1e-4 * i, 9.9}, 0.0103);
    if (i % 20 != 0) continue;
    rows.add("levelled", filter.carried().levelled_s);
    for (std::size_t k = 0; k < 3; ++k) {
      rows.add("gyro" + std::to_string(k), filter.carried().gyro_offset_radps[k]);
      rows.add("accel" + std::to_string(k), filter.carried().accel_offset_mps2[k]);
    }
    rows.end_row();
  }
  EXPECT_EQ(rows.difference("attitude_level.csv"), "");
}

TEST(AttitudeTrace, SlopesKeepBeginningAndEndingWhereTheyDo) {
  TraceRows rows;
  SlopeState slope(AttitudeParameters{});
  for (int i = 0; i < 2600; ++i) {
    // Waves that grow from nothing to 10 deg, and shorter ones on them.
    const double pitch_rad = kRadPerDeg * (0.004 * i * std::sin(0.051 * i) +
                                           (i % 2 == 0 ? 0.0 : 1.5 * std::sin(0.0031 * i)));
    const Slope before = slope.state();
    if (slope.update(pitch_rad, 0.0053 + 0.000001 * i) == before) continue;
    rows.add("step", i);
    rows.add("slope", static_cast<double>(slope.state()));
    rows.end_row();
  }
  EXPECT_EQ(rows.difference("slope.csv"), "");
}

/// A body whose front end climbs a line of one slope and, from some distance on, one of another;
/// then it stays tilted, comes back to the level and may descend.
class Body {
 public:
  double first_deg, second_deg, second_from_m, steepest_deg, top_m;
  bool descends;

  double nose_up_rad(double m) const {
    constexpr double kLengthM = 0.133, kTiltedM = 0.05;
    const double first = std::sin(first_deg * kRadPerDeg);
    const double second = std::sin(second_deg * kRadPerDeg);
    const double sine =
        (first * std::min(m, second_from_m) + second * std::max(m - second_from_m, 0.0)) / kLengthM;
    const double steepest = std::sin(steepest_deg * kRadPerDeg);
    const double risen_m =
        second_from_m + std::max(0.0, steepest * kLengthM - first * second_from_m) / second;
    if (m < risen_m + kTiltedM) return std::asin(std::min(sine, steepest));
    if (descends && m > risen_m + top_m && m < risen_m + top_m + 0.1)
      return -steepest_deg * kRadPerDeg;
    return 0.004 * std::sin(90.0 * m);
  }
};

TEST(AttitudeTrace, ObstaclesKeepTheirClasses) {
  TraceRows rows;
  Draws draws(37);
  ObstacleState obstacle(0.133);
  for (int i = 0; i < 110; ++i) {
    if (i % 11 == 10) obstacle.restart();
    SlopeState slope(AttitudeParameters{});
    const Body body{.first_deg = i < 55 ? 26.0 + 0.3 * i : 25.0,
                    .second_deg = i < 55 ? 26.0 + 0.3 * i : 50.0,
                    .second_from_m = i < 55 ? 0.0 : 0.02 + 0.001 * (i - 55),
                    .steepest_deg = i < 55 ? 8.0 + i % 20 : 26.0,
                    .top_m = draws.uniform(0.15, 1.25),
                    .descends = i % 4 != 0};
    const double step_m = draws.sign() * draws.uniform(0.0003, 0.0021);
    for (double m = 0.0; m < 1.5; m += std::abs(step_m)) {
      const double pitch_rad = -body.nose_up_rad(m);
      const ObstacleClass before = obstacle.state();
      const ObstacleClass now = obstacle.update(pitch_rad, slope.update(pitch_rad, 0.03), step_m);
      if (now == before && obstacle.state() == before) continue;
      rows.add("obstacle", i);
      rows.add("m", m);
      rows.add("class", static_cast<double>(now));
      rows.end_row();
    }
  }
  // A robot that is switched on while it is tilted.
  obstacle.restart();
  for (int i = 0; i < 60; ++i) {
    const Slope side = i < 3 ? Slope::kFlat : Slope::kUp;
    rows.add("obstacle", -1);
    rows.add("m", i);
    rows.add("class", static_cast<double>(obstacle.update(-0.17, side, 0.0011)));
    rows.end_row();
  }
  EXPECT_EQ(rows.difference("obstacle.csv"), "");
}

TEST(StandstillTrace, RestsOfEveryKindKeepTheirRates) {
  Standstill standstill{Parameters{}};
  TraceRows rows;
  Sample sample;
  for (int i = 0; i < 9000; ++i) {
    const int scene = i / 300, at = i % 300;
    sample.device_us += scene == 2 && at == 200 ? 3000000 : 5003;
    sample.imu_age = scene == 3 && at % 170 == 120 ? 1 : 0;
    sample.left_duty = scene == 4 && at == 150 ? 0.1 : 0.0;
    sample.right_duty = scene == 4 && at == 180 ? -0.1 : 0.0;
    if (scene == 5 && at % 60 == 0) ++sample.left_counts;
    if (scene == 6 && at % 60 == 0) --sample.right_counts;
    if (scene == 6 && at % 60 == 30) --sample.left_counts;
    if (scene == 7 && at < 100) sample.left_counts += at % 3;
    if (scene >= 10 && scene < 18 && at == 0) sample.left_counts += 5;
    if (scene == 8 && at == 120) standstill.restart();
    if (scene == 9 && at == 150) standstill.resume(0.05, true);
    double rate = 0.02 + 0.0004 * scene + 0.003 * std::sin(2.1 * i);
    if (scene >= 10 && scene < 18)  // noisier and noisier
      rate += (scene - 9) * 0.0021 * std::sin(1.7 * i);
    if (scene >= 18 && scene < 24 && at == 140)  // jolts to either side
      rate += (scene % 2 == 0 ? 0.031 : -0.031) * ((scene - 16) / 2);
    if (scene >= 24) rate = (scene % 2 == 0 ? 1.0 : -1.0) * (0.43 + 0.006 * (scene - 24));
    standstill.update(sample, rate);
    if (i % 15 != 10) continue;
    rows.add("still", standstill.still());
    rows.add("rest", standstill.rest() ? standstill.rest()->radps : -1.0);
    rows.add("sd", standstill.rest() ? standstill.rest()->sd_radps : -1.0);
    rows.add("known", standstill.bias_known());
    rows.add("bias", standstill.bias_radps());
    rows.end_row();
  }
  EXPECT_EQ(rows.difference("standstill.csv"), "");
}

}  // namespace
}  // namespace tp100::estimation
