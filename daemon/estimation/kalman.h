#pragma once
// The pose filter's state, the measurement update of a Kalman filter, and its check by NIS.
//
// The state is x, y, yaw of the reference point in the world, gyro bias, common slip, slip
// difference, turn gain, and the change of the bias with the gyro's temperature. Common slip c and
// slip difference d are beside the slip that the ground is expected to have: the left track covers
// (1 - c - d) of the expected distance, the right one (1 - c + d). The turn gain g is the error of
// the wheelbase: the tracks turn the robot by (1 + g) of the expected angle.
//
// What is observable:
// - By gyro and tracks: at rest the bias, in straight driving the sum of bias and slip difference,
//   and in a turn the sum of these and the turn gain: turns of different sharpness and both
//   directions tell them apart. Position, heading and common slip are not observable and drift.
// - By a camera: position and heading and, while the robot moves, the common slip; together with
//   the gyro, the slip difference and the bias.

#include <Eigen/Core>
#include <Eigen/LU>
#include <cstdint>

#include "core/arithmetic.h"
#include "core/estimates.h"

namespace tp100::estimation {

enum StateIndex : Eigen::Index {
  kX,
  kY,
  kYaw,
  kBias,
  kCommonSlip,
  kSlipDifference,
  kTurnGain,
  kBiasPerDegc,
  kStates
};

using StateVector = Eigen::Matrix<double, kStates, 1>;
using StateMatrix = Eigen::Matrix<double, kStates, kStates>;

/// The covariance of the pose, which is the first three of `covariance`'s errors.
template <int N>
PlanarCovariance pose_part(const Eigen::Matrix<double, N, N>& covariance) {
  return {.xx = covariance(kX, kX),
          .xy = covariance(kX, kY),
          .x_yaw = covariance(kX, kYaw),
          .yy = covariance(kY, kY),
          .y_yaw = covariance(kY, kYaw),
          .yaw_yaw = covariance(kYaw, kYaw)};
}

/// Adds to the variances of the pose in `covariance`.
template <int N>
void add_pose_variance(Eigen::Matrix<double, N, N>& covariance, double sd_m, double sd_rad) {
  covariance(kX, kX) += square(sd_m);
  covariance(kY, kY) += square(sd_m);
  covariance(kYaw, kYaw) += square(sd_rad);
}

/// Mean and covariance; yaw unwrapped. No allocation.
struct FilterState {
  StateVector mean = StateVector::Zero();
  StateMatrix covariance = StateMatrix::Zero();
};

/// A linear measurement of `Rows` values: innovation, Jacobian and noise.
template <int Rows>
struct Measurement {
  Eigen::Matrix<double, Rows, 1> innovation;  ///< measured - expected, angles wrapped
  Eigen::Matrix<double, Rows, kStates> jacobian;
  Eigen::Matrix<double, Rows, Rows> noise;
};

/// P H^T. The lazy product is faster for matrices as small as these.
template <int Rows>
Eigen::Matrix<double, kStates, Rows> covariance_with(const StateMatrix& covariance,
                                                     const Measurement<Rows>& seen) {
  return covariance.lazyProduct(seen.jacobian.transpose());
}

/// Covariance of the innovation, from P H^T.
template <int Rows>
Eigen::Matrix<double, Rows, Rows> innovation_covariance(
    const Eigen::Matrix<double, kStates, Rows>& with_seen, const Measurement<Rows>& seen) {
  return seen.jacobian.lazyProduct(with_seen) + seen.noise;
}

/// Normalized innovation squared: chi-squared with `Rows` degrees of freedom if all noise is as
/// assumed.
template <int Rows>
double normalized_innovation(const FilterState& state, const Measurement<Rows>& seen) {
  const Eigen::Matrix<double, Rows, Rows> inverse =
      innovation_covariance(covariance_with(state.covariance, seen), seen).inverse();
  return seen.innovation.dot(inverse * seen.innovation);
}

/// Updates mean and covariance; for the states before `first` only the covariance. The Joseph form
/// is right for any gain and keeps the covariance positive; averaging with its transpose keeps it
/// symmetric. No allocation.
template <int Rows>
void update(FilterState& state, const Measurement<Rows>& seen, Eigen::Index first = 0) {
  using StateByRow = Eigen::Matrix<double, kStates, Rows>;
  const StateByRow before = covariance_with(state.covariance, seen);
  const Eigen::Matrix<double, Rows, Rows> inverse = innovation_covariance(before, seen).inverse();
  StateByRow gain = before * inverse;
  gain.topRows(first).setZero();
  state.mean += gain * seen.innovation;
  // (I - K H) P (I - K H)^T + K R K^T from the left to the right: products of 8 x 8 matrices would
  // cost ten times as much.
  const StateMatrix left = state.covariance - gain * before.transpose();
  const StateByRow after = covariance_with(left, seen) - gain * seen.noise;
  const StateMatrix joseph = left - after * gain.transpose();
  state.covariance = 0.5 * (joseph + joseph.transpose());
}

/// Gates of a camera sample. Chi-squared with 3 degrees of freedom: one good sample in a hundred is
/// beyond the gate, one in a thousand beyond the trigger.
inline constexpr double kNisGate = 11.3;
inline constexpr double kNisTrigger = 16.3;

/// Mean of the NIS over many updates.
class NisMean {
 public:
  NisMean() = default;
  NisMean(std::uint32_t count, double sum) : count_(count), sum_(sum) {}

  void add(double nis) {
    ++count_;
    sum_ += nis;
  }
  std::uint32_t count() const { return count_; }
  double sum() const { return sum_; }
  double mean() const { return count_ == 0 ? 0.0 : sum_ / static_cast<double>(count_); }

 private:
  std::uint32_t count_ = 0;
  double sum_ = 0.0;
};

}  // namespace tp100::estimation
