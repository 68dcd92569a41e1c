#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "recovered.h"
#include "report/metrics.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"

namespace tp100::sim {
namespace {

// Sanitized builds run the same code about ten times slower, so they use fewer seeds.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uint64_t kSeeds = 1;
#else
constexpr std::uint64_t kSeeds = 3;
#endif

struct LawCase {
  control::LawName law;
  const char* law_name;
  const char* course;
  double tracking_m;  ///< median over the seeds of the largest distance from the path; 0: no limit,
                      ///< because of disturbances
};

void PrintTo(const LawCase& which, std::ostream* out) {
  *out << which.law_name << ' ' << which.course;
}

LockstepSettings settings(const LawCase& which, const std::string& robot = "end-loaded") {
  Options options;
  options.robot = robot;
  const Loaded loaded = load(options);
  LockstepSettings settings{.course = load_course(which.course),
                            .robot = loaded.robot,
                            .configuration = loaded.configuration,
                            .setup = loaded.setup,
                            .camera = load_camera("overhead")};
  settings.configuration.parameters.steering = PoseSource::kFused;
  settings.configuration.parameters.control.law = which.law;
  return settings;
}

class CoursesByLaw : public testing::TestWithParam<LawCase> {};

TEST_P(CoursesByLaw, SteerTheBodyAlongTheCourse) {
  const LawCase& which = GetParam();
  LockstepSettings run = settings(which);
  std::vector<double> tracking_m;
  for (run.seed = 1; run.seed <= kSeeds; ++run.seed) {
    SCOPED_TRACE(testing::Message() << "seed " << run.seed);
    const report::RunResult result = run_lockstep(run);
    EXPECT_TRUE(result.completed) << result.cause;
    const report::TrackingErrors tracking = report::figures(result, run.course).tracking;
    tracking_m.push_back(tracking.max_cross_track_m);
    expect_recovered(tracking, run.course);
  }
  std::sort(tracking_m.begin(), tracking_m.end());
  if (which.tracking_m > 0.0) {
    EXPECT_LE(tracking_m[tracking_m.size() / 2], which.tracking_m);
  }
}

std::vector<LawCase> cases() {
  std::vector<LawCase> all;
  for (const auto& [law, name] : control::kLawNames) {
    all.push_back({law, name, "3", 0.015});
    // FusedCourses tests this law on the other courses.
    if (law == control::Parameters{}.law) continue;
    all.push_back({law, name, "1-curve", 0.008});
    all.push_back({law, name, "1-sharp", 0.015});
    all.push_back({law, name, "2", 0.0});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Flat, CoursesByLaw, testing::ValuesIn(cases()),
                         [](const testing::TestParamInfo<LawCase>& param) {
                           std::string name =
                               std::string(param.param.law_name) + "_" + param.param.course;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// The key must select different laws: their runs must differ.
TEST(Laws, DriveDifferently) {
  std::vector<double> end_s;
  for (const auto& [law, name] : control::kLawNames) {
    const report::RunResult result = run_lockstep(settings({law, name, "2", 0.0}));
    double sum = 0.0;
    for (const report::TrajectoryPoint& point : result.points) sum += point.truth.y_m;
    end_s.push_back(sum);
  }
  std::sort(end_s.begin(), end_s.end());
  EXPECT_EQ(std::adjacent_find(end_s.begin(), end_s.end()), end_s.end());
}

// These are the robots that FusedCourses leaves out.
TEST(Laws, DisturbancesAreRecoveredFromOnEveryRobot) {
  for (const char* robot : {"front-heavy", "large", "slippery"}) {
    SCOPED_TRACE(robot);
    const LockstepSettings run = settings({control::LawName::kStanley, "", "2", 0.0}, robot);
    const report::RunResult result = run_lockstep(run);
    EXPECT_TRUE(result.completed) << result.cause;
    expect_recovered(report::figures(result, run.course).tracking, run.course);
  }
}

}  // namespace
}  // namespace tp100::sim
