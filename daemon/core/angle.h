#pragma once
// Angles in radians.

#include <cmath>
#include <numbers>

namespace tp100 {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kRadPerDeg = kPi / 180.0;
inline constexpr double kDegPerRad = 180.0 / kPi;

/// The same direction in [-pi, pi].
inline double wrap_angle(double rad) { return std::remainder(rad, 2.0 * kPi); }

}  // namespace tp100
