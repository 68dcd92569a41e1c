#include "sim/lab/reproduce.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "course/path.h"
#include "identify/identify_report.h"
#include "model/track_model.h"
#include "sim/lab/calibration.h"
#include "sim/lab/constants_study.h"
#include "sim/lab/random_study.h"
#include "sim/lab/sampled.h"
#include "sim/robot/options.h"
#include "support/temporary_folder.h"
#include "terrain/climbable.h"

namespace tp100::sim {
namespace {

Trial one_run(const course::Course& course, bridge::Setup setup = bridge::Setup::kFlat) {
  return {.course = course,
          .robot = load({}).robot,
          .setup = setup,
          .runs = 1,
          .both_directions = false};
}

void expect_within_limits(const CourseStudy& study, int runs = 1) {
  EXPECT_EQ(study.completed, runs);
  EXPECT_FALSE(study.judged.empty());
  for (const Judged& one : study.judged) EXPECT_TRUE(one.holds()) << one.what << one.ours.median;
}

TEST(HeldOutCourse, CanBeDrivenWhateverTheSeed) {
  const course::Robot robot = load({}).robot;
  for (const char* kind :
       {"1-straight", "1-curve", "1-sharp", "2", "3", "spiral", "squares", "wide"}) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const course::Course course = held_out_course(kind, seed);
      SCOPED_TRACE(course.name);
      const course::Path path(course);
      for (double s = 0.0; s <= path.length_m(); s += 0.05) {
        EXPECT_GT(path.at(s).x_m, course.fence.min_x_m + 0.2);
        EXPECT_LT(path.at(s).y_m, course.fence.max_y_m - 0.2);
      }
      double last_m = 0.0;
      for (const course::Disturbance& disturbance : course.disturbances) {
        EXPECT_GT(disturbance.at_m, last_m);
        last_m = disturbance.at_m;
      }
      EXPECT_LT(last_m, path.length_m());
      EXPECT_NO_THROW(terrain::require_climbable(course, robot));
      EXPECT_EQ(path.length_m(), course::Path(held_out_course(kind, seed)).length_m());
    }
  }
  EXPECT_THROW(held_out_course("4", 1), UserError);
}

TEST(Reproduction, HasATrajectoryOfEveryStudyInAnyFolder) {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "with a space").string();
  run_reproduce({.out = out, .part = "paper", .runs = 1});
  EXPECT_TRUE(std::filesystem::exists(out + "/index.html"));
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(out))
    if (file.path().extension() == ".csv") names.push_back(file.path().stem().string());
  // The courses, course 3 without obstacles and on the stand, and three times without a camera.
  EXPECT_EQ(names.size(), 10U);
  EXPECT_THAT(names, testing::IsSupersetOf({"1-sharp-end-loaded-flat", "3-end-loaded-stand",
                                            "3-end-loaded-terrain-no-camera-15-18-s",
                                            "3-end-loaded-terrain-no-camera-28-31-s",
                                            "3-end-loaded-terrain-no-camera-33-36-s"}));
}

// The short form of `tp100-lab reproduce --part uneven`.
TEST(UnevenFloor, SeedsSpreadTheModelsErrorAndTheCameraKeepsThePose) {
  Trial trial = one_run(load_course("1-straight"));
  trial.runs = 4;
  const CourseStudy even = study(trial, "1-straight", true);
  trial.robot.emulated.floor = course::Floor::kUneven;
  const CourseStudy uneven = study(trial, "1-straight", true);
  EXPECT_TRUE(uneven.uneven && !even.uneven);
  expect_within_limits(uneven, 4);
  EXPECT_GT(errors_of(uneven, model::kExtendedForm.key)->max_position_error_m,
            5.0 * errors_of(even, model::kExtendedForm.key)->max_position_error_m);
}

