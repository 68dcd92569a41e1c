// The loops of speed and yaw: their arithmetic against independent computations, and an armed
// robot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "firmware/speed_loop.h"
#include "firmware/yaw_loop.h"
#include "rig.h"
#include "shared/number.h"

namespace tp100::firmware {
namespace {

using shared::clamp;
using shared::kPi;
using shared::wrap_angle;
using wire::State;

float between(std::mt19937& random, float low, float high) {
  return std::uniform_real_distribution<float>(low, high)(random);
}

TEST(WrapAngle, IsTheSameAngleWithinHalfATurn) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const float rad = between(random, -100.0f, 100.0f);
    const float wrapped = wrap_angle(rad);
    EXPECT_LE(std::abs(wrapped), kPi + 1e-5f) << rad;
    const double apart = static_cast<double>(rad) - static_cast<double>(wrapped);
    EXPECT_NEAR(std::remainder(apart, 2.0 * std::numbers::pi), 0.0, 1e-4) << rad;
  }
}

// A motor must not turn because of a value that is no number.
TEST(Loops, WhatIsNoNumberAsksForAStandstill) {
  const wire::Parameters p = test::good_parameters();
  for (const float nan : {kNan, -kNan, std::numeric_limits<float>::signaling_NaN()}) {
    EXPECT_EQ(clamp(nan, 1.0f), 0.0f);
    EXPECT_EQ(clamp(nan, 0.0f), 0.0f);
    SpeedLoop loop;
    EXPECT_EQ(loop.update(nan, 0.005f, SpeedGains(p)), 0.0f);
    EXPECT_EQ(loop.update(0.0f, nan, SpeedGains(p)), 0.0f);
  }
}

// One count of a track is this far, and so fast if it takes one sample.
constexpr float kMetresPerCount = 1.0f / 11140.0f;
constexpr float kMpsPerCount = kMetresPerCount / 0.005f;

TEST(SpeedLoop, TheDutyIsTheSumOfItsTerms) {
  const wire::Parameters p = test::good_parameters();
  for (const float sign : {1.0f, -1.0f}) {
    SpeedLoop loop;
    const float target_mps = 5.0f * kMpsPerCount + 0.01f;
    for (int step = 1; step < 20; ++step) {
      loop.measure(sign * 5.0f * kMetresPerCount, sign * 5.0f * kMpsPerCount);
      const float duty = loop.update(sign * target_mps, 0.005f, SpeedGains(p));
      // The track lags behind by 1 cm in a second, that is 50 um a step.
      const float expected = p.feed_forward * target_mps + p.dead_band + p.speed_kp * 0.01f +
                             p.speed_ki * 50e-6f * static_cast<float>(step);
      ASSERT_NEAR(duty, sign * expected, 2e-5f) << step;
    }
  }
}

TEST(SpeedLoop, ATrackAtItsTargetStandstillIsBrakedWhenPushedAndOtherwiseLetGo) {
  const SpeedGains gains(test::good_parameters());
  for (const float sign : {1.0f, -1.0f}) {
    SpeedLoop loop;
    const auto duty = [&](float moved, float mean) {
      loop.measure(sign * moved * kMetresPerCount, sign * mean * kMpsPerCount);
      return sign * loop.update(0.0f, 5e-3f, gains);
    };
    for (int i = 0; i < 25; ++i) duty(0.0f, 0.0f);
    EXPECT_EQ(duty(0.0f, 0.0f), 0.0f);
    for (int i = 0; i < 10; ++i) EXPECT_LT(duty(7.0f, 7.0f), 0.0f);
    EXPECT_LT(duty(0.0f, 1.0f), 0.0f) << "its mean speed is not 0 yet";
    EXPECT_EQ(duty(0.0f, 0.0f), 0.0f);
    EXPECT_EQ(loop.lag_m(), 0.0f);
  }
}

