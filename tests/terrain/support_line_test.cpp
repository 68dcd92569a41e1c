#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "terrain/world.h"

namespace tp100::terrain {
namespace {

constexpr std::size_t kPlaces = SupportLine::kPlaces;

double highest_of_all(const WheelHeights& wheel, double com) {
  const auto before =
      static_cast<std::size_t>(std::clamp(std::floor(com), 0.0, static_cast<double>(kPlaces - 2)));
  double highest = -1e9;
  for (std::size_t i = 0; i <= before; ++i) {
    for (std::size_t j = before + 1; j < kPlaces; ++j) {
      const double rise = (wheel[j] - wheel[i]) / static_cast<double>(j - i);
      highest = std::max(highest, wheel[i] + rise * (com - static_cast<double>(i)));
    }
  }
  return highest;
}

TEST(SupportLine, NoOtherLineIsHigher) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> height(0.02, 0.12);
  std::uniform_real_distribution<double> place(-3.0, 43.0);
  for (int i = 0; i < 20'000; ++i) {
    WheelHeights wheel{};
    wheel.fill(0.03);
    // The ground ranges from a few peaks to a rough surface.
    for (int n = 0; n < 1 + i % 40; ++n) wheel[random() % kPlaces] = height(random);
    // The centre of mass may also lie exactly at a place or next to one.
    double com = place(random);
    if (i % 3 == 1) com = std::round(com);
    if (i % 3 == 2) com = std::nextafter(std::round(com), -1.0);
    const SupportLine line = support_line(wheel, com);
    ASSERT_NEAR(line.height, highest_of_all(wheel, com), 1e-9) << i << " com " << com;
    ASSERT_LT(line.before, line.after);
    ASSERT_DOUBLE_EQ(line.rise, (wheel[line.after] - wheel[line.before]) /
                                    static_cast<double>(line.after - line.before));
  }
}

TEST(SupportLine, LiesOnAStepWithItsMassJustBeforeIt) {
  WheelHeights wheel{};
  wheel.fill(0.03);
  for (std::size_t i = 30; i < kPlaces; ++i) wheel[i] = 0.07;
  const SupportLine line = support_line(wheel, 20.0);
  EXPECT_EQ(line.before, 0u);
  EXPECT_EQ(line.after, 30u);
  EXPECT_NEAR(line.height, 0.03 + 0.04 * 20.0 / 30.0, 1e-9);
}

TEST(SupportLine, IsLevelOnTheFloor) {
  WheelHeights wheel{};
  wheel.fill(0.03);
  for (const double com : {-1.0, 0.0, 19.5, 20.0, 40.0, 41.0}) {
    EXPECT_EQ(support_line(wheel, com).rise, 0.0);
    EXPECT_NEAR(support_line(wheel, com).height, 0.03, 1e-12);
  }
}

}  // namespace
}  // namespace tp100::terrain