TEST(SampledRobot, IsARobotThatAFileCouldHold) {
  const course::Robot reference = load({}).robot;
  for (std::uint64_t number = 0; number < 200; ++number) {
    const course::Robot robot = sampled_robot(reference, number);
    SCOPED_TRACE(robot.name);
    const std::string text = course::write_robot(robot, "");
    EXPECT_EQ(text, course::write_robot(sampled_robot(reference, number), ""));
    EXPECT_NE(text, course::write_robot(sampled_robot(reference, number + 1), ""));
    EXPECT_EQ(text, course::write_robot(course::parse_robot(text, robot.name + ".toml"), ""));
    EXPECT_EQ(robot.model.wheelbase_m, model::TrackParameters{}.wheelbase_m);
    EXPECT_LE(robot.emulated.body.gauge_m, robot.shape.gauge_m);
    EXPECT_GT(robot.emulated.body.gauge_m, 0.74 * robot.shape.gauge_m);
    EXPECT_GE(robot.emulated.body.mid_lift_m, 0.0);
    EXPECT_LE(robot.emulated.body.mid_lift_m, 0.0003);
    EXPECT_GE(robot.emulated.encoder.counts_per_metre, 2785.0);
    EXPECT_LE(robot.emulated.encoder.counts_per_metre, 22280.0);
  }
}

// MAXXII turns with 1.2 gauges and slips by 1 % straight on; another tracked robot with published
// figures turns with 0.97 gauges, the bundled ones with up to 1.8.
TEST(SampledRobot, RangesHoldRealRobots) {
  const auto range = [](Sampled what) { return kSampledRanges.at(static_cast<std::size_t>(what)); };
  EXPECT_LE(range(Sampled::kDeficit).low, 0.01);
  EXPECT_GE(range(Sampled::kDeficit).high, 0.20);
  const auto gauges = [](double gauge, double contact_gauge, double mid_lift_mm) {
    Loaded loaded = load({});
    loaded.robot.model = {};
    course::EmulatedBody& body = loaded.robot.emulated.body;
    loaded.robot.shape.gauge_m *= gauge;
    body.gauge_m *= gauge * contact_gauge;
    body.mid_lift_m = mid_lift_mm * 1e-3;
    return calibrate(loaded, 1, 1).found.extended[&model::TrackParameters::wheelbase_m].value /
           loaded.robot.shape.gauge_m;
  };
  EXPECT_LE(gauges(range(Sampled::kGauge).high, range(Sampled::kContactGauge).low,
                   range(Sampled::kMidLift).low),
            0.97);
  EXPECT_GE(gauges(range(Sampled::kGauge).low, range(Sampled::kContactGauge).high,
                   range(Sampled::kMidLift).high),
            1.8);
}

// The short form of `tp100-lab reproduce --part sampled`.
TEST(SampledRobot, IsPredictedOnceItIsIdentified) {
  Loaded loaded = load({});
  loaded.robot = sampled_robot(loaded.robot, 1);
  const Calibration calibration = calibrate(loaded, 1, 1);
  Trial trial = one_run(load_course("1-curve"));
  trial.robot = identify::identified_robot(calibration.found, loaded.robot, "");
  expect_within_limits(study(trial, "1-curve", false));
}

// The short form of `tp100-lab reproduce --body shear`.
TEST(ShearStudy, ARobotIsPredictedOnceItIsIdentifiedOnThatBody) {
  const test::TemporaryFolder folder;
  Options options;
  options.robot = "uniform";
  options.body = "shear";
  const Loaded loaded = load(options);
  Trial trial = one_run(load_course("1-curve"));
  trial.robot = calibrated_robot(loaded, 1, 1, folder.path().string());
  EXPECT_EQ(trial.robot.emulated.contact_law, course::ContactLaw::kShear);
  const TrialRun run = run_trial(trial).at(0);
  EXPECT_TRUE(run.result.completed) << run.result.cause;
  EXPECT_LE(run.figures.estimates[PoseSource::kModel]->max_position_error_m,
            0.008 * course::Path(trial.course).length_m());
  EXPECT_THROW(run_reproduce({.part = "paper", .body = "shear"}), UserError) << "it has no parts";
}

