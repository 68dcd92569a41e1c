// The motion model's functions against their definitions, written out once more.

#include "estimation/motion.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "any_motion.h"
#include "core/arithmetic.h"

namespace tp100::estimation {
namespace {

/// Each part of it shows within one interval.
FilterParameters loud_noise() {
  FilterParameters noise;
  noise.gyro_sd_rad_rts = 0.011;
  noise.gyro_scale_sd = 0.03;
  noise.gyro_scale_s = 1.7;
  noise.bias_walk_radps_rts = 0.013;
  noise.along_sd_m_rtm = 0.024;
  noise.across_sd_m_rtm = 0.017;
  noise.obstacle_sd_m_rtm = 0.035;
  noise.turn_sd_m_rtrad = 0.015;
  noise.slip_s = 0.6;
  noise.residual_window_s = 0.7;
  noise.residual_sd_radps = 3e-3;
  noise.edge_m = 1.0 / 700.0;
  noise.disturbance_sd_m = 0.021;
  noise.disturbance_sd_rad = 0.037;
  return noise;
}

class MotionModelTest : public testing::Test {
 protected:
  /// Calls check(state with the covariance 0, motion) for many of them, with and without a gyro.
  template <class Check>
  void for_many(Check check) {
    for (int i = 0; i < 1000; ++i) {
      SCOPED_TRACE(i);
      const FilterState state{any_.mean(), StateMatrix::Zero()};
      check(state, any_.motion(i % 2 == 0));
      if (HasFailure()) return;
    }
  }
  static bool moves(const Motion& motion) {
    return std::abs(motion.tracks.left_mps) + std::abs(motion.tracks.right_mps) > 0.004;
  }
  double kept(const Motion& motion) const {
    return motion.ground.hold_slip || !moves(motion) ? 1.0 : std::exp(-motion.dt_s / noise_.slip_s);
  }
  double along_m2(const Twist& twist, const Motion& motion) const {
    const double sd = motion.ground.hold_slip ? noise_.obstacle_sd_m_rtm : noise_.along_sd_m_rtm;
    // A body that tips over an edge faster than 0.1 rad/s moves along its tracks.
    const double tipping = std::max(0.0, motion.ground.tilt_radps - 0.1) * motion.dt_s;
    return motion.shift_scale * (square(sd) * std::abs(twist.vx_mps) * motion.dt_s +
                                 by_turning_m2(twist, motion) + square(0.01) * tipping);
  }
  double across_m2(const Twist& twist, const Motion& motion) const {
    return motion.shift_scale *
           (square(noise_.across_sd_m_rtm) * std::abs(twist.vx_mps) * motion.dt_s +
            by_turning_m2(twist, motion));
  }
  double by_turning_m2(const Twist& twist, const Motion& motion) const {
    return square(noise_.turn_sd_m_rtrad) * std::abs(twist.yaw_rate_radps) * motion.dt_s;
  }

