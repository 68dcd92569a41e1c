#pragma once
// The measurement update of a Kalman filter in Joseph form.

#include <Eigen/LU>

#include "estimation/filter_state.h"

namespace tp100::estimation {

/// A linear measurement of `Rows` values: innovation, Jacobian and noise.
template <int Rows>
struct Measurement {
  Eigen::Matrix<double, Rows, 1> innovation;  ///< measured - expected, angles wrapped
  Eigen::Matrix<double, Rows, kStates> jacobian;
  Eigen::Matrix<double, Rows, Rows> noise;
};

/// Covariance of the innovation.
template <int Rows>
Eigen::Matrix<double, Rows, Rows> innovation_covariance(const FilterState& state,
                                                        const Measurement<Rows>& seen) {
  return seen.jacobian * state.covariance * seen.jacobian.transpose() + seen.noise;
}

/// Normalized innovation squared: chi-squared with `Rows` degrees of freedom if all noise is as
/// assumed.
template <int Rows>
double normalized_innovation(const FilterState& state, const Measurement<Rows>& seen) {
  const Eigen::Matrix<double, Rows, Rows> inverse = innovation_covariance(state, seen).inverse();
  return seen.innovation.dot(inverse * seen.innovation);
}

/// Updates mean and covariance. Joseph form keeps the covariance positive, averaging with its
/// transpose symmetric. No allocation.
template <int Rows>
void update(FilterState& state, const Measurement<Rows>& seen) {
  const Eigen::Matrix<double, Rows, Rows> inverse = innovation_covariance(state, seen).inverse();
  const Eigen::Matrix<double, kStates, Rows> gain =
      state.covariance * seen.jacobian.transpose() * inverse;
  state.mean += gain * seen.innovation;
  const StateMatrix left = StateMatrix::Identity() - gain * seen.jacobian;
  const StateMatrix joseph =
      left * state.covariance * left.transpose() + gain * seen.noise * gain.transpose();
  state.covariance = (joseph + joseph.transpose()) / 2.0;
}

}  // namespace tp100::estimation
