// The uncertainty of dead reckoning with encoders alone.

#include "estimation/model_covariance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "any_motion.h"
#include "core/arithmetic.h"
#include "interval.h"
#include "model/track_model.h"

namespace tp100::estimation {
namespace {

using Errors = Eigen::Matrix<double, 5, 5>;

// The errors of x, y, yaw, slip and wheelbase move with the robot: a wrong yaw swings the way, slip
// shortens it, and a wrong wheelbase is a share of the turn.
TEST(ModelCovariance, AnIntervalMovesTheErrorsAndAddsItsNoise) {
  AnyMotion any(9);
  FilterParameters noise;
  noise.slip_s = 0.3;
  for (int i = 0; i < 300; ++i) {
    ModelCovariance covariance(uneven_tracks(), noise);
    CarriedModelCovariance carried;
    Errors errors = any.covariance().topLeftCorner<5, 5>();
    Eigen::Map<Errors>(carried.errors.data()) = errors;
    covariance.resume(carried);
    Motion motion = any.motion(any.chance(0.8));
    motion.disturbed = any.chance(0.1);
    motion.ground.pitch_rad = any.chance(0.2) ? 0.1 : 0.0;
    const double wheelbase_m = MotionModel(uneven_tracks(), noise).turn_of(motion).wheelbase_m;
    const double slip_sd = any.between(0.0, 0.03);
    Pose from{.x_m = 1.0, .y_m = 2.0, .yaw_rad = any.between(-7.0, 7.0)};
    for (int step = 0; step < 12; ++step) {
      const double dx = any.between(-0.03, 0.03), dy = any.between(-0.03, 0.03);
      const double turn = any.between(-0.2, 0.2), way = std::hypot(dx, dy);
      const Pose to{.x_m = from.x_m + dx, .y_m = from.y_m + dy, .yaw_rad = from.yaw_rad + turn};
      covariance.advance(from, to, motion, square(slip_sd));
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
      errors(2, 2) += square(2.0 / wheelbase_m * slip_sd) * 0.6 * way;
      errors(3, 3) += square(noise.slip_sd) * (1.0 - square(kept));
      const CarriedModelCovariance is = covariance.carried();
      ASSERT_LT((Eigen::Map<const Errors>(is.errors.data()) - errors).cwiseAbs().maxCoeff(), 1e-9);
      ASSERT_NEAR(covariance.pose().x_yaw, errors(0, 2), 1e-9);
      from = to;
    }
  }
}

/// `length_m` straight ahead at 0.15 m/s.
void drive(ModelCovariance& covariance, double length_m) {
  Pose pose;
  for (double m = 0.0; m < length_m; m += 0.15 * kDt) {
    const Pose before = pose;
    model::advance(pose, {.vx_mps = 0.15}, kDt);
    covariance.advance(before, pose, {.dt_s = kDt, .tracks = {0.15, 0.15}, .gyro = true},
                       square(0.01));
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
