#pragma once
// The yaw that another program means by a quaternion.

#include <cmath>
#include <optional>

#include "core/pose.h"

namespace tp100 {

/// The yaw of a robot that stands on its tracks; nothing: the length is not 1, or the robot lies on
/// its side or back, as it seems to where w comes first.
inline std::optional<double> upright_yaw(const Quaternion& q) {
  constexpr double kLengthError = 0.01;
  const double length = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  const double up = 1.0 - 2.0 * (q.x * q.x + q.y * q.y);
  if (!(std::abs(length - 1.0) <= kLengthError) || up <= 0.0) return std::nullopt;
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

}  // namespace tp100
