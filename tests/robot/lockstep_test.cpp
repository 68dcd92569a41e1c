// Whole runs in virtual time: the limits of model, fused pose and tracking on both boards and with
// every law, what ends a run, what repeats it, and what an overhead camera changes.
#include "sim/robot/lockstep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "core/error.h"
#include "report/result_text.h"
#include "runs.h"
#include "support/refusal.h"

namespace tp100::sim {
namespace {

// Sanitized builds run the same code about ten times slower, so they use fewer seeds.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uint64_t kSeeds = 1;
#else
constexpr std::uint64_t kSeeds = 3;
#endif
constexpr control::LawName kDefaultLaw = control::Parameters{}.law;

struct Case {
  std::string name, course, robot;
  std::uint64_t seeds = kSeeds;
  // Limits of medians over the seeds; 0: none, where the robot is pushed or slips in another way.
  double model_m = 0.0;     ///< largest error of the model
  double fused_m = 0.0;     ///< largest error of the fused pose
  double tracking_m = 0.0;  ///< largest distance from the path
  bool camera = false;      ///< steered by the fused pose of the overhead camera
  control::LawName law = kDefaultLaw;
};

void PrintTo(const Case& which, std::ostream* out) {
  *out << which.name << ' ' << which.course << ' ' << which.robot;
}

void expect_within(const std::vector<double>& errors, double limit) {
  if (limit > 0.0) {
    EXPECT_LE(median(errors), limit);
  }
}

class Courses : public testing::TestWithParam<Case> {};

TEST_P(Courses, AreCompletedForEverySeedAndKeepTheirLimits) {
  const Case& which = GetParam();
  const std::string board = which.name == "avr" ? "avr" : "native";
  LockstepSettings run = which.camera ? seen_run_of(which.course, which.robot)
                                      : run_of(which.course, which.robot, board);
  run.configuration.parameters.control.law = which.law;
  std::vector<double> model_m, fused_m, fused_rms_m, fused_yaw_rad, tracking_m;
  for (run.seed = 1; run.seed <= which.seeds; ++run.seed) {
    SCOPED_TRACE(testing::Message() << "seed " << run.seed);
    const report::RunResult result = run_lockstep(run);
    EXPECT_TRUE(result.completed) << result.cause;
    EXPECT_EQ(result.link.lost, 0u);
    EXPECT_EQ(result.link.crc_errors, 0u);
    const report::RunFigures figures = report::figures(result, run.course);
    model_m.push_back(figures.estimates[PoseSource::kModel]->max_position_error_m);
    tracking_m.push_back(figures.tracking.max_cross_track_m);
    if (!which.camera) continue;
    const report::PoseErrors& fused = *figures.estimates[PoseSource::kFused];
    fused_m.push_back(fused.max_position_error_m);
    fused_rms_m.push_back(fused.rms_position_error_m);
    fused_yaw_rad.push_back(std::sqrt(fused.mse_yaw_rad2));
    expect_recovered(figures.tracking, run.course);
  }
  expect_within(model_m, which.model_m);
  expect_within(tracking_m, which.tracking_m);
  if (!which.camera) return;
  expect_within(fused_m, which.fused_m);
  expect_within(fused_rms_m, 0.010);
  expect_within(fused_yaw_rad, 1.0 * kRadPerDeg);
}

std::vector<Case> on_board(const char* board, std::uint64_t seeds) {
  std::vector<Case> all = {{board, "1-straight", "end-loaded", seeds, 0.010},
                           {board, "1-curve", "end-loaded", seeds, 0.010},
                           {board, "1-sharp", "end-loaded", seeds, 0.030},
                           {board, "2", "end-loaded", seeds}};
  for (const char* course : {"1-straight", "1-curve", "1-sharp", "2"})
    all.push_back({board, course, "uniform", seeds});
  return all;
}

std::vector<Case> default_law(std::uint64_t seeds) {
  std::vector<Case> all;
  for (const char* robot : {"end-loaded", "uniform"}) {
    all.push_back({"default", "1-curve", robot, seeds, 0.0, 0.006, 0.008, true});
    all.push_back({"default", "2", robot, seeds, 0.0, 0.0, 0.0, true});
  }
  all.push_back({"default", "1-straight", "end-loaded", seeds, 0.0, 0.006, 0.008, true});
  all.push_back({"default", "1-sharp", "end-loaded", seeds, 0.0, 0.010, 0.015, true});
  return all;
}

std::vector<Case> all_laws() {
  std::vector<Case> all = default_law(kSeeds);
  for (const char* robot : {"front-heavy", "large", "slippery"})
    all.push_back({"default", "2", robot, 1, 0.0, 0.0, 0.0, true});
  for (const auto& [law, name] : control::kLawNames) {
    all.push_back({name, "3", "end-loaded", kSeeds, 0.0, 0.0, 0.015, true, law});
    if (law == kDefaultLaw) continue;
    all.push_back({name, "1-curve", "end-loaded", kSeeds, 0.0, 0.0, 0.008, true, law});
    all.push_back({name, "1-sharp", "end-loaded", kSeeds, 0.0, 0.0, 0.015, true, law});
    all.push_back({name, "2", "end-loaded", kSeeds, 0.0, 0.0, 0.0, true, law});
  }
  return all;
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
  return test_name(info.param.name + "_" + info.param.course + "_" + info.param.robot);
}

INSTANTIATE_TEST_SUITE_P(Flat, Courses, testing::ValuesIn(all_laws()), case_name);
INSTANTIATE_TEST_SUITE_P(NightlyFlat, Courses, testing::ValuesIn(default_law(10)), case_name);
INSTANTIATE_TEST_SUITE_P(Native, Courses, testing::ValuesIn(on_board("native", 3)), case_name);
INSTANTIATE_TEST_SUITE_P(NightlyNative, Courses, testing::ValuesIn(on_board("native", 10)),
                         case_name);
// Only builds that make the image can run it.
#ifdef TP100_HAS_IMAGE
INSTANTIATE_TEST_SUITE_P(Avr, Courses, testing::ValuesIn(on_board("avr", 1)), case_name);
INSTANTIATE_TEST_SUITE_P(NightlyAvr, Courses, testing::ValuesIn(on_board("avr", 5)), case_name);
#endif

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
  LockstepSettings run = run_of("3", "uniform");
  run.robot.emulated.contact_law = course::ContactLaw::kShear;
  run.setup = bridge::Setup::kTerrain;
  EXPECT_THROW(run_lockstep(run), UserError);
}

// What a person sets up wrongly ends the run, by name, before the robot is far. Other mistakes:
// whole_runs_test.
TEST(Lockstep, ARobotThatIsNotAsItsFileSaysDoesNotComplete) {
  LockstepSettings fence = run_of("1-curve"), slip = run_of("1-straight"), gyro = run_of("1-curve");
  fence.course.fence.max_y_m = 0.3;
  EXPECT_EQ(run_lockstep(fence).cause, "fence");

  slip.robot.model = {};
  slip.robot.emulated.body.track_deficit_left = slip.robot.emulated.body.track_deficit_right = 0.4;
  const report::RunResult elsewhere = run_lockstep(slip);
  EXPECT_TRUE(elsewhere.finished);
  EXPECT_FALSE(elsewhere.completed);
  EXPECT_EQ(elsewhere.cause, "ended too far from the end of the path");

  gyro.robot.model.gyro_scale = -1.0;
  EXPECT_FALSE(run_lockstep(gyro).completed);
}

TEST(CameraRun, ACameraChangesNothingOfARunThatOdometrySteers) {
  LockstepSettings run = seen_run_of("1-curve", "end-loaded", PoseSource::kOdometry);
  const auto text = [&run] {
    report::RunResult result = run_lockstep(run);
    result.realtime_factor = 0.0;
    result.loop.clear();
    auto json =
        nlohmann::json::parse(report::result_json(result, report::figures(result, run.course)));
    EXPECT_EQ(json.contains("fused"), run.camera.has_value());
    json.erase("fused");
    json.erase("camera");
    return json.dump();
  };
  const std::string seen = text();
  run.camera.reset();
  EXPECT_EQ(seen, text());
}

TEST(CameraRun, DetectionsOfThisDriveTakeTheEmulatedCamerasPlace) {
  constexpr std::size_t kEvery = 20;  // samples, of 200 a second
  LockstepSettings run = run_of("1-curve", "uniform");
  const report::RunResult blind = run_lockstep(run);
  for (std::size_t i = 0; i < blind.points.size(); i += kEvery) {
    const report::TrajectoryPoint& point = blind.points[i];
    run.detections.push_back({.x_m = point.truth.x_m,
                              .y_m = point.truth.y_m,
                              .yaw_rad = wrap_angle(point.truth.yaw_rad),
                              .measured_ns = from_s(point.t_s),
                              .sequence = static_cast<std::uint32_t>(i)});
  }
  const report::RunResult seen = run_lockstep(run);
  ASSERT_EQ(seen.points.size(), blind.points.size());
  EXPECT_EQ(seen.points.back().truth.x_m, blind.points.back().truth.x_m);
  EXPECT_TRUE(seen.has_camera);
  EXPECT_EQ(seen.camera.rejected, 0U);
  // But for those that are under way at the end.
  EXPECT_GE(seen.camera.used + 2, run.detections.size());
  const double fused_m = max_position_error_m(seen, run.course, PoseSource::kFused);
  EXPECT_LT(fused_m, 0.004);
  EXPECT_LT(fused_m, max_position_error_m(blind, run.course, PoseSource::kOdometry));
}

TEST(CameraRun, AStandIsNoPlaceForACamera) {
  LockstepSettings run = seen_run_of("1-curve", "end-loaded");
  run.setup = bridge::Setup::kStand;
  EXPECT_THROW(run_lockstep(run), UserError);
}

// Course 3, with the paper's step and ramp, where it is too much for a robot.
LockstepSettings course_3(bridge::Setup setup, const std::string& robot = "end-loaded") {
  LockstepSettings run = run_of("3", robot);
  run.setup = setup;
  return run;
}

double largest_nose_up_deg(const report::RunResult& result) {
  double largest = 0.0;
  for (const report::TrajectoryPoint& point : result.points)
    largest = std::max(largest, -point.truth.pitch_rad / kRadPerDeg);
  return largest;
}

TEST(Terrain, AStepThatThisRobotCannotClimbIsRefusedInEverySetUp) {
  for (const bridge::Setup setup :
       {bridge::Setup::kStand, bridge::Setup::kFlat, bridge::Setup::kTerrain}) {
    LockstepSettings run = course_3(setup);
    run.robot.shape.com_height_m = 0.030;
    EXPECT_THAT(test::refusal([&] { run_lockstep(run); }), testing::HasSubstr("limit is 33.4 mm"));
  }
}

TEST(Terrain, WithTooLittleFrictionTheRobotIsImmobilisedAndTheRunStops) {
  LockstepSettings run = course_3(bridge::Setup::kTerrain);
  run.robot.emulated.body.friction = 0.6;
  // The robot slides around before it is detected as immobilised. The firmware, which has no
  // terrain data, may take this for an encoder that loses counts.
  const auto stopped = testing::AnyOf("immobilised", "stalled_left", "stalled_right");
  const report::RunResult result = run_lockstep(run);
  EXPECT_THAT(result.cause, stopped);
  EXPECT_LT(largest_nose_up_deg(result), 5.0);

  run.camera = course::EmulatedCamera{};
  run.configuration.parameters.steering = PoseSource::kFused;
  EXPECT_THAT(run_lockstep(run).cause, stopped);
}

TEST(Terrain, ThreeSecondsWithoutACameraOverTheStepLeaveThePoseWithinThreeCentimetres) {
  LockstepSettings run = course_3(bridge::Setup::kTerrain);
  run.camera = course::EmulatedCamera{};
  run.camera->blind_from_s = 29.5;
  run.camera->blind_s = 3.0;
  const report::RunResult result = run_lockstep(run);
  ASSERT_TRUE(result.completed) << result.cause;
  EXPECT_LT(max_position_error_m(result, run.course, PoseSource::kFused), 0.03);
}

}  // namespace
}  // namespace tp100::sim
