#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic.h"
#include "model/track_model.h"
#include "sim/study/commands.h"
#include "sim/study/constants_study.h"
#include "sim/study/study.h"

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

/// A drive that follows the extended model exactly: each pair of ground speeds for some seconds.
CalibrationDrive follow(const model::TrackParameters& truth, double counts_per_metre,
                        const std::vector<std::pair<double, double>>& speeds_mps) {
  constexpr double kStepS = 0.005;
  constexpr int kSteps = 800;
  model::TrackModel model(truth, model::Mode::kExtended);
  CalibrationDrive drive;
  double left_m = 0.0, right_m = 0.0;
  const auto take = [&](double t_s) {
    drive.drive.samples.push_back({t_s, std::llround(left_m * counts_per_metre),
                                   std::llround(right_m * counts_per_metre), 0.0});
    drive.truth.push_back(model.pose());
  };
  take(0.0);
  for (const auto& [left, right] : speeds_mps) {
    const double left_mps = left / (1.0 - truth.slip_left);
    const double right_mps = right / (1.0 - truth.slip_right);
    for (int i = 0; i < kSteps; ++i) {
      model.advance(left_mps, right_mps, kStepS);
      left_m += left_mps * kStepS;
      right_m += right_mps * kStepS;
      take(drive.drive.samples.back().t_s + kStepS);
    }
  }
  return drive;
}

// Of arcs of any radius, also within one drive.
TEST(EffectiveMotion, FindsTheParametersThatAMotionFollows) {
  model::TrackParameters truth;
  truth.slip_angle_turning_rad = 0.01;
  truth.wheelbase_m = 0.24;
  truth.wheelbase_medium_m = 0.245;
  truth.wheelbase_tight_m = 0.25;
  truth.wheelbase_spin_m = 0.22;
  truth.x_icr_m = 0.01;
  truth.x_icr_tight_shift_m = 0.008;
  truth.x_icr_spin_shift_m = -0.006;
  truth.turn_slip = 0.03;
  truth.turn_slip_tight = 0.02;
  truth.turn_loss = 0.05;
  course::Emulated robot;
  robot.encoder.counts_per_metre = 20000.0;
  robot.body.gauge_m = 0.16;
  const double counts = robot.encoder.counts_per_metre;
  const CalibrationDrive straight = follow(truth, counts, {{0.1, 0.1}});
  const CalibrationDrive left =
      follow(truth, counts, {{0.08, 0.1}, {0.05, 0.1}, {0.03, 0.1}, {0.01, 0.1}, {-0.1, 0.1}});
  const CalibrationDrive right =
      follow(truth, counts, {{0.1, -0.1}, {0.1, 0.02}, {0.1, 0.04}, {0.1, 0.065}});
  const CalibrationDrive wide = follow(truth, counts, std::vector(8, std::pair{0.085, 0.1}));

  const model::TrackParameters found = effective_motion({straight, left, right, wide}, robot);
  for (const model::ParameterRow& row : model::kTrackParameters) {
    if (row.of == model::ParameterOf::kGyro) continue;
    EXPECT_NEAR(found.*row.value, truth.*row.value, 5e-4) << row.key;
  }

  const model::TrackParameters without_arcs = effective_motion(
      {straight, follow(truth, counts, {{-0.1, 0.1}}), follow(truth, counts, {{0.1, -0.1}})},
      robot);
  EXPECT_NEAR(without_arcs.wheelbase_spin_m, truth.wheelbase_spin_m, 5e-4);
  EXPECT_TRUE(std::isnan(without_arcs.wheelbase_m));
  EXPECT_TRUE(std::isnan(without_arcs.turn_slip_tight));
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
