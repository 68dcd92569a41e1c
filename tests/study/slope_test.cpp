#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/arithmetic.h"
#include "sim/robot/options.h"
#include "sim/study/commands.h"

namespace tp100::sim {
namespace {

struct PaperRow {
  double slope_deg, left, right;
};

class ReferenceRobot : public testing::TestWithParam<PaperRow> {};

TEST_P(ReferenceRobot, SlipsWithin2HundredthsOfThePapersTable) {
  const PaperRow& row = GetParam();
  Options options;
  options.robot = "end-loaded";
  const course::Robot robot = load(options).robot;
  const SlopeSlip slip = measure_slope(robot.emulated.body, row.slope_deg * kRadPerDeg, 0.10);
  EXPECT_TRUE(slip.climbed);
  EXPECT_NEAR(slip.left, row.left, 0.02);
  EXPECT_NEAR(slip.right, row.right, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Slopes, ReferenceRobot,
                         testing::Values(PaperRow{0, 0.16, 0.162}, PaperRow{8, 0.17, 0.176},
                                         PaperRow{12, 0.18, 0.197}, PaperRow{16, 0.19, 0.204},
                                         PaperRow{20, 0.20, 0.218}, PaperRow{24, 0.21, 0.247},
                                         PaperRow{28, 0.22, 0.260}),
                         [](const auto& param) {
                           return std::to_string(std::lround(param.param.slope_deg)) + "deg";
                         });

TEST(Slope, SlipDoesNotDependOnTheSpeed) {
  const course::EmulatedBody values;
  const double slope = 20 * kRadPerDeg;
  const SlopeSlip slow = measure_slope(values, slope, 0.05);
  const SlopeSlip fast = measure_slope(values, slope, 0.30);
  EXPECT_NEAR(slow.left, fast.left, 0.005);
  EXPECT_NEAR(slow.right, fast.right, 0.005);
}

TEST(Slope, ARobotWithoutGripDoesNotClimb) {
  course::EmulatedBody values;
  values.friction = 0.45;
  EXPECT_FALSE(measure_slope(values, 28 * kRadPerDeg, 0.10).climbed);
  EXPECT_TRUE(measure_slope(values, 20 * kRadPerDeg, 0.10).climbed);
}

}  // namespace
}  // namespace tp100::sim
