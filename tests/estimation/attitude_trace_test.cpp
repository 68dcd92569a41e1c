// Golden traces of what the IMU shows: attitude, slope, obstacle and standstill.

#include <gtest/gtest.h>

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
  for (int i = 0; i < 40; ++i) {
    filter.update({0.0, 1.9, 0.0}, {0.0, 0.0, 0.0}, 0.0203);
    add(rows, filter);
  }
  EXPECT_EQ(rows.difference("attitude_trace.csv"), "");
}

TEST(AttitudeTrace, ALevelKeepsBeingLearnedUpToItsBounds) {
  TraceRows rows;
  for (int i = -25; i <= 25; ++i) {
    for (const bool levelled : {false, true}) {
      for (const std::size_t axis : {0UL, 1UL}) {
        AttitudeFilter filter(AttitudeParameters{});
        // The least time after which the gyro counts is 0.2 s.
        for (int k = 0; k < (levelled ? 30 : 17) + i / 5; ++k)
          filter.level({0.0, 0.0, 0.0}, {0.0, 0.0, kStandardGravityMps2}, 0.0103);
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
  EXPECT_EQ(rows.difference("attitude_level_trace.csv"), "");
}

TEST(AttitudeTrace, SlopesKeepBeginningAndEndingWhereTheyDo) {
  TraceRows rows;
  SlopeState slope(AttitudeParameters{});
  for (int i = 0; i < 2600; ++i) {
    // Waves that grow from nothing to 10 deg, and shorter ones on them.
    const double pitch_rad = kRadPerDeg * (0.004 * i * std::sin(0.051 * i) +
                                           (i % 2 == 0 ? 0.0 : 1.5 * std::sin(0.0031 * i)));
    const Slope state = slope.update(pitch_rad, 0.0053 + 0.000001 * i);
    if (i % 2 != 0) continue;
    rows.add("slope", static_cast<double>(state));
    rows.end_row();
  }
  EXPECT_EQ(rows.difference("slope_trace.csv"), "");
}

/// A body that rises over `up_m` to `steepest_deg`, stays so, and comes down.
TEST(AttitudeTrace, ObstaclesKeepTheirClasses) {
  TraceRows rows;
  Draws draws(37);
  ObstacleState obstacle(0.133);
  for (int i = 0; i < 48; ++i) {
    if (i % 12 == 0) obstacle.restart();
    SlopeState slope(AttitudeParameters{});
    const double up_m = 0.03 + 0.004 * (i % 24), steepest_deg = 6.0 + 1.1 * (i % 17);
    const double step_m = draws.sign() * draws.uniform(0.0004, 0.0023);
    const double top_m = 0.3 + 0.015 * i;
    const double pace = std::abs(step_m);
    for (double m = 0.0; m < 2.0 * up_m + top_m + 0.2; m += pace) {
      double nose_up_deg = 0.5 * std::sin(90.0 * m);
      if (m < up_m)
        nose_up_deg = steepest_deg * std::sqrt(m / up_m);
      else if (m < up_m + 0.1)
        nose_up_deg = steepest_deg;
      else if (i % 3 != 0 && m > up_m + top_m && m < 2.0 * up_m + top_m)
        nose_up_deg = -steepest_deg;
      const double pitch_rad = -nose_up_deg * kRadPerDeg;
      obstacle.update(pitch_rad, slope.update(pitch_rad, 0.02), step_m);
      if (static_cast<int>(m / pace) % 16 != 0) continue;
      rows.add("class", static_cast<double>(obstacle.state()));
      rows.end_row();
    }
  }
  EXPECT_EQ(rows.difference("obstacle_trace.csv"), "");
}

TEST(StandstillTrace, RestsOfEveryKindKeepTheirRates) {
  Standstill standstill{Parameters{}};
  TraceRows rows;
  Sample sample;
  for (int i = 0; i < 9000; ++i) {
    const int scene = i / 300, at = i % 300;
    sample.device_us += 5003;
    sample.imu_age = scene == 3 && at % 170 == 120 ? 1 : 0;
    sample.left_duty = scene == 4 && at == 150 ? 0.1 : 0.0;
    sample.right_duty = scene == 4 && at == 180 ? -0.1 : 0.0;
    if (scene == 5 && at % 60 == 0) ++sample.left_counts;
    if (scene == 6 && at % 60 == 0) --sample.right_counts;
    if (scene == 7 && at < 100) sample.left_counts += at % 3;
    if (scene == 8 && at == 120) standstill.restart();
    if (scene == 9 && at == 150) standstill.resume(0.05, true);
    double rate = 0.02 + 0.0004 * scene + 0.003 * std::sin(2.1 * i);
    if (scene >= 10 && scene < 18)  // noisier and noisier
      rate += (scene - 9) * 0.0021 * std::sin(1.7 * i);
    if (scene >= 18 && scene < 24 && at == 140) rate += (scene - 17) * 0.0141;
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
  EXPECT_EQ(rows.difference("standstill_trace.csv"), "");
}

}  // namespace
}  // namespace tp100::estimation
