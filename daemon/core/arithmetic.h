#pragma once
// Arithmetic whose results have the same last bits on every processor, and why. Sums, products and
// square roots are rounded alike everywhere (IEEE 754; the build neither fuses nor vectorises
// them). The C library's functions are rounded by its version and by whether the processor fuses
// multiplication and addition (FMA); with FMA those that are used here give equal bits on x86-64
// and 64-bit ARM, except std::hypot and std::cbrt, which are therefore not used.

#include <cmath>
#include <numbers>

namespace tp100 {

/// Length of a vector whose square a double can hold.
inline double magnitude(double x, double y) { return std::sqrt(x * x + y * y); }
inline double magnitude(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

inline double square(double value) { return value * value; }

/// In 95 of 100 cases a normally distributed value is within this many standard deviations.
inline constexpr double kNormal95 = 1.96;

/// Acceleration of the accelerometer's "g". [m/s^2]
inline constexpr double kStandardGravityMps2 = 9.80665;

// Angles in radians.

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kRadPerDeg = kPi / 180.0;
inline constexpr double kDegPerRad = 180.0 / kPi;

/// The same direction in [-pi, pi].
inline double wrap_angle(double rad) { return std::remainder(rad, 2.0 * kPi); }

/// The whole turns to add to an angle so that it comes nearest to `near_rad`.
inline double whole_turns(double rad, double near_rad) {
  return 2.0 * kPi * std::round((near_rad - rad) / (2.0 * kPi));
}

}  // namespace tp100