TEST(SpeedLoop, TheLagOfATrackThatDoesNotFollowIsBoundedAndNoneIfItsMotorIsSaturated) {
  wire::Parameters p = test::good_parameters();
  p.speed_kp = 0.0f;
  p.speed_ki = 10.0f;
  for (const float sign : {1.0f, -1.0f}) {
    for (const float target_mps : {0.02f, 0.25f}) {
      const bool saturated = target_mps > 0.02f;
      SpeedLoop loop;
      float duty = 0.0f;
      for (int i = 0; i < 2000; ++i) duty = loop.update(sign * target_mps, 5e-3f, SpeedGains(p));
      EXPECT_FLOAT_EQ(loop.lag_m(), saturated ? 0.0f : sign * 0.02f);
      EXPECT_NEAR(duty, sign * (saturated ? 1.0f : 0.15f + 4.0f * 0.02f + 0.2f), 1e-4f);
    }
  }
}

TEST(SpeedLoop, TheDeadBandIsBlendedIn) {
  wire::Parameters p = test::good_parameters();
  p.speed_ki = 0.0f;
  SpeedLoop loop;
  float last = 0.0f;
  for (float target = 0.0006f; target < 0.02f; target += 0.0001f) {
    const float duty = loop.update(target, 5e-3f, SpeedGains(p));
    EXPECT_GT(duty, last);
    EXPECT_LT(duty - last, 0.03f);
    last = duty;
  }
}

TEST(TurnRate, TakesTheShortWayRoundWithinTheLimit) {
  const wire::Parameters p = test::good_parameters();
  EXPECT_LT(turn_rate(6.0f, 0.0f, p), 0.0f);
  EXPECT_GT(turn_rate(-6.0f, 0.0f, p), 0.0f);
  EXPECT_NEAR(turn_rate(0.1f + 50 * 6.28318531f, 0.0f, p), 0.4f, 1e-3f);
  EXPECT_FLOAT_EQ(turn_rate(3.0f, 0.0f, p), p.max_yaw_radps);
  EXPECT_FLOAT_EQ(turn_rate(0.0f, -0.3f, p), -0.3f);
}

