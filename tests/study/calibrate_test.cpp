#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic.h"
#include "sim/trials/commands.h"
#include "sim/lab/constants_study.h"
#include "sim/lab/study.h"

namespace tp100::sim {
namespace {

Loaded robot(const std::string& name) {
  Options options;
  options.robot = name;
  return load(options);
}

// The short form of `tp100-sim calibrate --runs 50`, with a robot that turns about a point ahead of
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

// Tracks that are evenly loaded turn on the spot with another wheelbase, and a turn costs no
// distance on the ODE body.
TEST(NightlyConstants, TheCriterionTellsThoseThatPayFromOthers) {
  const CourseStudy study = study_constants("uniform", "ode", 5);
  EXPECT_EQ(largest_criteria({CourseStudy{}, study}).judged.size(), study.judged.size());
  const auto of = [&](const std::string& what) {
    for (const Judged& one : study.judged)
      if (one.what == "criterion " + what) return one.ours.median;
    return std::nan("");
  };
  EXPECT_GT(of("of eqs 1-5"), 1000.0);
  EXPECT_GT(of("without wheelbase_tight_m"), 1000.0);
  EXPECT_GT(of("without wheelbase_spin_m"), 1000.0);
  EXPECT_LT(of("without turn_loss"), 0.0);
  EXPECT_GT(of("without turn_loss"), -15.0) << "one constant less cannot save more than ln n";
}

}  // namespace
}  // namespace tp100::sim