  AnyMotion any_{3};
  model::TrackParameters tracks_ = uneven_tracks();
  FilterParameters noise_ = loud_noise();
  MotionModel model_{tracks_, noise_};
};

TEST_F(MotionModelTest, MovesTheRobotAsItsTracksAndItsGyroSay) {
  for_many([&](FilterState state, const Motion& motion) {
    const StateVector before = state.mean;
    const double left_share = 1.0 - before[kCommonSlip] - before[kSlipDifference];
    const double right_share = 1.0 - before[kCommonSlip] + before[kSlipDifference];
    const double left = motion.tracks.left_mps * (1.0 - motion.ground.slip.left) * left_share;
    const double right = motion.tracks.right_mps * (1.0 - motion.ground.slip.right) * right_share;
    const model::Turn turn = model::turn_of(tracks_, model::Mode::kExtended, motion.shape);
    Twist twist;
    twist.vx_mps = (left + right) / 2.0 * (1.0 - turn.slip);
    twist.yaw_rate_radps = motion.gyro
                               ? motion.gyro_z_radps - before[kBias]
                               : (right - left) / turn.wheelbase_m * (1.0 + before[kTurnGain]);
    const double slip_angle = model::slip_angle_rad(tracks_, turn, twist.yaw_rate_radps);
    twist.vy_mps = twist.vx_mps * std::tan(slip_angle) - turn.x_icr_m * twist.yaw_rate_radps;
    const Twist is = model_.twist(before, motion);
    EXPECT_NEAR(is.vx_mps, twist.vx_mps, 1e-12);
    EXPECT_NEAR(is.vy_mps, twist.vy_mps, 1e-12);
    EXPECT_NEAR(is.yaw_rate_radps, twist.yaw_rate_radps, 1e-12);
    const model::Slip slip = model_.slip(before, motion);
    EXPECT_NEAR(slip.left, 1.0 - (1.0 - motion.ground.slip.left) * left_share, 1e-12);
    EXPECT_NEAR(slip.right, 1.0 - (1.0 - motion.ground.slip.right) * right_share, 1e-12);

    model_.predict(state, motion);
    double x = before[kX], y = before[kY], yaw = before[kYaw];
    constexpr int kSteps = 100;
    const double dt = motion.dt_s / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      const double middle = yaw + twist.yaw_rate_radps * dt / 2.0;
      const double forward = twist.vx_mps * motion.ground.horizontal_fraction;
      x += (forward * std::cos(middle) - twist.vy_mps * std::sin(middle)) * dt;
      y += (forward * std::sin(middle) + twist.vy_mps * std::cos(middle)) * dt;
      yaw += twist.yaw_rate_radps * dt;
    }
    StateVector expected = before;
    expected[kX] = x;
    expected[kY] = y;
    expected[kYaw] = yaw;
    expected[kBias] += before[kBiasPerDegc] * motion.warming_degc;
    expected[kCommonSlip] *= kept(motion);
    EXPECT_LT((state.mean - expected).cwiseAbs().maxCoeff(), 1e-8);
  });
}

TEST_F(MotionModelTest, ATwistIsAsUncertainAsEdgesGyroAndShiftMakeIt) {
  for_many([&](const FilterState& state, const Motion& motion) {
    const Twist twist = model_.twist(state.mean, motion);
    const model::Turn turn = model_.turn_of(motion);
    const double dt = motion.dt_s, rate = std::abs(twist.yaw_rate_radps);
    // Each track begins and ends its interval between two edges.
    const double edges = square(noise_.edge_m / dt) / 6.0;
    const double by_tracks = square(noise_.track_error_radps + noise_.track_error_share * rate) +
                             2.0 * edges * square((1.0 + state.mean[kTurnGain]) / turn.wheelbase_m);
    const double by_gyro =
        square(noise_.gyro_sd_rad_rts) / dt + square(noise_.gyro_scale_sd * rate);
    const double turns = motion.gyro ? by_gyro : by_tracks;
    const double sideways = std::tan(model::slip_angle_rad(tracks_, turn, twist.yaw_rate_radps));
    const PlanarCovariance is = model_.twist_covariance(state, motion);
    EXPECT_NEAR(is.xx, edges / 2.0 + along_m2(twist, motion) / square(dt), 1e-9);
    EXPECT_NEAR(is.yaw_yaw, turns, 1e-9);
    EXPECT_NEAR(is.x_yaw, 0.0, 1e-12);
    EXPECT_NEAR(is.xy, sideways * edges / 2.0, 1e-9);
    EXPECT_NEAR(is.y_yaw, -turn.x_icr_m * turns, 1e-9);
    EXPECT_NEAR(is.yy,
                square(sideways) * edges / 2.0 + square(turn.x_icr_m) * turns +
                    across_m2(twist, motion) / square(dt),
                1e-9);
  });
}

TEST_F(MotionModelTest, OnlyLevelGroundWithoutAnObstacleShowsSlip) {
  constexpr double kNearly = 0.99 * kRadPerDeg, kMore = 1.01 * kRadPerDeg;
  EXPECT_TRUE(shows_slip({.roll_rad = -kNearly, .pitch_rad = kNearly}));
  EXPECT_FALSE(shows_slip({.hold_slip = true}));
  for (const double sign : {1.0, -1.0}) {
    EXPECT_FALSE(shows_slip({.roll_rad = sign * kMore}));
    EXPECT_FALSE(shows_slip({.pitch_rad = sign * kMore}));
  }
}

TEST_F(MotionModelTest, ADisturbanceMakesThePlaceUncertainAndTeachesNothingElse) {
  const auto expected = [](const StateMatrix& before, double sd_m, double sd_rad) {
    StateMatrix after = before;
    after.block<3, 5>(0, 3).setZero();
    after.block<5, 3>(3, 0).setZero();
    after(kX, kX) += square(sd_m);
    after(kY, kY) += square(sd_m);
    after(kYaw, kYaw) += square(sd_rad);
    return after;
  };
  const FilterState before{any_.mean(), any_.covariance()};
  FilterState state = before;
  model_.disturb(state);
  EXPECT_EQ(state.mean, before.mean);
  EXPECT_EQ(state.covariance,
            expected(before.covariance, noise_.disturbed_sd_m, noise_.disturbed_sd_rad));
  state = before;
  model_.measure(state, {.disturbed = true});
  EXPECT_EQ(state.covariance,
            expected(before.covariance, noise_.disturbance_sd_m, noise_.disturbance_sd_rad));
}

TEST_F(MotionModelTest, ARobotAtRestShowsItsBias) {
  const FilterState before{any_.mean(), any_.covariance()};
  FilterState state = before;
  model_.measure(state, {.rest = {.radps = before.mean[kBias] + 0.02, .sd_radps = 0.01}});
  const StateVector gain =
      before.covariance.col(kBias) / (before.covariance(kBias, kBias) + square(0.01));
  EXPECT_LT((state.mean - before.mean - gain * 0.02).norm(), 1e-12);
  const StateMatrix left = before.covariance - gain * before.covariance.row(kBias);
  EXPECT_LT((state.covariance - left).cwiseAbs().maxCoeff(), 1e-12);
}

// Only the bias is uncertain, so that what a residual does to it is a fraction.
TEST_F(MotionModelTest, AResidualCorrectsTheBiasByItsShareOfTheVariance) {
  for (int i = 0; i < 200; ++i) {
    Motion motion = any_.motion(true);
    motion.residual = {.left_radps = any_.between(-0.8, 0.8),
                       .right_radps = any_.between(-0.8, 0.8),
                       .gyro_z_radps = any_.between(-0.5, 0.5),
                       .variance = square(any_.between(1e-3, 0.1))};
    FilterState state{any_.mean(), StateMatrix::Zero()};
    state.covariance(kBias, kBias) = square(0.03);
    const double edges = std::sqrt(4.0 / 12.0) * noise_.edge_m /
                         (model_.turn_of(motion).wheelbase_m * noise_.residual_window_s);
    EXPECT_NEAR(model_.residual_sd_radps(motion), magnitude(noise_.residual_sd_radps, edges),
                1e-12);
    const double by_tracks = (motion.residual.right_radps *
                                  (1.0 - state.mean[kCommonSlip] + state.mean[kSlipDifference]) -
                              motion.residual.left_radps *
                                  (1.0 - state.mean[kCommonSlip] - state.mean[kSlipDifference])) *
                             (1.0 + state.mean[kTurnGain]);
    const double innovation = motion.residual.gyro_z_radps - by_tracks - state.mean[kBias];
    EXPECT_NEAR(model_.innovation_radps(state.mean, motion.residual), innovation, 1e-9);
    FilterState after = state;
    model_.measure(after, motion);
    const double share = square(0.03) / (square(0.03) + motion.residual.variance);
    EXPECT_NEAR(after.mean[kBias] - state.mean[kBias], share * innovation, 1e-9) << i;
  }
}

// A prior of another variance takes the place of the old one.
TEST_F(MotionModelTest, InformationThatIsTakenBackLeavesNothingBehind) {
  const FilterState before{any_.mean(), any_.covariance()};
  FilterState state = before;
  Motion motion = any_.motion(true);
  motion.residual = {.variance = 1e12, .slip_information = 300.0, .gain_information = 200.0};
  model_.measure(state, motion);
  EXPECT_LT(state.covariance(kSlipDifference, kSlipDifference),
            1.0 / (300.0 + 1.0 / before.covariance(kSlipDifference, kSlipDifference)) + 1e-9);
  motion.residual.slip_information *= -1.0;
  motion.residual.gain_information *= -1.0;
  model_.measure(state, motion);
  EXPECT_LT((state.mean - before.mean).tail<5>().cwiseAbs().maxCoeff(), 1e-8);
  const StateMatrix off = state.covariance - before.covariance;
  EXPECT_LT(off.bottomRows<5>().rightCols<5>().cwiseAbs().maxCoeff(), 1e-8);
}

constexpr double kStep = 1e-4;
constexpr double kFastestGround = 0.33;  // [m/s] with the least slip and the largest turn gain

class Jacobian : public testing::Test {
 protected:
  StateVector predicted(const StateVector& mean, const Motion& motion) const {
    FilterState state{mean, StateMatrix::Zero()};
    model_.predict(state, motion);
    return state.mean;
  }

