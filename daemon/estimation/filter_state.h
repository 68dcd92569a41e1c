#pragma once
// State of the pose filter: x, y, yaw of the reference point in the world, gyro bias, slip ratios.
//
// What can be seen of it:
// - Gyro and belts see the bias at rest, and while driving straight the difference of the slip
//   ratios (of right against left way). They see neither place nor direction nor the mean slip:
//   those only drift.
// - A camera sees place and direction and, while the robot moves, the mean slip; together with the
//   gyro both slip ratios and the bias.
// - The wheelbase cannot be told from the slip difference without turns in both directions; it is
//   not a state, its error is noise of the belts' yaw rate in turns.

#include <Eigen/Core>

namespace tp100::estimation {

enum StateIndex : Eigen::Index { kX, kY, kYaw, kBias, kSlipLeft, kSlipRight, kStates };

using StateVector = Eigen::Matrix<double, kStates, 1>;
using StateMatrix = Eigen::Matrix<double, kStates, kStates>;

/// Mean and covariance; yaw unwrapped. No allocation.
struct FilterState {
  StateVector mean = StateVector::Zero();
  StateMatrix covariance = StateMatrix::Zero();
};

}  // namespace tp100::estimation