TEST(Study, JudgesModelEstimateAndTrackingByTheirOwnLimits) {
  const CourseStudy result = study(one_run(load_course("1-straight")), "1-straight", true);
  expect_within_limits(result);
  std::vector<std::string> what;
  for (const Judged& one : result.judged) what.push_back(one.what);
  EXPECT_THAT(what, testing::IsSupersetOf(
                        {"eqs 1-5 as printed max", "eqs 1-5 fitted max", "extended model max",
                         "odometry max", "fused max on the level", "tracking max", kFalseAlarms}));
  EXPECT_EQ(result.forms.size(), model::kBaselines.size() + kPoseSources.size());
  // A robot of which nothing was fitted has no figure of eqs 1-5.
  Trial unfitted = one_run(load_course("1-straight"));
  unfitted.robot.baselines = {};
  const CourseStudy without = study(unfitted, "1-straight", true);
  EXPECT_EQ(std::ranges::count(without.judged, "eqs 1-5 fitted max", &Judged::what), 0);
  EXPECT_EQ(errors_of(without, "eqs_1_5"), nullptr);
  EXPECT_NE(errors_of(without, "differential"), nullptr);
}

const Judged& judged(const CourseStudy& study, const std::string& what) {
  return *std::ranges::find(study.judged, what, &Judged::what);
}

TEST(Study, WithoutTheExtensionTheModelBreaksItsLimit) {
  for (const auto& [kind, robot] :
       {std::pair{"1-curve", "large"}, std::pair{"1-sharp", "uniform"}}) {
    SCOPED_TRACE(kind);
    Trial trial = one_run(load_course(kind));
    Options options;
    options.robot = robot;
    trial.robot = load(options).robot;
    const CourseStudy with = study(trial, kind, false);
    EXPECT_TRUE(judged(with, "extended model max").holds());
    EXPECT_TRUE(judged(with, "eqs 1-5 fitted max").holds());
    const double gyro_scale = trial.robot.model.gyro_scale;
    trial.robot.model = *trial.robot.baselines[model::kEqsFitted];
    trial.robot.model.gyro_scale = gyro_scale;
    const CourseStudy without = study(trial, kind, false);
    EXPECT_FALSE(judged(without, "extended model max").holds());
    // Then the model is eqs 1-5.
    EXPECT_NEAR(judged(without, "extended model max").ours.median,
                judged(without, "eqs 1-5 fitted max").ours.median, 0.02);
  }
}

TEST(Study, OneFalseAlarmInOneOfManyRunsIsTooMany) {
  CourseStudy study;
  std::vector<TrialRun> runs(5);
  EXPECT_TRUE(judged_false_alarms(study, runs).holds());
  runs[3].figures.tracking.false_alarms = 1;
  EXPECT_FALSE(judged_false_alarms(study, runs).holds());
  runs[4].figures.tracking.false_alarms = 2;
  EXPECT_EQ(judged_false_alarms(study, runs).ours.median, 3.0);
}

TEST(Study, OnObstaclesTheFusedPoseHasALimitOfItsOwn) {
  const CourseStudy result = study(one_run(load_course("3"), bridge::Setup::kTerrain), "3", true);
  expect_within_limits(result);
  EXPECT_GT(result.shown.fused_max_obstacle_m, result.shown.fused_max_flat_m);
}

TEST(Study, WithoutACameraForAWhileOnlyThatIsJudged) {
  Trial trial = one_run(load_course("1-straight"));
  trial.blind_from_s = 5.0;
  trial.blind_s = 3.0;
  const CourseStudy result = study(trial, "1-straight", true);
  ASSERT_EQ(result.judged.size(), 1u);
  EXPECT_EQ(result.judged[0].limit, 3.0);
  EXPECT_EQ(result.blind, "no camera 5-8 s");
}

class RandomCourse : public testing::TestWithParam<std::uint64_t> {};

