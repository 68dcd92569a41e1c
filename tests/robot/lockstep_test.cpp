// Whole runs in virtual time: the limits of the model on both boards, what ends a run, and what
// repeats it.
#include "sim/robot/lockstep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <vector>

#include "core/error.h"
#include "report/result_text.h"
#include "runs.h"
#include "support/refusal.h"

namespace tp100::sim {
namespace {

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
  LockstepSettings run = run_of(which.course, which.robot, which.board);
  std::vector<double> model_m;
  for (run.seed = 1; run.seed <= which.seeds; ++run.seed) {
    const report::RunResult result = run_lockstep(run);
    EXPECT_TRUE(result.completed) << "seed " << run.seed << ": " << result.cause;
    EXPECT_EQ(result.link.lost, 0u);
    EXPECT_EQ(result.link.crc_errors, 0u);
    model_m.push_back(max_position_error_m(result, run.course, PoseSource::kModel));
  }
  if (which.model_limit_m > 0.0) {
    EXPECT_LE(median(model_m), which.model_limit_m);
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

std::string course_case_name(const testing::TestParamInfo<Case>& info) {
  return test_name(std::string(info.param.course) + "_" + info.param.robot);
}

INSTANTIATE_TEST_SUITE_P(Native, Courses, testing::ValuesIn(cases("native", 3)), course_case_name);
INSTANTIATE_TEST_SUITE_P(NightlyNative, Courses, testing::ValuesIn(cases("native", 10)),
                         course_case_name);
// Only builds that make the image can run it.
#ifdef TP100_HAS_IMAGE
constexpr const char* kBoards[] = {"native", "avr"};
INSTANTIATE_TEST_SUITE_P(Avr, Courses, testing::ValuesIn(cases("avr", 1)), course_case_name);
INSTANTIATE_TEST_SUITE_P(NightlyAvr, Courses, testing::ValuesIn(cases("avr", 5)), course_case_name);
#else
constexpr const char* kBoards[] = {"native"};
#endif

TEST(Lockstep, TheDeviceClockWrapsWithoutAJump) {
  for (const char* board : kBoards) {
    SCOPED_TRACE(board);
    LockstepSettings run = run_of("1-curve", "end-loaded", board);
    // The run starts ten seconds before the wrap, at a multiple of the step of the board's timer.
    run.start_us = (0xFFFFFFFFu - 10'000'000u) / 1024u * 1024u;
    const report::RunResult result = run_lockstep(run);
    EXPECT_TRUE(result.completed) << result.cause;
    EXPECT_EQ(result.link.implausible, 0u);
    EXPECT_EQ(result.link.lost, 0u);
    EXPECT_EQ(result.link.crc_errors, 0u);
    EXPECT_LE(max_position_error_m(result, run.course, PoseSource::kModel), 0.010);
  }
}

// On an even floor seeds change noise only, and the model's error is the same in all of them.
TEST(Lockstep, ASeedDrawsAnUnevenFloorAndRepeatsIt) {
  LockstepSettings run = run_of("1-straight");
  const auto error_cm = [&](course::Floor floor, std::uint64_t seed) {
    run.robot.emulated.floor = floor;
    run.seed = seed;
    const report::RunResult result = run_lockstep(run);
    EXPECT_TRUE(result.completed) << result.cause;
    EXPECT_EQ(result.floor, to_string(floor));
    return max_position_error_m(result, run.course, PoseSource::kModel) * 100.0;
  };
  EXPECT_NEAR(error_cm(course::Floor::kEven, 1), error_cm(course::Floor::kEven, 2), 0.02);
  const double uneven_cm = error_cm(course::Floor::kUneven, 1);
  EXPECT_GT(std::abs(uneven_cm - error_cm(course::Floor::kUneven, 2)), 0.2);
  EXPECT_EQ(uneven_cm, error_cm(course::Floor::kUneven, 1));
}

TEST(Lockstep, OneSeedGivesOneResultAndAnotherSeedAnother) {
  LockstepSettings run = run_of("1-curve");
  const auto text = [&run] {
    report::RunResult result = run_lockstep(run);
    result.realtime_factor = 0.0;
    result.loop.clear();
    return report::result_json(result, report::figures(result, run.course));
  };
  const std::string first = text();
  EXPECT_EQ(first, text());
  run.seed = 2;
  EXPECT_NE(first, text());
}

// Floor and body are values of the robot's file, so a recording holds them too.
TEST(Options, FloorAndBodyAreValuesOfTheRobotsFile) {
  Options options;
  EXPECT_EQ(load(options).robot.emulated.floor, course::Floor::kEven);
  EXPECT_EQ(load(options).robot.emulated.contact_law, course::ContactLaw::kOde);
  options.floor = "uneven";
  options.body = "shear";
  options.robot_values = {{"emulated.shear.modulus_m", 0.005}};
  const Loaded loaded = load(options);
  EXPECT_EQ(loaded.robot.emulated.floor, course::Floor::kUneven);
  EXPECT_EQ(loaded.robot.emulated.contact_law, course::ContactLaw::kShear);
  EXPECT_EQ(loaded.robot.emulated.shear.modulus_m, 0.005);
  for (const char* line : {"floor = 'uneven'", "contact_law = 'shear'"})
    EXPECT_NE(loaded.files.robot.text.find(line), std::string::npos) << line;
  const auto refusal = [](const Options& of) -> std::string {
    return test::refusal([&] { load(of); });
  };
  options.body = "sheer";
  EXPECT_EQ(refusal(options), "--body sheer: not a body; use ode or shear");
  options.body = "shear";
  options.floor = "bumpy";
  EXPECT_EQ(refusal(options), "--floor bumpy: not a floor; use even or uneven");
}

TEST(Lockstep, OnlyTheBodyOfTheSimulatorClimbsARampThatIsReallyThere) {
  LockstepSettings run = run_of("1-curve", "uniform");
  run.robot.emulated.contact_law = course::ContactLaw::kShear;
  run.robot.model = {.slip_left = 0.001, .slip_right = 0.001, .wheelbase_m = 0.178};
  const report::RunResult result = run_lockstep(run);
  EXPECT_TRUE(result.completed) << result.cause;
  EXPECT_EQ(result.body, "shear");
  run.course = load_course("3");
  run.setup = bridge::Setup::kTerrain;
  EXPECT_THROW(run_lockstep(run), SetupError);
}

TEST(Lockstep, OnAStandTheVirtualRobotEndsAtTheEndOfThePath) {
  LockstepSettings run = run_of("1-curve");
  run.setup = bridge::Setup::kStand;
  const report::RunResult result = run_lockstep(run);
  EXPECT_TRUE(result.completed) << result.cause;
  EXPECT_NEAR(result.points.back().truth.y_m, 0.7, 0.03);
}

// What a person sets up wrongly ends the run, by name, before the robot is far.
TEST(Lockstep, ARobotThatIsNotAsItsFileSaysDoesNotComplete) {
  LockstepSettings fence = run_of("1-curve"), slip = run_of("1-straight"),
                   motor = run_of("1-straight"), gyro = run_of("1-curve");
  fence.course.fence.max_y_m = 0.3;
  EXPECT_EQ(run_lockstep(fence).cause, "fence");

  slip.robot.model = {};
  slip.robot.emulated.body.track_deficit_left = slip.robot.emulated.body.track_deficit_right = 0.4;
  const report::RunResult elsewhere = run_lockstep(slip);
  EXPECT_TRUE(elsewhere.finished);
  EXPECT_FALSE(elsewhere.completed);
  EXPECT_EQ(elsewhere.cause, "ended too far from the end of the path");

  motor.robot.drive.invert_right_motor = true;
  const report::RunResult reversed = run_lockstep(motor);
  EXPECT_FALSE(reversed.completed);
  EXPECT_FALSE(reversed.cause.empty());
  ASSERT_FALSE(reversed.points.empty());
  EXPECT_LT(std::abs(reversed.points.back().truth.x_m), 0.10) << reversed.cause;

  gyro.robot.model.gyro_scale = -1.0;
  const report::RunResult mirrored = run_lockstep(gyro);
  EXPECT_FALSE(mirrored.completed);
  EXPECT_FALSE(mirrored.cause.empty());
}

}  // namespace
}  // namespace tp100::sim
