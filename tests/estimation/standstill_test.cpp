#include "estimation/standstill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tp100::estimation {
namespace {

constexpr DeviceUs kPeriodUs = 5000;

class StandstillTest : public testing::Test {
 protected:
  void feed(int samples, double rate_radps, double counts_per_sample) {
    for (int i = 0; i < samples; ++i) {
      travelled_ += counts_per_sample;
      sample_.device_us += kPeriodUs;
      sample_.left_counts = sample_.right_counts = static_cast<std::int64_t>(travelled_);
      sample_.imu_age = 0;
      standstill_.update(sample_, rate_radps + noise_(random_));
    }
  }

  Standstill standstill_{Parameters{}};
  Sample sample_{};
  double travelled_ = 0.0;
  std::mt19937 random_{3};
  std::normal_distribution<double> noise_{0.0, 1e-3};
};

TEST_F(StandstillTest, LearnsTheBiasAfterHalfASecondOfRest) {
  feed(90, 0.03, 0.0);
  EXPECT_FALSE(standstill_.bias_known());
  feed(30, 0.03, 0.0);
  ASSERT_TRUE(standstill_.bias_known());
  EXPECT_NEAR(standstill_.bias_radps(), 0.03, 5e-4);
}

TEST_F(StandstillTest, ASlowEvenTurnOfTheTracksIsNotRest) {
  feed(2000, 0.05, 0.05);
  EXPECT_FALSE(standstill_.bias_known());
}

TEST_F(StandstillTest, ATurnByHandWithRestingTracksIsNotRest) {
  for (int i = 0; i < 400; ++i) feed(1, 0.3 * std::sin(i * 0.05), 0.0);
  EXPECT_FALSE(standstill_.bias_known());
}

TEST_F(StandstillTest, AfterATurnByHandItIsAtRestAsSoonAsAfterADrive) {
  for (int i = 0; i < 400; ++i) feed(1, 0.3 * std::sin(i * 0.05), 0.0);
  feed(130, 0.03, 0.0);
  ASSERT_TRUE(standstill_.bias_known());
  EXPECT_NEAR(standstill_.bias_radps(), 0.03, 1e-3);
}

TEST_F(StandstillTest, FollowsASlowDriftAtRestAndHoldsWhileDriving) {
  feed(200, 0.02, 0.0);
  feed(2000, 0.04, 0.0);
  EXPECT_NEAR(standstill_.bias_radps(), 0.04, 1e-3);
  const double before = standstill_.bias_radps();
  feed(400, 0.5, 5.0);
  EXPECT_FALSE(standstill_.still());
  EXPECT_NEAR(standstill_.bias_radps(), before, 1e-4);
}

TEST_F(StandstillTest, ATurnFasterThanAnyOffsetIsNotRest) {
  feed(400, 0.5, 0.0);
  EXPECT_FALSE(standstill_.bias_known());
}

TEST_F(StandstillTest, AStaleImuTeachesNothing) {
  for (int i = 0; i < 400; ++i) {
    sample_.device_us += kPeriodUs;
    sample_.imu_age = 5;
    standstill_.update(sample_, 0.03);
  }
  EXPECT_FALSE(standstill_.bias_known());
}

// A coarse encoder does not show the first moments of a start, but the gyro does.
TEST_F(StandstillTest, ADrivenTrackIsNotAtRestBeforeItsFirstEdge) {
  feed(200, 0.02, 0.0);
  ASSERT_TRUE(standstill_.rest().has_value());
  sample_.right_duty = 0.2;
  feed(1, 0.05, 0.0);
  EXPECT_FALSE(standstill_.rest().has_value());
  EXPECT_FALSE(standstill_.still());
  EXPECT_NEAR(standstill_.bias_radps(), 0.02, 5e-4);
}

// The first sample of a standstill adds the mean of the whole window, each later one only itself.
TEST_F(StandstillTest, TheWindowCountsOnceAndThenEachSample) {
  feed(101, 0.03, 0.0);
  ASSERT_TRUE(standstill_.rest().has_value());
  EXPECT_NEAR(standstill_.rest()->radps, 0.03, 5e-4);
  const double window_sd_radps = standstill_.rest()->sd_radps;
  feed(1, 0.035, 0.0);
  ASSERT_TRUE(standstill_.rest().has_value());
  EXPECT_GT(std::abs(standstill_.rest()->radps - 0.035), 0.0);
  EXPECT_GT(standstill_.rest()->sd_radps, window_sd_radps);
}

}  // namespace
}  // namespace tp100::estimation