// `tp100-lab reproduce --part random` is the long form.
TEST_P(RandomCourse, IsCompletedAndNoDeviationEscapesItsFigures) {
  const RandomDrive drive = drive_random(GetParam());
  if (!drive.refused.empty()) {
    EXPECT_NE(drive.refused.find("cannot be climbed"), std::string::npos) << drive.refused;
    return;
  }
  EXPECT_TRUE(drive.completed) << drive.robot << ": " << drive.cause;
  EXPECT_LT(drive.unreported_m, 0.002) << drive.robot << ", " << drive.deviation_m;
}

// Those above 39 once ended early: a steered straight taught a gain too low for the arc after it
// (60), and a turn that the path reverses counted as one against the command.
INSTANTIATE_TEST_SUITE_P(Seeds, RandomCourse,
                         testing::Values(1, 4, 9, 11, 13, 17, 20, 23, 26, 27, 43, 60, 161, 199),
                         testing::PrintToStringParamName());

TEST(RandomCourses, HoldEveryPartOfTheFormat) {
  std::set<std::size_t> segments;
  std::map<std::size_t, int> obstacles;
  int disturbances = 0, surfaces = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const course::Course course = random_course(seed);
    ASSERT_FALSE(course.path.empty());
    for (const course::Segment& segment : course.path) segments.insert(segment.index());
    disturbances += !course.disturbances.empty();
    surfaces += !course.terrain.surfaces.empty();
    for (const course::Obstacle& obstacle : course.terrain.obstacles) ++obstacles[obstacle.index()];
    for (const course::Disturbance& one : course.disturbances)
      EXPECT_LT(one.at_m, course::Path(course).length_m());
  }
  EXPECT_EQ(segments.size(), 3u);
  for (const int count : {disturbances, surfaces, obstacles[0], obstacles[1]}) EXPECT_GT(count, 25);
}

TEST(EquivalentWheelbase, IsThePrintedOneAndThatOfEquationSeven) {
  EXPECT_NEAR(equivalent_wheelbase_m({}), 0.2742, 5e-6);
  // b/2 - gamma dy = 0.08, a/2 - dx = 0.06, and 2 (0.08^2 + 0.06^2) / 0.08 = 0.25.
  EXPECT_NEAR(equivalent_wheelbase_m({.length_m = 0.14,
                                      .width_m = 0.18,
                                      .offset_x_m = 0.01,
                                      .offset_y_m = 0.005,
                                      .gamma = 2.0}),
              0.25, 1e-12);
}

using testing::HasSubstr;

Reproduction made_up(double fused_cm) {
  Reproduction what;
  what.reference = load({}).robot;
  what.runs = 1;
  for (const SlopeRow& row : slope_rows())
    what.slopes.push_back({row.slope_deg, row.paper_left.value_or(0.1) + 0.015,
                           row.paper_right.value_or(0.1), 0.0, true});
  CourseStudy one;
  one.course = "1-curve";
  one.robot = what.reference.name;
  one.setup = "flat";
  one.board = "native";
  one.runs = one.completed = 1;
  one.distance_m = 2.0;
  one.forms = {{"eqs_1_5", {.max_position_error_m = 0.05}},
               {"extended", {.max_position_error_m = 0.002, .max_yaw_error_rad = 0.01}}};
  one.judged.push_back(
      {"1-curve", one.robot, "fused max on the level", "cm", 0.6, {fused_cm, fused_cm, 1}});
  what.studies.push_back(one);
  return what;
}

