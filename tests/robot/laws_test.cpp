// Control laws steer the emulated robot by the fused pose of an overhead camera and keep the limits
// of the pose, of tracking and of recovery.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <vector>

#include "runs.h"

namespace tp100::sim {
namespace {

// Sanitized builds run the same code about ten times slower, so they use fewer seeds.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uint64_t kSeeds = 1;
#else
constexpr std::uint64_t kSeeds = 3;
#endif
constexpr control::LawName kDefaultLaw = control::Parameters{}.law;

struct LawCase {
  control::LawName law;
  std::string law_name, course, robot;
  // Limits of medians over the seeds; 0: none, because of disturbances.
  double fused_max_m;  ///< largest error of the fused pose
  double tracking_m;   ///< largest distance from the path
  std::uint64_t seeds = kSeeds;
};

void PrintTo(const LawCase& which, std::ostream* out) {
  *out << which.law_name << ' ' << which.course << ' ' << which.robot;
}

LockstepSettings steered_run(control::LawName law, const std::string& course,
                             const std::string& robot = "end-loaded") {
  LockstepSettings run = seen_run_of(course, robot);
  run.configuration.parameters.control.law = law;
  return run;
}

class CoursesByLaw : public testing::TestWithParam<LawCase> {};

TEST_P(CoursesByLaw, SteerTheBodyAlongTheCourseAndKeepTheirLimits) {
  const LawCase& which = GetParam();
  LockstepSettings run = steered_run(which.law, which.course, which.robot);
  std::vector<double> max_m, rms_m, yaw_rad, tracking_m;
  for (run.seed = 1; run.seed <= which.seeds; ++run.seed) {
    SCOPED_TRACE(testing::Message() << "seed " << run.seed);
    const report::RunResult result = run_lockstep(run);
    EXPECT_TRUE(result.completed) << result.cause;
    const report::RunFigures figures = report::figures(result, run.course);
    const report::PoseErrors& fused = *figures.estimates[PoseSource::kFused];
    max_m.push_back(fused.max_position_error_m);
    rms_m.push_back(fused.rms_position_error_m);
    yaw_rad.push_back(std::sqrt(fused.mse_yaw_rad2));
    tracking_m.push_back(figures.tracking.max_cross_track_m);
    expect_recovered(figures.tracking, run.course);
  }
  EXPECT_LE(median(rms_m), 0.010);
  EXPECT_LE(median(yaw_rad), 1.0 * kRadPerDeg);
  if (which.fused_max_m > 0.0) {
    EXPECT_LE(median(max_m), which.fused_max_m);
  }
  if (which.tracking_m > 0.0) {
    EXPECT_LE(median(tracking_m), which.tracking_m);
  }
}

std::vector<LawCase> default_law(std::uint64_t seeds) {
  std::vector<LawCase> all;
  for (const char* robot : {"end-loaded", "uniform"}) {
    all.push_back({kDefaultLaw, "default", "1-curve", robot, 0.006, 0.008, seeds});
    all.push_back({kDefaultLaw, "default", "2", robot, 0.0, 0.0, seeds});
  }
  all.push_back({kDefaultLaw, "default", "1-straight", "end-loaded", 0.006, 0.008, seeds});
  all.push_back({kDefaultLaw, "default", "1-sharp", "end-loaded", 0.010, 0.015, seeds});
  return all;
}

std::vector<LawCase> all_laws() {
  std::vector<LawCase> all = default_law(kSeeds);
  for (const auto& [law, name] : control::kLawNames) {
    all.push_back({law, name, "3", "end-loaded", 0.0, 0.015});
    if (law == kDefaultLaw) continue;
    all.push_back({law, name, "1-curve", "end-loaded", 0.0, 0.008});
    all.push_back({law, name, "1-sharp", "end-loaded", 0.0, 0.015});
    all.push_back({law, name, "2", "end-loaded", 0.0, 0.0});
  }
  return all;
}

std::string law_case_name(const testing::TestParamInfo<LawCase>& info) {
  return test_name(info.param.law_name + "_" + info.param.course + "_" + info.param.robot);
}

INSTANTIATE_TEST_SUITE_P(Flat, CoursesByLaw, testing::ValuesIn(all_laws()), law_case_name);
INSTANTIATE_TEST_SUITE_P(NightlyFlat, CoursesByLaw, testing::ValuesIn(default_law(10)),
                         law_case_name);

// The key must select different laws: their runs must differ.
TEST(Laws, DriveDifferently) {
  std::vector<double> sums_m;
  for (const auto& [law, name] : control::kLawNames) {
    double sum_m = 0.0;
    for (const report::TrajectoryPoint& point : run_lockstep(steered_run(law, "2")).points)
      sum_m += point.truth.y_m;
    sums_m.push_back(sum_m);
  }
  std::sort(sums_m.begin(), sums_m.end());
  EXPECT_EQ(std::adjacent_find(sums_m.begin(), sums_m.end()), sums_m.end());
}

TEST(Laws, DisturbancesAreRecoveredFromOnTheOtherRobotsToo) {
  for (const char* robot : {"front-heavy", "large", "slippery"}) {
    SCOPED_TRACE(robot);
    const LockstepSettings run = steered_run(control::LawName::kStanley, "2", robot);
    const report::RunResult result = run_lockstep(run);
    EXPECT_TRUE(result.completed) << result.cause;
    expect_recovered(report::figures(result, run.course).tracking, run.course);
  }
}

}  // namespace
}  // namespace tp100::sim
