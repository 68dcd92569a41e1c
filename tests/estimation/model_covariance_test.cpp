// The uncertainty of dead reckoning with encoders alone, and of the floor's slip that it contains.

#include "estimation/model_covariance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "any_motion.h"
#include "core/arithmetic.h"
#include "interval.h"
#include "model/track_model.h"

namespace tp100::estimation {
namespace {

constexpr double kBaseM = 0.27;

TEST(FloorSlip, ARobotThatPausedWithinAPieceBeginsItAnew) {
  for (const auto& [pause_s, kept] : {std::pair{3.0, true}, std::pair{3.2, false}}) {
    FloorSlip slip{FilterParameters{}};
    slip.add(0.2, 0.026, 0.0, 0.0, kBaseM);
    slip.add(pause_s, 0.001, 0.0, 0.0, kBaseM);  // 1.5 s and 27 mm at 15 mm/s are 3.3 s
    slip.add(0.2, 0.025, 0.0, 0.0, kBaseM);
    EXPECT_EQ(slip.seen_m() > 0.02, kept);
  }
}

using Errors = Eigen::Matrix<double, 5, 5>;

// The errors of x, y, yaw, slip and wheelbase move with the robot: a wrong yaw swings the way, slip
// shortens it, and a wrong wheelbase is a share of the turn. Only undisturbed driving nearly
// straight on level ground, with a gyro, shows the slip of the floor.
TEST(ModelCovariance, AnIntervalMovesTheErrorsAddsItsNoiseAndShowsTheFloor) {
  AnyMotion any(9);
  FilterParameters noise;
  noise.slip_s = 0.3;
  int shown = 0;
  for (int i = 0; i < 300; ++i) {
    ModelCovariance covariance(uneven_tracks(), noise);
    CarriedModelCovariance carried{.slip_density_m = 3e-4, .seen_m = 0.5};
    Errors errors = any.covariance().topLeftCorner<5, 5>();
    Eigen::Map<Errors>(carried.errors.data()) = errors;
    covariance.resume(carried);
    FloorSlip floor(noise, 3e-4, 0.5);
    Motion motion = any.motion(any.chance(0.8));
    motion.disturbed = any.chance(0.1);
    motion.ground.pitch_rad = any.chance(0.2) ? 0.1 : 0.0;
    motion.shape.curved = any.chance(0.5) ? 0.59 : 0.61;
    const double wheelbase_m = MotionModel(uneven_tracks(), noise).turn_of(motion).wheelbase_m;
    const bool shows =
        motion.gyro && !motion.disturbed && shows_slip(motion.ground) && motion.shape.curved < 0.6;
    shown += shows ? 1 : 0;
    Pose from{.x_m = 1.0, .y_m = 2.0, .yaw_rad = any.between(-7.0, 7.0)};
    for (int step = 0; step < 12; ++step) {
      const double dx = any.between(-0.03, 0.03), dy = any.between(-0.03, 0.03);
      const double turn = any.between(-0.2, 0.2), way = std::hypot(dx, dy);
      const Pose to{.x_m = from.x_m + dx, .y_m = from.y_m + dy, .yaw_rad = from.yaw_rad + turn};
      covariance.advance(from, to, motion, 0.01);
      if (shows)
        floor.add(motion.dt_s, way, turn, (motion.gyro_z_radps - 0.01) * motion.dt_s, wheelbase_m);
      const double kept = kept_slip(noise, motion);
      Errors f = Errors::Identity();
      f.topRightCorner<2, 3>() << -dy, -dx, 0.0, dx, -dy, 0.0;
      f(2, 4) = turn;
      f(3, 3) = kept;
      errors = (f * errors * f.transpose()).eval();
      const ShiftVariance shift = shift_variance(noise, way, turn, motion);
      const double ahead = from.yaw_rad + turn / 2.0;
      const Eigen::Vector2d along(std::cos(ahead), std::sin(ahead)), across(-along[1], along[0]);
      errors.topLeftCorner<2, 2>() += shift.along_m2 * along * along.transpose() +
                                      shift.across_m2 * across * across.transpose();
      errors(2, 2) += square(2.0 / wheelbase_m) * floor.slip_density_m() * way;
      errors(3, 3) += square(noise.slip_sd) * (1.0 - square(kept));
      const CarriedModelCovariance is = covariance.carried();
      ASSERT_LT((Eigen::Map<const Errors>(is.errors.data()) - errors).cwiseAbs().maxCoeff(), 1e-9);
      ASSERT_NEAR(is.seen_m, floor.seen_m(), 1e-9) << i;
      ASSERT_NEAR(covariance.pose().x_yaw, errors(0, 2), 1e-9);
      from = to;
    }
  }
  EXPECT_GT(shown, 30);
}

/// `length_m` straight ahead at 0.15 m/s, over a floor on which the gyro shows a turn.
void drive(ModelCovariance& covariance, double length_m, double gyro_z_radps = 0.02) {
  Pose pose;
  for (double m = 0.0; m < length_m; m += 0.15 * kDt) {
    const Pose before = pose;
    model::advance(pose, {.vx_mps = 0.15}, kDt);
    covariance.advance(
        before, pose,
        {.dt_s = kDt, .tracks = {0.15, 0.15}, .gyro_z_radps = gyro_z_radps, .gyro = true}, 0.0);
  }
}

TEST(ModelCovariance, ARunBeginsAsTheRobotIsPlacedAndAnInterruptionAddsToIt) {
  const FilterParameters noise;
  ModelCovariance covariance({}, noise);
  drive(covariance, 1.0);
  ASSERT_GT(covariance.pose().yy, 2.0 * square(noise.start_sd_m));
  covariance.begin();
  EXPECT_EQ(covariance.pose().yy, square(noise.start_sd_m));
  covariance.interrupt();
  EXPECT_EQ(covariance.pose().yy, square(noise.start_sd_m) + square(noise.disturbed_sd_m));
  EXPECT_EQ(covariance.pose().yaw_yaw, square(noise.start_sd_rad) + square(noise.disturbed_sd_rad));
}

}  // namespace
}  // namespace tp100::estimation
