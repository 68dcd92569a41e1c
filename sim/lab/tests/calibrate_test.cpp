// Identification of an emulated robot beside the exact motion of its body, and that motion on
// slopes and in turns.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/arithmetic.h"
#include "sim/lab/body_slope.h"
#include "sim/lab/body_turn.h"
#include "sim/lab/calibration.h"

namespace tp100::sim {
namespace {

Loaded robot(const std::string& name) {
  Options options;
  options.robot = name;
  return load(options);
}

// The short form of `tp100-lab calibrate --runs 50`, with a robot that turns about a point ahead of
// it. The intervals are 95 % intervals for a given noise.
TEST(Calibration, FindsWhatTheBodyReallyDid) {
  const Loaded front_heavy = robot("front-heavy");
  const course::EmulatedBody& body = front_heavy.robot.emulated.body;
  const Calibration calibration = calibrate(front_heavy, 1, 7);
  EXPECT_TRUE(calibration.accurate());
  std::size_t held = 0;
  for (const model::ParameterRow& row : model::kTrackParameters)
    if (calibration.holds(row.value)) ++held;
  EXPECT_GE(held + 1, model::kTrackParameters.size());
  EXPECT_TRUE(calibration.found.extended.confused.empty());
  for (std::size_t i = 0; i < model::kBaselines.size(); ++i)
    EXPECT_EQ(calibration.found.baselines[i].has_value(), model::kBaselines[i].fixed == nullptr);

  // The slip on slopes, by tape and protractor on boards: against the body's exact motion.
  ASSERT_EQ(calibration.found.slopes.size(), model::kMaxSlopes);
  const SlopeSlip level = measure_slope(body, 0.0, kSlopeTrackMps);
  for (const model::AddedSlip& slope : calibration.found.slopes) {
    if (slope.slope_rad < 0.0) continue;
    const SlopeSlip exact = measure_slope(body, slope.slope_rad, kSlopeTrackMps);
    EXPECT_NEAR(slope.left, exact.left - level.left, 0.02) << slope.slope_rad * kDegPerRad;
    EXPECT_NEAR(slope.right, exact.right - level.right, 0.02) << slope.slope_rad * kDegPerRad;
  }
}

TEST(SlopeDrives, ASlopeThatIsTooSteepIsLeftOut) {
  const std::vector<identify::RecordedDrive> drives = slope_drives(robot("slippery").robot, 3);
  ASSERT_FALSE(drives.empty());
  for (const identify::RecordedDrive& drive : drives)
    EXPECT_LT(*drive.measured.slope_rad, 20.0 * kRadPerDeg);
}

// By eq 7 a robot on four points with this axle spacing and gauge has 0.2691 m.
TEST(BodyTurn, EndLoadedTracksTurnWithALongerWheelbaseThanEvenOnes) {
  Options even;
  even.robot = "uniform";
  const std::vector<BodyTurn> ends = measure_turns(load({}).robot.emulated);
  ASSERT_EQ(ends.size(), 2u);
  for (const BodyTurn& turn : ends) EXPECT_NEAR(turn.wheelbase_m, 0.274, 0.006);
  for (const BodyTurn& turn : measure_turns(load(even).robot.emulated))
    EXPECT_NEAR(turn.wheelbase_m, 0.20, 0.01);
}

TEST(BodySlope, TheReferenceRobotSlipsAsInThePapersTableAtAnySpeedAsLongAsItHasGrip) {
  course::EmulatedBody values = load({}).robot.emulated.body;
  for (const SlopeRow& row : slope_rows()) {
    if (!row.paper_left) continue;
    const SlopeSlip slip = measure_slope(values, row.slope_deg * kRadPerDeg, 0.10);
    EXPECT_TRUE(slip.climbed);
    EXPECT_NEAR(slip.left, *row.paper_left, 0.02) << row.slope_deg;
    EXPECT_NEAR(slip.right, *row.paper_right, 0.02) << row.slope_deg;
    EXPECT_NEAR(measure_slope(values, row.slope_deg * kRadPerDeg, 0.30).left, slip.left, 0.005);
  }
  values.friction = 0.45;
  EXPECT_FALSE(measure_slope(values, 28 * kRadPerDeg, 0.10).climbed);
  EXPECT_TRUE(measure_slope(values, 20 * kRadPerDeg, 0.10).climbed);
}

}  // namespace
}  // namespace tp100::sim
