#include <gtest/gtest.h>

#include "bridge/perception.h"

namespace tp100::bridge {
namespace {

Sample at(DeviceUs us, std::int64_t left, std::int64_t right) {
  Sample sample;
  sample.device_us = us;
  sample.left_counts = left;
  sample.right_counts = right;
  sample.imu_age = 0;
  return sample;
}

TEST(SampleIntervals, TheFirstSampleIsNoInterval) {
  SampleIntervals intervals(10000.0, 1.0);
  EXPECT_FALSE(intervals.update(at(0, 5, 5)).has_value());
}

TEST(SampleIntervals, SpeedsAreCountsOverDeviceTimeAlsoAcrossLostSamples) {
  SampleIntervals intervals(10000.0, 1.0);
  intervals.update(at(0, 0, 0));
  const auto interval = intervals.update(at(20'000, 20, -10));
  ASSERT_TRUE(interval.has_value());
  EXPECT_DOUBLE_EQ(interval->dt_s, 0.02);
  EXPECT_DOUBLE_EQ(interval->tracks.left_mps, 0.1);
  EXPECT_DOUBLE_EQ(interval->tracks.right_mps, -0.05);
}

TEST(SampleIntervals, ASampleThatIsNotNewerChangesNothing) {
  SampleIntervals intervals(10000.0, 1.0);
  intervals.update(at(10'000, 0, 0));
  EXPECT_FALSE(intervals.update(at(10'000, 50, 50)).has_value());
  EXPECT_FALSE(intervals.update(at(5'000, 50, 50)).has_value());
  EXPECT_DOUBLE_EQ(intervals.update(at(15'000, 5, 5))->tracks.left_mps, 0.1);
}

TEST(SampleIntervals, TheGyroIsTheScaledMeanAndFreshOnlyIfBothEndsAre) {
  SampleIntervals intervals(10000.0, 1.02);
  Sample first = at(0, 0, 0);
  first.gyro_radps[2] = 0.1;
  Sample second = at(5'000, 0, 0);
  second.gyro_radps[2] = 0.3;
  intervals.update(first);
  const auto interval = intervals.update(second);
  EXPECT_NEAR(interval->gyro_z_radps, 0.2 * 1.02, 1e-12);
  EXPECT_TRUE(interval->gyro_fresh);
  Sample third = at(10'000, 0, 0);
  third.imu_age = 1;
  EXPECT_FALSE(intervals.update(third)->gyro_fresh);
}

}  // namespace
}  // namespace tp100::bridge
