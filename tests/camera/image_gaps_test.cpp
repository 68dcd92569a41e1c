#include <gtest/gtest.h>

#include <random>

#include "camera/source.h"
#include "camera/watch.h"

namespace tp100::camera {
namespace {

TEST(ImageGaps, SteadyImagesAreNumberedOneByOne) {
  ImageGaps gaps;
  std::mt19937 random(1);
  std::normal_distribution<double> jitter(0.0, 0.003);
  for (std::uint32_t i = 1; i <= 500; ++i)
    EXPECT_EQ(gaps.number(from_s(i / 30.0 + std::clamp(jitter(random), -0.01, 0.01))), i);
  EXPECT_EQ(gaps.missing(), 0U);
}

TEST(ImageGaps, DroppedImagesLeaveAGapInTheNumbers) {
  ImageGaps gaps;
  std::mt19937 random(2);
  std::uint32_t dropped = 0;
  for (std::uint32_t i = 1; i <= 300; ++i) {
    if (i > 10 && random() % 5 == 0) {
      ++dropped;
      continue;
    }
    EXPECT_EQ(gaps.number(from_s(i / 30.0)), i);
  }
  EXPECT_GT(dropped, 40U);
  EXPECT_EQ(gaps.missing(), dropped - (gaps.number(from_s(301 / 30.0)) == 301U ? 0 : 1));
}

TEST(ImageGaps, ACameraThatSlowsDownInTheDarkIsNotDroppingForLong) {
  ImageGaps gaps;
  double t_s = 0.0;
  for (int i = 0; i < 50; ++i) gaps.number(from_s(t_s += 1.0 / 30.0));
  for (int i = 0; i < 200; ++i) gaps.number(from_s(t_s += 1.0 / 15.0));
  EXPECT_LT(gaps.missing(), 10U);
}

TEST(ImageGaps, AnImageThatIsNotNewerHasNoNumber) {
  ImageGaps gaps;
  EXPECT_EQ(gaps.number(100), 1U);
  EXPECT_FALSE(gaps.number(100).has_value());
  EXPECT_FALSE(gaps.number(50).has_value());
  EXPECT_EQ(gaps.number(200), 2U);
}

TEST(DeviceImageTime, IsTheDriversWhereThatIsAMonotonicStamp) {
  const HostNs grabbed = 5'000 * kNsPerS;
  EXPECT_EQ(image_time(4'999'960.0, grabbed, 0), grabbed - 40 * kNsPerMs);
  EXPECT_EQ(image_time(4'999'960.0, grabbed, 10 * kNsPerMs), grabbed - 50 * kNsPerMs);
}

TEST(DeviceImageTime, IsTheGrabbingWhereTheDriverHasAnotherClockOrNone) {
  const HostNs grabbed = 5'000 * kNsPerS;
  for (const double driver_ms : {0.0, -1.0, 1.7e12, 5'000'001.0, 4'998'000.0})
    EXPECT_EQ(image_time(driver_ms, grabbed, 10 * kNsPerMs), grabbed - 10 * kNsPerMs) << driver_ms;
}

}  // namespace
}  // namespace tp100::camera
