#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/lab/real_study.h"
#include "sim/lab/reproduce.h"

namespace tp100::sim {
namespace {

const std::vector<RealRobot>& robots() {
  static const std::vector<RealRobot> read = read_real_robots();
  return read;
}
const RealStudy& study_of(std::size_t robot) {
  static const std::vector<RealStudy> studies = {study_real(robots()[0]), study_real(robots()[1])};
  return studies[robot];
}
const RealStudy& maxxii() { return study_of(0); }
const RealStudy& husky() { return study_of(1); }

/// Track speeds of a real robot, with the motion that a form predicts for them plus noise.
RealRobot made_up(RealRobot robot, const SlipForm& form, const SlipConstants& constants,
                  double noise) {
  std::mt19937 random(7);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967295.0 - 0.5; };
  for (RealMotion& motion : robot.motions) {
    motion.truth = predicted(constants, form, motion);
    for (double& value : motion.truth) value += noise * uniform();
  }
  return robot;
}

SlipConstants known() {
  SlipConstants constants;
  constants.slip_left = 0.04;
  constants.slip_right = 0.07;
  constants.wheelbase_m = 0.8;
  constants.x_icr_m = 0.03;
  constants.turning_centre_left_m = -0.02;
  constants.slip_by_difference_spm = 0.1;
  constants.wheelbase_opposed_shift_m = 0.05;
  return constants;
}

SlipForm known_form() {
  return {"known",
          model::Mode::kExtended,
          {&SlipConstants::slip_left, &SlipConstants::slip_right, &SlipConstants::wheelbase_m,
           &SlipConstants::x_icr_m, &SlipConstants::turning_centre_left_m,
           &SlipConstants::slip_by_difference_spm, &SlipConstants::wheelbase_opposed_shift_m}};
}

TEST(FittedForm, RecoversKnownConstantsInsideItsIntervals) {
  const SlipForm form = known_form();
  for (const RealRobot& real : robots()) {
    const RealRobot robot = made_up(real, form, known(), 0.02);
    SlipConstants start;
    start.wheelbase_m = robot.gauge_m;
    const SlipFit found = fit(form, robot.motions, robot.gauge_m, start);
    ASSERT_EQ(found.fitted.size(), form.free.size());
    for (const FittedConstant& one : found.fitted) {
      const double off = found.constants.*one.constant - known().*one.constant;
      EXPECT_LT(std::abs(off), 1.5 * one.half_interval) << name_of(one.constant);
      EXPECT_LT(one.half_interval, 0.04) << name_of(one.constant);
      EXPECT_TRUE(one.shown) << name_of(one.constant);
    }
  }
}

TEST(FittedForm, SaysWhichConstantTheMotionsDoNotShow) {
  RealRobot robot = made_up(robots()[0], known_form(), known(), 0.02);
  std::erase_if(robot.motions, [](const RealMotion& motion) {
    const SensedSpeeds& speeds = motion.speeds.front();
    return speeds.left_mps * speeds.right_mps < 0.0;
  });
  const SlipFit found = fit(known_form(), robot.motions, robot.gauge_m, known());
  for (const FittedConstant& one : found.fitted)
    EXPECT_EQ(one.shown, one.constant != &SlipConstants::wheelbase_opposed_shift_m)
        << name_of(one.constant);
}

TEST(RealData, HoldsWhatItsPageSays) {
  ASSERT_EQ(robots()[0].motions.size(), 270u);
  ASSERT_EQ(robots()[1].motions.size(), 603u);
  double path_m = 0.0, turned_rad = 0.0;
  for (const RealMotion& motion : robots()[1].motions) {
    EXPECT_EQ(motion.speeds.size(), 39u);
    EXPECT_NEAR(motion.dt_s, 0.05, 1e-9);
    path_m += motion.path_m;
    turned_rad = std::max(turned_rad, std::abs(motion.truth[2]));
  }
  EXPECT_NEAR(path_m, 558.0, 1.0);
  EXPECT_LT(turned_rad, 2.5) << "yaw jumps by full turns in the file";
}

// Every friction between tracks and ground would then drive the turn on.
TEST(RealData, NoStationaryPointTurnsFasterThanItsTracks) {
  for (const RealMotion& motion : robots()[0].motions) {
    const double tracks_radps =
        (motion.speeds[0].right_mps - motion.speeds[0].left_mps) / robots()[0].gauge_m;
    if (std::abs(tracks_radps) < 0.1) continue;
    EXPECT_LT(motion.truth[2] / tracks_radps, 1.0) << motion.row << " " << motion.column;
  }
}

TEST(RealStudy, AgreesWithTheIndependentEvaluation) {
  EXPECT_NEAR(maxxii().figure(kPaperFitted, kYawRate), 10.4, 0.1);
  EXPECT_NEAR(maxxii().figure(kPaperFitted, kSpeed), 4.1, 0.05);
  // No slip over both halves, as there.
  const auto& halves = maxxii().forms[0].figures;
  EXPECT_NEAR((halves[0][0] + halves[1][0]) / 2.0, 22.0, 0.1);
  EXPECT_NEAR((halves[0][1] + halves[1][1]) / 2.0, 4.8, 0.05);
  EXPECT_LE(maxxii().figure(kPaperIcr, kLateral), 0.56);
  EXPECT_NEAR(husky().figure("wheelbase alone", kPosition), 29.4, 0.1);
  EXPECT_NEAR(husky().figure("wheelbase alone", kYaw), 10.8, 0.1);
  EXPECT_NEAR(husky().figure(kPaperFitted, kPosition), 24.1, 0.2);
  EXPECT_LE(husky().figure(kPaperFitted, kYaw), 11.2);
  EXPECT_NEAR(husky().figure(kPaperIcr, kPosition), 22.3, 0.4);
  EXPECT_LE(husky().figure(kPaperIcr, kYaw), 11.3);
  EXPECT_NEAR(husky().figure(kPaperGyro, kYaw), 4.7, 0.05);
}

TEST(RealStudy, BreakingAwayPaysOnMaxxiiAndTheLossOfTurnsOnTheHusky) {
  for (const std::size_t half : {0u, 1u}) {
    SCOPED_TRACE(half);
    EXPECT_LE(maxxii().forms.back().figures[half][0], 6.0);
    EXPECT_GT(maxxii().forms[4].figures[half][0], 7.9);
  }
  for (const char* form : {kBothSpeeds, kExtendedFitted}) {
    SCOPED_TRACE(form);
    EXPECT_LT(husky().figure(form, kPosition), 0.81 * husky().figure(kPaperIcr, kPosition));
  }
  EXPECT_TRUE(std::isnan(husky().figure(kBothSpeeds, kYawRate)));
}

TEST(RealStudy, EveryLimitHoldsAndWouldNotWithoutTheForm) {
  for (const RealStudy* study : {&maxxii(), &husky()}) {
    const CourseStudy result = judged(*study);
    EXPECT_GE(result.judged.size(), 4u);
    for (const Judged& one : result.judged) {
      EXPECT_TRUE(one.holds()) << one.what << " " << one.ours.median;
      EXPECT_LT(one.limit, 1.05 * one.ours.median + 0.06) << one.what;
    }
  }
}

}  // namespace
}  // namespace tp100::sim