  AnyMotion any_{3};
  FilterParameters noise_{};
  MotionModel model_{uneven_tracks(), noise_};
};

/// Central differences of `f`, a function of the state, column by column.
template <class F>
auto differences(const F& f, const StateVector& at) {
  using Value = decltype(f(at));
  Eigen::Matrix<double, Value::RowsAtCompileTime, kStates> result;
  for (Eigen::Index i = 0; i < kStates; ++i) {
    StateVector more = at, less = at;
    more[i] += kStep;
    less[i] -= kStep;
    result.col(i) = (f(more) - f(less)) / (2.0 * kStep);
  }
  return result;
}

TEST_F(Jacobian, OfThePredictionIsThatOfTheExactArc) {
  for (const bool gyro : {true, false}) {
    for (int round = 0; round < 2000; ++round) {
      FilterState state{any_.mean(), StateMatrix::Zero()};
      const StateVector mean = state.mean;
      const Motion motion = any_.motion(gyro);
      const Twist twist = model_.twist(mean, motion);
      // There is no Jacobian at the yaw rate at which the slip angle changes.
      if (std::abs(std::abs(twist.yaw_rate_radps) - 0.05) < 0.02) continue;
      const StateMatrix f =
          differences([&](const StateVector& at) { return predicted(at, motion); }, mean);
      model_.predict(state, motion);
      const StateMatrix noise = state.covariance, before = any_.covariance();
      state = {mean, before};
      model_.predict(state, motion);
      // The filter neglects that the chord is shorter than the arc, by a share of turn^2 / 24.
      const double turn = std::abs(twist.yaw_rate_radps) * motion.dt_s;
      const double stretch = std::max(1.0, std::abs(motion.ground.horizontal_fraction));
      const double way = std::hypot(twist.vx_mps * stretch, twist.vy_mps) * motion.dt_s;
      const double neglected =
          1e-9 + motion.dt_s * (turn * way / 8.0 + turn * turn / 20.0 * kFastestGround * stretch);
      const StateMatrix error = state.covariance - noise - f * before * f.transpose();
      ASSERT_LT(error.cwiseAbs().maxCoeff(), neglected * 2.0 * before.cwiseAbs().sum())
          << "round " << round << ", gyro " << gyro << "\n"
          << error;
    }
  }
}

Eigen::Matrix3d matrix_of(const PlanarCovariance& planar) {
  Eigen::Matrix3d matrix;
  matrix << planar.xx, planar.xy, planar.x_yaw,  //
      planar.xy, planar.yy, planar.y_yaw,        //
      planar.x_yaw, planar.y_yaw, planar.yaw_yaw;
  return matrix;
}

TEST_F(Jacobian, OfTheTwistsCovarianceIsThatOfTheTwist) {
  for (const bool gyro : {true, false}) {
    for (int round = 0; round < 2000; ++round) {
      FilterState state{any_.mean(), StateMatrix::Zero()};
      const Motion motion = any_.motion(gyro);
      const Twist twist = model_.twist(state.mean, motion);
      if (std::abs(std::abs(twist.yaw_rate_radps) - 0.05) < 0.02) continue;
      const auto by_state = differences(
          [&](const StateVector& at) {
            const Twist moved = model_.twist(at, motion);
            return Eigen::Vector3d(moved.vx_mps, moved.vy_mps, moved.yaw_rate_radps);
          },
          state.mean);
      const Eigen::Matrix3d noise = matrix_of(model_.twist_covariance(state, motion));
      state.covariance = any_.covariance();
      const Eigen::Matrix3d all = matrix_of(model_.twist_covariance(state, motion));
      const Eigen::Matrix3d error =
          all - noise - by_state * state.covariance * by_state.transpose();
      ASSERT_LT(error.cwiseAbs().maxCoeff(), 1e-9) << round << ", gyro " << gyro << "\n" << error;
      ASSERT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(noise).eigenvalues().minCoeff(),
                -1e-15)
          << round << "\n"
          << noise;
    }
  }
}

}  // namespace
}  // namespace tp100::estimation
