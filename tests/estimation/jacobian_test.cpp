// Compares every Jacobian of the pose filter with central differences of its function.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "any_motion.h"
#include "core/arithmetic.h"
#include "estimation/motion.h"
#include "estimation/pose_filter.h"

namespace tp100::estimation {
namespace {

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

/// The effect of predict() on covariances without its noise. (F p)(F p)^T determines F except for
/// the signs of its columns; a p of two columns determines their relative sign as well.
class Used {
 public:
  Used(const MotionModel& model, const StateVector& mean, const Motion& motion)
      : model_(model), mean_(mean), motion_(motion), noise_(covariance(StateMatrix::Zero())) {}

  StateMatrix outer(const StateVector& p) const { return covariance(p * p.transpose()) - noise_; }

 private:
  StateMatrix covariance(const StateMatrix& before) const {
    FilterState state{mean_, before};
    model_.predict(state, motion_);
    return state.covariance;
  }

  const MotionModel& model_;
  StateVector mean_;
  Motion motion_;
  StateMatrix noise_;
};

TEST_F(Jacobian, OfThePredictionIsThatOfTheExactArc) {
  for (const bool gyro : {true, false}) {
    for (int round = 0; round < 2000; ++round) {
      const StateVector mean = any_.mean();
      const Motion motion = any_.motion(gyro);
      // There is no Jacobian at the yaw rate at which the slip angle changes.
      if (std::abs(std::abs(model_.twist(mean, motion).yaw_rate_radps) - 0.05) < 0.02) continue;
      const StateMatrix f =
          differences([&](const StateVector& at) { return predicted(at, motion); }, mean);
      const Used used(model_, mean, motion);
      // The filter neglects that the chord is shorter than the arc, by a share of turn^2 / 24.
      const Twist twist = model_.twist(mean, motion);
      const double turn = std::abs(twist.yaw_rate_radps) * motion.dt_s;
      const double stretch = std::max(1.0, std::abs(motion.ground.horizontal_fraction));
      const double way = std::hypot(twist.vx_mps * stretch, twist.vy_mps) * motion.dt_s;
      const double tolerance =
          1e-9 + motion.dt_s * (turn * way / 8.0 + turn * turn / 20.0 * kFastestGround * stretch);
      for (Eigen::Index i = 0; i < kStates; ++i) {
        for (Eigen::Index k = 0; k < kStates; ++k) {
          const StateVector p = StateVector::Unit(i) + (i == k ? 0.0 : 1.0) * StateVector::Unit(k);
          const StateVector moved = f * p;
          const StateMatrix error = used.outer(p) - moved * moved.transpose();
          ASSERT_LT(error.cwiseAbs().maxCoeff(), tolerance * (1.0 + moved.cwiseAbs().maxCoeff()))
              << "states " << i << " " << k << ", round " << round << ", gyro " << gyro << "\n"
              << error;
        }
      }
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

// Without common slip, which an error of the wheelbase in a turn would otherwise change.
TEST_F(Jacobian, OfTheResidualIsThatOfTheTracksYawRateAndTheBiasWithoutTheCommonSlip) {
  for (int round = 0; round < 2000; ++round) {
    FilterState state{any_.mean(), any_.covariance()};
    Motion motion = any_.motion(true);
    motion.slip_walk_rtm = any_.between(0.0, 0.01);
    motion.has_residual = true;
    const double base = model_.turn_of(motion).wheelbase_m;
    const TrackSpeeds speeds = expected_speeds(motion.tracks, motion.ground);
    motion.residual.left_radps = speeds.left_mps / base;
    motion.residual.right_radps = speeds.right_mps / base;
    const auto expected = [&](const StateVector& mean) {
      Motion by_tracks = motion;
      by_tracks.gyro = false;
      return Eigen::Matrix<double, 1, 1>(model_.twist(mean, by_tracks).yaw_rate_radps +
                                         mean[kBias]);
    };
    // The measurement equals its expected value, so that the gate accepts it.
    motion.residual.gyro_z_radps = expected(state.mean)[0];
    auto h = differences(expected, state.mean);
    h(kCommonSlip) = 0.0;
    const double rate = std::abs(motion.residual.gyro_z_radps - state.mean[kBias]);
    const Eigen::Matrix<double, 1, 1> r(std::pow(
        noise_.residual_sd_radps + (noise_.residual_share + motion.slip_walk_rtm) * rate, 2));
    // The gain leaves the place alone, so the covariance is not the least one.
    StateVector gain =
        state.covariance * h.transpose() / (h * state.covariance * h.transpose() + r)(0, 0);
    gain.head<2>().setZero();
    const StateMatrix left = StateMatrix::Identity() - gain * h;
    const StateMatrix right =
        left * state.covariance * left.transpose() + gain * r(0, 0) * gain.transpose();
    const StateVector before = state.mean;
    model_.measure(state, motion);
    ASSERT_LT((state.covariance - right).cwiseAbs().maxCoeff(), 1e-9) << round;
    ASSERT_LT((state.mean - before).cwiseAbs().maxCoeff(), 1e-9) << round;
  }
}

// The update takes the identity for the camera's Jacobian. On a slope the far end of the marker is
// nearer to the lens, so its direction depends on the place, most at the edge of the arena.
TEST_F(Jacobian, OfTheCameraIsTheIdentityOnTheLevelAndNearItOnASlope) {
  const CameraParameters camera{};
  Eigen::Matrix<double, 3, kStates> identity = Eigen::Matrix<double, 3, kStates>::Zero();
  identity.leftCols<3>().setIdentity();
  for (int round = 0; round < 2000; ++round) {
    StateVector mean = any_.mean();
    mean.head<2>() << any_.between(-0.95, 0.95), any_.between(-0.5, 0.5);
    Ground ground;
    const auto seen = [&](const StateVector& at) {
      return expected_marker(at.head<3>(), ground, camera, {});
    };
    const auto level = differences(seen, mean);
    EXPECT_LT((level - identity).cwiseAbs().maxCoeff(), 1e-8);
    ground.pitch_rad = any_.between(-28.0, 28.0) * kRadPerDeg;
    ground.z_m = any_.between(0.0, 0.08);
    const Eigen::Matrix<double, 3, kStates> off = differences(seen, mean) - identity;
    EXPECT_LT(off.topRows<2>().cwiseAbs().maxCoeff(), 0.08) << round;
    EXPECT_LT(off.row(2).cwiseAbs().maxCoeff(), 0.30) << round;
  }
}

}  // namespace
}  // namespace tp100::estimation
