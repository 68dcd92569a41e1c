#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "model/climb_curve.h"
#include "report/metrics.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"
#include "sim/study/body_turn.h"
#include "sim/study/covariance_study.h"
#include "sim/study/state_study.h"
#include "terrain/terrain_follower.h"

namespace tp100::sim {
namespace {

// The long form, tp100-sim reproduce --part state, makes fifty flat runs and twenty over the
// obstacles.
TEST(State, HoldsItsLimitsOnTheFlatOverObstaclesAndOnTheStepWithoutSlip) {
  const std::vector<CourseStudy> studies = study_state(load({}).robot, 1, 1);
  ASSERT_EQ(studies.size(), 3u);
  EXPECT_EQ(studies[0].runs, 5);
  EXPECT_EQ(studies[1].runs, 2);
  for (const CourseStudy& study : studies) {
    EXPECT_EQ(study.completed, study.runs) << study.course;
    for (const Judged& one : study.judged)
      EXPECT_TRUE(one.holds()) << study.course << ": " << one.what << ' ' << one.ours.median;
  }
}

TEST(State, FindsEveryChangeOfTheCourseWithItsObstacles) {
  LockstepSettings run{
      .course = load_course("3"), .robot = load({}).robot, .setup = bridge::Setup::kTerrain};
  const report::RunResult result = run_lockstep(run);
  const report::SlopeFigures slope = report::figures(result, run.course).slope;
  // The state must change at least to up, to down and to level for each of the two obstacles.
  EXPECT_GE(slope.changes.size(), 6u);
  EXPECT_EQ(slope.obstacles, 2);
  EXPECT_EQ(slope.mistaken, 0);
  bool step = false, ramp = false;
  for (const report::TrajectoryPoint& point : result.points) {
    step = step || point.obstacle_class == ObstacleClass::kBlock;
    ramp = ramp || point.obstacle_class == ObstacleClass::kRamp;
  }
  EXPECT_TRUE(step);
  EXPECT_TRUE(ramp);
}

TEST(State, ABodyThatSlipsIsNotTheCaseWithoutSlip) {
  const course::Robot robot = load({}).robot;
  EXPECT_LT(check_climb_pitch(robot, 0.037, 0.1, 0.1).pitch_rms_rad, 0.035);
  // The check must fail with the model of another robot.
  course::Robot other = robot;
  other.shape.axle_spacing_m *= 1.15;
  EXPECT_GT(check_climb_pitch(other, 0.037, 0.1, 0.1).pitch_rms_rad, 0.035);
}

TEST(Climb, PhasesBeginWhereTheModelSaysAndTheirErrorsAddUp) {
  const course::Robot robot = load({}).robot;
  const ClimbCheck check = check_climb_pitch(robot, 0.037, 0.1, 0.1);
  using model::ClimbPhase;
  std::vector<ClimbPhase> phases;
  std::map<ClimbPhase, ClimbPhaseCheck> by_phase;
  for (const ClimbPhaseCheck& one : check.phases) {
    phases.push_back(one.phase);
    by_phase[one.phase] = one;
  }
  EXPECT_THAT(phases,
              testing::IsSupersetOf({ClimbPhase::kRiser, ClimbPhase::kWrap, ClimbPhase::kCross,
                                     ClimbPhase::kTip, ClimbPhase::kFlat, ClimbPhase::kNose}));
  EXPECT_TRUE(std::ranges::is_sorted(phases));
  const model::ClimbCurve curve(terrain::climb_geometry(robot.shape),
                                {.height_m = 0.037, .depth_m = 0.1}, model::RiserForm::kTrackHolds);
  constexpr double kStepM = 0.0001;
  EXPECT_NEAR(by_phase[ClimbPhase::kRiser].from_m, 0.0, 1.5 * kStepM);
  EXPECT_NEAR(by_phase[ClimbPhase::kWrap].from_m, curve.marks().riser_end, 1.5 * kStepM);
  EXPECT_NEAR(by_phase[ClimbPhase::kCross].from_m, curve.marks().wrap_end, 1.5 * kStepM);
  double squares = 0.0, count = 0.0, largest = 0.0;
  for (const ClimbSample& sample : check.samples) {
    const double off = sample.model_rad - sample.body_rad;
    // To the letter, until the axle is as high as the block.
    if (sample.phase == ClimbPhase::kRiser && sample.travel_m < 0.0109) {
      EXPECT_NEAR(sample.paper_rad, -std::asin(sample.travel_m / robot.shape.axle_spacing_m), 1e-9);
      EXPECT_NEAR(sample.model_rad, -curve.riser(sample.travel_m).angle_rad, 1e-9);
    }
    if (sample.phase == ClimbPhase::kCross) {
      squares += off * off;
      ++count;
    }
    largest = std::max(largest, std::abs(off));
  }
  EXPECT_NEAR(by_phase[ClimbPhase::kCross].model_rms_rad, std::sqrt(squares / count), 1e-12);
  EXPECT_NEAR(check.pitch_max_rad, largest, 1e-3);
  EXPECT_GT(by_phase[ClimbPhase::kRiser].paper_rms_rad, by_phase[ClimbPhase::kRiser].model_rms_rad);
}

// By eq 7 a robot on four points with this axle spacing and gauge has 0.2691 m.
TEST(BodyTurn, EndLoadedTracksTurnWithALongerWheelbaseThanEvenOnes) {
  const auto turns = [](const char* robot) {
    Options options;
    options.robot = robot;
    return measure_turns(load(options).robot.emulated);
  };
  const std::vector<BodyTurn> ends = turns("end-loaded"), even = turns("uniform");
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_NEAR(ends[0].wheelbase_m, 0.274, 0.006);
  EXPECT_NEAR(ends[1].wheelbase_m, 0.274, 0.004);
  EXPECT_NEAR(even[0].wheelbase_m, 0.205, 0.006);
  EXPECT_NEAR(even[1].wheelbase_m, 0.194, 0.004);
}

/// NIS of the camera over several runs together, and the confidence band for that many samples.
struct Consistency {
  double mean = 0.0;
  double half_band = 0.0;
};

Consistency consistency(const std::string& robot, double noise_factor) {
  Options options;
  options.robot = robot;
  LockstepSettings run{.course = load_course("1-curve"),
                       .robot = load(options).robot,
                       .camera = load_camera("overhead")};
  run.configuration.parameters.steering = PoseSource::kFused;
  run.camera->noise_m *= noise_factor;
  run.camera->noise_rad *= noise_factor;
  report::CameraFigures all;
  for (run.seed = 1; run.seed <= 3; ++run.seed) {
    const report::CameraFigures one = run_lockstep(run).camera;
    all.nis_mean =
        (all.nis_mean * all.judged + one.nis_mean * one.judged) / (all.judged + one.judged);
    all.judged += one.judged;
  }
  return {all.nis_mean, all.nis_half_band()};
}

// The filter allows for changing slip, which these runs do not have: it may be 5 % too cautious,
// but never overconfident.
TEST(CameraNoise, IsWhatTheFilterAssumesOnRobotsOfEveryKind) {
  constexpr double kCautious = 0.15;
  for (const char* robot : {"end-loaded", "uniform", "slippery"}) {
    const Consistency c = consistency(robot, 1.0);
    EXPECT_GT(c.mean, 3.0 - c.half_band - kCautious) << robot;
    EXPECT_LT(c.mean, 3.0 + c.half_band) << robot;
  }
}

// The short form of `tp100-sim reproduce --part covariance`. Forty draws of where the robot is
// placed: with half or twice the standard deviation the share would be 68 or 99.99 %.
TEST(Covariance, HoldsTheTruthAboutAsOftenAsItSays) {
  constexpr int kRuns = 40;
  for (const bool camera : {false, true}) {
    PerSource<report::Coverage> within;
    for (const TrialRun& run : run_trial({.course = load_course("1-curve"),
                               .robot = placed_by_hand(load({}).robot, true),
                               .runs = kRuns,
                               .both_directions = false,
                               .camera = camera})) {
      for (const PoseSource source : kPoseSources) {
        if (!run.figures.within_2_sd[source]) continue;
        within[source].position += run.figures.within_2_sd[source]->position / kRuns;
        within[source].yaw += run.figures.within_2_sd[source]->yaw / kRuns;
      }
    }
    for (const PoseSource source : kPoseSources) {
      if (needs_camera(source) && !camera) continue;
      EXPECT_GT(within[source].position, 0.90) << to_string(source);
      // A camera's constant error of 1.5 mm is never beyond it, whatever its direction.
      EXPECT_LT(within[source].position, needs_camera(source) ? 1.01 : 0.995) << to_string(source);
      EXPECT_GT(within[source].yaw, 0.90) << to_string(source);
      EXPECT_LT(within[source].yaw, 0.99) << to_string(source);
    }
  }
}

TEST(CameraNoise, ABetterOrWorseCameraLeavesTheBand) {
  const Consistency better = consistency("end-loaded", 0.8);
  EXPECT_LT(better.mean, 3.0 - 3.0 * better.half_band);
  const Consistency worse = consistency("end-loaded", 1.25);
  EXPECT_GT(worse.mean, 3.0 + 3.0 * worse.half_band);
}

}  // namespace
}  // namespace tp100::sim