TEST(Reproduction, SaysWhichLimitDoesNotHold) {
  EXPECT_TRUE(all_hold(made_up(0.5)));
  const Reproduction missed = made_up(0.7);
  EXPECT_FALSE(all_hold(missed));
  EXPECT_THAT(reproduction_table(missed), HasSubstr("DOES NOT HOLD"));
  const std::string page = reproduction_page(missed);
  EXPECT_THAT(page.substr(0, page.find("<h2")),
              HasSubstr("<p class='verdict bad'>1 of 2 limits hold; every run was completed. "
                        "Exceeded: 1-curve flat end-loaded fused max on the level."));
  EXPECT_THAT(page, HasSubstr("<td class='missed'>0.70</td><td>0.60</td>"
                              "<td class='missed t'>exceeded</td>"));
  const auto json = nlohmann::json::parse(reproduction_json(missed));
  EXPECT_EQ(json["all_hold"], false);
  EXPECT_EQ(json["studies"][0]["figures"][0]["holds"], false);
  EXPECT_NEAR(json["slope_max_difference"].get<double>(), 0.015, 1e-12);
  EXPECT_EQ(json["studies"][0]["paper"]["max_position_error_cm"], 1.2028);
  EXPECT_EQ(json["studies"][0]["forms"]["eqs_1_5"]["max_position_error_m"], 0.05);
  // Nor does a figure that is no number, or a run that was not completed.
  EXPECT_FALSE(all_hold(made_up(std::numeric_limits<double>::infinity())));
  EXPECT_FALSE(all_hold(made_up(std::numeric_limits<double>::quiet_NaN())));
  Reproduction aborted = made_up(0.5);
  aborted.studies[0].completed = 0;
  EXPECT_FALSE(all_hold(aborted));
}

TEST(Reproduction, OnAStandItShowsThePathAlone) {
  Reproduction what = made_up(0.5);
  for (int i = 0; i < 10; ++i) {
    report::TrajectoryPoint& point = what.studies[0].shown.result.points.emplace_back();
    point.t_s = i;
    point.truth.x_m = 0.1 * i;
  }
  what.studies.push_back(what.studies[0]);
  what.studies.back().setup = "stand";
  const std::string page = reproduction_page(what);
  const auto times = [&](const std::string& part) {
    int count = 0;
    for (std::size_t at = 0; (at = page.find(part, at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_EQ(times("aria-label='Path'"), 2);
  EXPECT_EQ(times("aria-label='Position error'"), 1) << "on a stand nothing is known of errors";
  EXPECT_EQ(times("Course 1-curve, stand: seed"), 1);
}

TEST(Reproduction, ShowsTheModelAsItIsJudgedRestartedAfterEachPush) {
  Reproduction what = made_up(0.5);
  report::RunResult& run = what.studies[0].shown.result;
  for (int i = 0; i < 10; ++i) {
    report::TrajectoryPoint& point = run.points.emplace_back();
    point.t_s = i;
    point.truth.x_m = point.estimates[PoseSource::kModel].x_m = 0.1 * i;
    // Pushed aside between 2.5 and 4.5 s, which the model does not see.
    if (i > 2) point.truth.y_m = i < 5 ? 0.05 * (i - 2) : 0.15;
  }
  const auto model = [](const report::TrajectoryPoint& point) -> const Pose& {
    return point.estimates[PoseSource::kModel];
  };
  run.disturbances = {{2.5, 4.5}};
  const report::RestartedPoses shown = report::restarted_poses(run.points, run.disturbances, model);
  EXPECT_EQ(shown.restarts, std::vector<std::size_t>{5});
  for (std::size_t i = 0; i < run.points.size(); ++i) {
    ASSERT_EQ(shown.poses[i].has_value(), i < 3 || i > 4) << i;
    if (!shown.poses[i]) continue;
    EXPECT_NEAR(shown.poses[i]->y_m, run.points[i].truth.y_m, 1e-12) << i;
  }
  EXPECT_NEAR(report::pose_errors(run.points, run.disturbances, model).max_position_error_m, 0.0,
              1e-12);
  const std::string page = reproduction_page(what);
  EXPECT_THAT(page, HasSubstr(">model, restarted<"));
  EXPECT_THAT(page, HasSubstr(">its restart<"));
  EXPECT_THAT(page, HasSubstr("reset to the truth"));
  run.disturbances.clear();
  EXPECT_THAT(reproduction_page(what), testing::Not(HasSubstr("model, restarted")));
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