// The rotation since any of the last 64 samples is the integral of the gyro's rate less its bias,
// or by eq 5 the difference of the tracks; older samples are unknown.
TEST(TurnHistory, TellsTheRotationSinceASample) {
  const wire::Parameters p = test::good_parameters();
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    struct Marked {
      std::uint32_t us;
      double turned_rad;
      std::int32_t left, right;
    };
    std::vector<Marked> all;
    TurnHistory history;
    // Clock and sequence wrap during the test.
    std::uint32_t us = 0xFFFFFFFFU - 500'000U;
    std::uint16_t sequence = 65'470;
    double last_radps = 0.0, turned_rad = 0.0;
    Marked now{};
    EXPECT_EQ(history.find(sequence), nullptr);
    for (int i = 0; i < 300; ++i) {
      const auto dt_us = static_cast<std::uint32_t>(4900 + random() % 200);
      us += dt_us;
      const auto raw = static_cast<std::int16_t>(static_cast<int>(random() % 20'000) - 5000);
      const double radps = raw * static_cast<double>(p.gyro_z_radps_per_lsb);
      if (i > 0) turned_rad += (last_radps + radps) / 2.0 * dt_us * 1e-6;
      last_radps = radps;
      now = {us, turned_rad, now.left + static_cast<int>(random() % 30),
             now.right - static_cast<int>(random() % 30)};
      all.push_back(now);
      history.add(++sequence, us, raw, now.left, now.right);
      if (i > 0) {
        const TrackMotion motion = history.motion(0.5f);
        const Marked& before = all[all.size() - 2];
        EXPECT_EQ(motion.left_m, 0.5f * static_cast<float>(now.left - before.left));
        EXPECT_EQ(motion.right_m, 0.5f * static_cast<float>(now.right - before.right));
        const Marked& then = all[all.size() - 1 - std::min<std::size_t>(8, all.size() - 1)];
        EXPECT_NEAR(motion.speeds.left, 0.5 * (now.left - then.left) / ((us - then.us) * 1e-6),
                    1e-2);
        EXPECT_NEAR(motion.speeds.right, 0.5 * (now.right - then.right) / ((us - then.us) * 1e-6),
                    1e-2);
      }
      for (const unsigned back : {0U, 1U, 40U, 63U, 64U, 1000U, 65'535U}) {
        const TurnMark* then = history.find(static_cast<std::uint16_t>(sequence - back));
        ASSERT_EQ(then != nullptr, back < 64 && back < all.size()) << i << ' ' << back;
        if (then == nullptr) continue;
        const Marked& before = all[all.size() - 1 - back];
        const double bias_rad = 0.07 * (us - before.us) * 1e-6;
        EXPECT_NEAR(turned(*then, history.newest(), true, 0.07f, p),
                    now.turned_rad - before.turned_rad - bias_rad, 1e-3);
        const double arc_counts =
            0.90 * (now.right - before.right) - 0.84 * (now.left - before.left);
        EXPECT_NEAR(turned(*then, history.newest(), false, 0.07f, p), arc_counts / 11140.0 / 0.274,
                    1e-5);
      }
    }
    history.clear();
    EXPECT_EQ(history.find(sequence), nullptr);
    // What happened before the first sample is no motion.
    history.add(++sequence, us += 5000, 0, now.left + 1000, now.right);
    EXPECT_EQ(history.motion(1.0f).left_m, 0.0f);
    EXPECT_EQ(history.motion(1.0f).speeds.left, 0.0f);
  }
}

TEST(Drive, AccelerationIsLimited) {
  Rig rig;
  rig.tracks_follow = true;
  rig.drive(0.15f);
  double fastest = 0.0;
  double last = rig.right_mps;
  for (int i = 0; i < 200; ++i) {
    rig.run(5);
    fastest = std::max(fastest, (rig.right_mps - last) / 5e-3);
    last = rig.right_mps;
  }
  EXPECT_LT(fastest, 0.6 * 1.6);
}

// Right minus left duty, 30 ms after a command that answers a sample 50 ms old. The gyro reads
// `rate_radps` until the command arrives.
int turning_duty(float rate_radps, float desired_yaw_rad, float bias_radps = 0.0f) {
  Rig rig;
  rig.parameters.max_track_mps2 = 20.0f;
  rig.be_ready();
  rig.run(80);
  rig.arm();
  rig.streams = false;
  rig.run(20);
  rig.hal.gyro_z = static_cast<std::int16_t>(rate_radps / test::kGyroRadpsPerLsb);
  rig.run(60);
  rig.hal.gyro_z = 0;
  wire::Command command = rig.command();
  command.answers = static_cast<std::uint16_t>(rig.samples.back().sequence - 10);
  command.yaw_rad = 1.0f;
  command.desired_yaw_rad = 1.0f + desired_yaw_rad;
  command.speed_mps = 0.08f;
  command.gyro_bias_radps = bias_radps;
  rig.send(command);
  rig.run(30);
  EXPECT_EQ(rig.program.state(), State::kRunning);
  return rig.samples.back().right_duty - rig.samples.back().left_duty;
}

TEST(Drive, YawIsCarriedForwardFromTheAnsweredSample) {
  const int straight = turning_duty(0.0f, 0.0f);
  // The robot has turned at 0.5 rad/s for 50 ms since the answered sample, and for half a sample
  // more.
  EXPECT_NEAR(turning_duty(0.5f, 0.02625f), straight, 15);
  EXPECT_GT(turning_duty(0.0f, 0.02625f), straight + 100);
  EXPECT_LT(turning_duty(0.5f, 0.0f), straight - 100);
  // A bias of 0.5 rad/s is taken off, also for the 25 ms of standstill until the reported duty was
  // computed: 0.5 * 0.075 s less the 0.02625 rad that the gyro shows.
  EXPECT_NEAR(turning_duty(0.5f, 0.0f, 0.5f), turning_duty(0.0f, 0.01125f), 15);
}

}  // namespace
}  // namespace tp100::firmware
