#include "estimation/standstill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace tp100::estimation {
namespace {

constexpr double kRate = 0.03;

/// A robot at rest, with what `change` makes of its i-th sample and rate.
class Robot {
 public:
  using Change = std::function<void(Sample&, double& rate_radps, int i)>;

  void feed(
      int samples, const Change& change = [](Sample&, double&, int) {}) {
    for (int i = 0; i < samples; ++i) {
      Sample sample = at_rest;
      double rate = kRate;
      change(sample, rate, i);
      at_rest.device_us += 5000;
      sample.device_us += 5000;
      standstill.update(sample, rate);
    }
  }
  Standstill standstill{Parameters{}};
  Sample at_rest = [] {
    Sample sample;
    sample.imu_age = 0;
    return sample;
  }();
};

TEST(Standstill, IsKnownAfterHalfASecond) {
  Robot robot;
  robot.feed(100);
  EXPECT_FALSE(robot.standstill.still() || robot.standstill.bias_known());
  EXPECT_FALSE(robot.standstill.rest());
  robot.feed(1);
  EXPECT_TRUE(robot.standstill.still() && robot.standstill.bias_known());
  EXPECT_TRUE(robot.standstill.rest());
}

TEST(Standstill, NeedsTracksMotorsAndGyroAtRestFromBeginningToEnd) {
  const auto in_the_middle = [](const std::function<void(Sample&, double&)>& change) {
    return [change](Sample& sample, double& rate, int i) {
      if (i == 60) change(sample, rate);
    };
  };
  const struct {
    const char* what;
    Robot::Change change;
    bool rests;
  } cases[] = {
      {"an edge that flickers",
       [](Sample& s, double&, int i) { s.left_counts = s.right_counts = i % 2; }, true},
      {"one edge back", in_the_middle([](Sample& s, double&) { s.left_counts = -1; }), true},
      {"two edges", in_the_middle([](Sample& s, double&) { s.left_counts = 2; }), false},
      {"two edges right", in_the_middle([](Sample& s, double&) { s.right_counts = -2; }), false},
      {"a slow even turn", [](Sample& s, double&, int i) { s.right_counts = i / 25; }, false},
      {"a duty left", in_the_middle([](Sample& s, double&) { s.left_duty = 0.01; }), false},
      {"a duty right", in_the_middle([](Sample& s, double&) { s.right_duty = -0.01; }), false},
      {"a stale IMU", in_the_middle([](Sample& s, double&) { s.imu_age = 1; }), false},
      {"a jolt", in_the_middle([](Sample&, double& rate) { rate += 0.059; }), true},
      {"a larger one", in_the_middle([](Sample&, double& rate) { rate += 0.061; }), false},
      {"one to the other side", in_the_middle([](Sample&, double& rate) { rate -= 0.061; }), false},
      {"noise", [](Sample&, double& rate, int i) { rate += i % 2 == 0 ? 0.0099 : -0.0099; }, true},
      {"more noise", [](Sample&, double& rate, int i) { rate += i % 2 == 0 ? 0.0103 : -0.0103; },
       false},
      {"a turn by hand", [](Sample&, double& rate, int i) { rate = 0.3 * std::sin(i * 0.05); },
       false},
      {"the greatest bias", [](Sample&, double& rate, int) { rate = -0.449; }, true},
      {"a turn that is faster", [](Sample&, double& rate, int) { rate = 0.451; }, false},
      {"a turn to the right", [](Sample&, double& rate, int) { rate = -0.451; }, false}};
  for (const auto& of : cases) {
    SCOPED_TRACE(of.what);
    Robot robot;
    robot.feed(120, of.change);
    EXPECT_EQ(robot.standstill.bias_known(), of.rests);
    if (of.rests) continue;
    robot.feed(102);
    EXPECT_TRUE(robot.standstill.bias_known()) << "as soon as after a drive";
    EXPECT_NEAR(robot.standstill.bias_radps(), kRate, 5e-4);
  }
}

// The first sample of a standstill gives the mean of the whole window, each later one only itself.
TEST(Standstill, TheWindowCountsOnceAndThenEachSample) {
  Robot robot;
  robot.feed(101, [](Sample&, double& rate, int i) { rate += i < 51 ? 0.001 : -0.001; });
  const double mean = kRate + 0.001 / 101.0;
  ASSERT_TRUE(robot.standstill.rest());
  EXPECT_NEAR(robot.standstill.rest()->radps, mean, 1e-12);
  EXPECT_EQ(robot.standstill.rest()->sd_radps, 0.0005);
  EXPECT_NEAR(robot.standstill.bias_radps(), mean, 1e-12);
  double bias = mean;
  for (int i = 0; i < 50; ++i) {
    robot.feed(1, [](Sample&, double& rate, int) { rate = 0.035; });
    ASSERT_TRUE(robot.standstill.rest());
    EXPECT_EQ(robot.standstill.rest()->radps, 0.035);
    EXPECT_EQ(robot.standstill.rest()->sd_radps, 0.003);
    bias += (0.035 - bias) * 0.005 / 2.0;  // a low-pass of 2 s
    EXPECT_NEAR(robot.standstill.bias_radps(), bias, 1e-12);
  }
  robot.at_rest.device_us += 7'000'000;
  robot.feed(1, [](Sample&, double& rate, int) { rate = 0.036; });
  EXPECT_NEAR(robot.standstill.bias_radps(), 0.036, 1e-12) << "after a gap";
  robot.feed(1, [](Sample& sample, double&, int) { sample.left_counts = 9; });
  EXPECT_FALSE(robot.standstill.rest() || robot.standstill.still());
  EXPECT_NEAR(robot.standstill.bias_radps(), 0.036, 1e-12) << "held while driving";
}

TEST(Standstill, ABootKeepsTheBiasAndAResumedOneIsTheOneThatWasCarried) {
  Robot robot;
  robot.feed(150);
  robot.standstill.restart();
  robot.feed(100);
  EXPECT_FALSE(robot.standstill.rest()) << "the counts began anew";
  EXPECT_NEAR(robot.standstill.bias_radps(), kRate, 1e-9);
  for (const bool known : {true, false}) {
    robot.standstill.resume(0.05, known);
    EXPECT_EQ(robot.standstill.bias_known(), known);
    EXPECT_EQ(robot.standstill.bias_radps(), 0.05);
    robot.feed(100);
    EXPECT_FALSE(robot.standstill.still());
    robot.feed(1);
    EXPECT_TRUE(robot.standstill.still());
    EXPECT_EQ(robot.standstill.bias_radps() > 0.049, known) << "else the window's mean";
  }
}

}  // namespace
}  // namespace tp100::estimation
