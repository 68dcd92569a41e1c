#include "sim/robot/lockstep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "core/error.h"
#include "course/bundled_files.h"
#include "report/metrics.h"
#include "report/result_text.h"
#include "report/run_result.h"
#include "sim/robot/options.h"

namespace tp100::sim {
namespace {

LockstepSettings settings(const std::string& course, const std::string& robot,
                          const std::string& board = "native") {
  Options options;
  options.board = board;
  options.robot = robot;
  const Loaded loaded = load(options);
  return {.course = load_course(course),
          .robot = loaded.robot,
          .configuration = loaded.configuration,
          .setup = loaded.setup,
          .board = loaded.board};
}

struct Case {
  const char* board;
  const char* course;
  const char* robot;
  double model_limit_m;  ///< median over the seeds of the largest position error; 0: no limit
  std::uint64_t seeds = 1;
};

void PrintTo(const Case& which, std::ostream* out) {
  *out << which.board << ' ' << which.course << ' ' << which.robot;
}

class Courses : public testing::TestWithParam<Case> {};

TEST_P(Courses, AreCompletedForEverySeedAndTheModelKeepsItsLimit) {
  const Case& which = GetParam();
  LockstepSettings run = settings(which.course, which.robot, which.board);
  std::vector<double> model_m;
  for (run.seed = 1; run.seed <= which.seeds; ++run.seed) {
    const report::RunResult result = run_lockstep(run);
    EXPECT_TRUE(result.completed) << "seed " << run.seed << ": " << result.cause;
    EXPECT_EQ(result.link.lost, 0u);
    EXPECT_EQ(result.link.crc_errors, 0u);
    model_m.push_back(
        report::figures(result, run.course).estimates[PoseSource::kModel]->max_position_error_m);
  }
  std::sort(model_m.begin(), model_m.end());
  const double median_m = model_m[model_m.size() / 2];
  if (which.model_limit_m > 0.0) {
    EXPECT_LE(median_m, which.model_limit_m);
  }
}

std::vector<Case> cases(const char* board, std::uint64_t seeds) {
  std::vector<Case> all = {
      {board, "1-straight", "end-loaded", 0.010}, {board, "1-curve", "end-loaded", 0.010},
      {board, "1-sharp", "end-loaded", 0.030},    {board, "2", "end-loaded", 0.0},
      {board, "1-straight", "uniform", 0.0},      {board, "1-curve", "uniform", 0.0},
      {board, "1-sharp", "uniform", 0.0},         {board, "2", "uniform", 0.0}};
  for (Case& one : all) one.seeds = seeds;
  return all;
}

std::string course_case_name(const testing::TestParamInfo<Case>& param) {
  std::string name = std::string(param.param.course) + "_" + param.param.robot;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Native, Courses, testing::ValuesIn(cases("native", 3)), course_case_name);
INSTANTIATE_TEST_SUITE_P(NightlyNative, Courses, testing::ValuesIn(cases("native", 10)),
                         course_case_name);
// Only builds that make the image can run it.
#ifdef TP100_HAS_IMAGE
INSTANTIATE_TEST_SUITE_P(Avr, Courses, testing::ValuesIn(cases("avr", 1)), course_case_name);
INSTANTIATE_TEST_SUITE_P(NightlyAvr, Courses, testing::ValuesIn(cases("avr", 5)), course_case_name);

TEST(Options, TheFloorIsAValueOfTheRobotsFile) {
  Options options;
  EXPECT_EQ(load(options).robot.emulated.floor, course::Floor::kEven);
  options.floor = "uneven";
  const Loaded loaded = load(options);
  EXPECT_EQ(loaded.robot.emulated.floor, course::Floor::kUneven);
  EXPECT_NE(loaded.files.robot.text.find("floor = 'uneven'"), std::string::npos);
  options.floor = "bumpy";
  try {
    load(options);
    FAIL();
  } catch (const SetupError& error) {
    EXPECT_STREQ(error.what(), "--floor bumpy: not a floor; use even or uneven");
  }
}

// On an even floor seeds change noise only, and the model's error is the same in all of them.
TEST(Lockstep, ASeedDrawsAnUnevenFloorAndRepeatsIt) {
  LockstepSettings run = settings("1-straight", "end-loaded");
  const auto error_cm = [&](course::Floor floor, std::uint64_t seed) {
    run.robot.emulated.floor = floor;
    run.seed = seed;
    const report::RunResult result = run_lockstep(run);
    EXPECT_TRUE(result.completed) << result.cause;
    EXPECT_EQ(result.floor, to_string(floor));
    return report::figures(result, run.course).estimates[PoseSource::kModel]->max_position_error_m *
           100.0;
  };
  EXPECT_NEAR(error_cm(course::Floor::kEven, 1), error_cm(course::Floor::kEven, 2), 0.02);
  const double uneven_cm = error_cm(course::Floor::kUneven, 1);
  EXPECT_GT(std::abs(uneven_cm - error_cm(course::Floor::kUneven, 2)), 0.2);
  EXPECT_EQ(uneven_cm, error_cm(course::Floor::kUneven, 1));
}

TEST(Lockstep, TheDeviceClockWrapsWithoutAJumpOnTheImage) {
  LockstepSettings run = settings("1-curve", "end-loaded", "avr");
  // The run starts ten seconds before the wrap, at a multiple of the step of the board's timer.
  run.start_us = (0xFFFFFFFFu - 10'000'000u) / 1024u * 1024u;
  const report::RunResult result = run_lockstep(run);
  EXPECT_TRUE(result.completed) << result.cause;
  EXPECT_EQ(result.link.implausible, 0u);
  EXPECT_EQ(result.link.lost, 0u);
  EXPECT_EQ(result.link.crc_errors, 0u);
  EXPECT_LE(report::figures(result, run.course).estimates[PoseSource::kModel]->max_position_error_m,
            0.010);
}
#endif

/// The uniform robot on the body `shear`, with the values of [model] that it has there.
LockstepSettings on_shear(const std::string& course) {
  LockstepSettings run = settings(course, "uniform");
  run.robot.emulated.contact_law = course::ContactLaw::kShear;
  run.robot.model = {.slip_left = 0.001, .slip_right = 0.001, .wheelbase_m = 0.178};
  return run;
}

TEST(Lockstep, CoursesAreCompletedOnTheBodyWithTheOtherContactLaw) {
  for (const char* course : {"1-curve", "2"}) {
    const report::RunResult result = run_lockstep(on_shear(course));
    EXPECT_TRUE(result.completed) << course << ": " << result.cause;
    EXPECT_EQ(result.body, "shear");
  }
}

TEST(Lockstep, OnlyTheOtherBodyCarriesARampThatIsReallyThere) {
  LockstepSettings run = on_shear("3");
  run.setup = bridge::Setup::kTerrain;
  EXPECT_THROW(run_lockstep(run), SetupError);
}

TEST(Options, TheBodyIsAValueOfTheRobotsFile) {
  Options options;
  EXPECT_EQ(load(options).robot.emulated.contact_law, course::ContactLaw::kOde);
  options.body = "shear";
  options.robot_values = {{"emulated.shear.modulus_m", 0.005}};
  const Loaded loaded = load(options);
  EXPECT_EQ(loaded.robot.emulated.contact_law, course::ContactLaw::kShear);
  EXPECT_EQ(loaded.robot.emulated.shear.modulus_m, 0.005);
  EXPECT_NE(loaded.files.robot.text.find("contact_law = 'shear'"), std::string::npos);
  options.body = "sheer";
  try {
    load(options);
    FAIL();
  } catch (const SetupError& error) {
    EXPECT_STREQ(error.what(), "--body sheer: not a body; use ode or shear");
  }
}

TEST(Lockstep, TheDeviceClockWrapsWithoutAJump) {
  LockstepSettings run = settings("1-curve", "end-loaded");
  run.start_us = 0xFFFFFFFFu - 10'000'000u;
  const report::RunResult result = run_lockstep(run);
  EXPECT_TRUE(result.completed) << result.cause;
  EXPECT_LE(report::figures(result, run.course).estimates[PoseSource::kModel]->max_position_error_m,
            0.010);
}

std::string without_time(report::RunResult result, const course::Course& course) {
  result.realtime_factor = 0.0;
  result.loop.clear();
  return report::result_json(result, report::figures(result, course));
}

TEST(Lockstep, OneSeedGivesOneResultAndAnotherSeedAnother) {
  LockstepSettings run = settings("1-curve", "end-loaded");
  const std::string first = without_time(run_lockstep(run), run.course);
  EXPECT_EQ(first, without_time(run_lockstep(run), run.course));
  run.seed = 2;
  EXPECT_NE(first, without_time(run_lockstep(run), run.course));
}

TEST(Lockstep, OnAStandTheVirtualRobotCompletesTheCourseAndTheBodyStays) {
  LockstepSettings run = settings("1-curve", "end-loaded");
  run.setup = bridge::Setup::kStand;
  const report::RunResult result = run_lockstep(run);
  EXPECT_TRUE(result.completed) << result.cause;
  EXPECT_NEAR(result.points.back().truth.y_m, 0.7, 0.03);
}

TEST(Lockstep, ARobotThatLeavesItsFenceIsStoppedAndTheCauseIsNamed) {
  LockstepSettings run = settings("1-curve", "end-loaded");
  run.course.fence.max_y_m = 0.3;
  const report::RunResult result = run_lockstep(run);
  EXPECT_FALSE(result.completed);
  EXPECT_EQ(result.cause, "fence");
}

TEST(Lockstep, ARobotWhoseSlipNobodyKnowsFinishesElsewhere) {
  LockstepSettings run = settings("1-straight", "end-loaded");
  run.robot.model = {};
  run.robot.emulated.body.track_deficit_left = run.robot.emulated.body.track_deficit_right = 0.4;
  const report::RunResult result = run_lockstep(run);
  EXPECT_TRUE(result.finished);
  EXPECT_FALSE(result.completed);
  EXPECT_EQ(result.cause, "ended too far from the end of the path");
}

TEST(Lockstep, AReversedMotorIsFoundBeforeTheRobotGetsFar) {
  LockstepSettings run = settings("1-straight", "end-loaded");
  run.robot.drive.invert_right_motor = true;
  const report::RunResult result = run_lockstep(run);
  EXPECT_FALSE(result.completed);
  EXPECT_FALSE(result.cause.empty());
  ASSERT_FALSE(result.points.empty());
  EXPECT_LT(std::abs(result.points.back().truth.x_m), 0.10) << result.cause;
}

TEST(Lockstep, AGyroOfTheWrongSignIsFound) {
  LockstepSettings run = settings("1-curve", "end-loaded");
  run.robot.model.gyro_scale = -1.0;
  const report::RunResult result = run_lockstep(run);
  EXPECT_FALSE(result.completed);
  EXPECT_FALSE(result.cause.empty());
}

}  // namespace
}  // namespace tp100::sim
