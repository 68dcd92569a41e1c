// Small number helpers without libm, for a float of the robot and a double of the host.
#ifndef TP100_SHARED_NUMBER_H
#define TP100_SHARED_NUMBER_H

#include <stdint.h>
#include <string.h>

namespace tp100 {
namespace shared {

const float kPi = 3.14159265f;

/// False for NaN and infinities too, because every comparison with NaN is false.
inline bool within(float value, float low, float high) { return value >= low && value <= high; }

inline float magnitude(float value) { return __builtin_fabsf(value); }
inline double magnitude(double value) { return __builtin_fabs(value); }

template <class Real>
Real smaller(Real a, Real b) {
  return a < b ? a : b;
}
template <class Real>
Real larger(Real a, Real b) {
  return a > b ? a : b;
}

/// Limits to [-limit, limit], for limit >= 0. NaN becomes 0, because the result may move a motor.
template <class Real>
Real clamp(Real value, Real limit) {
  if (value != value) return Real(0);
  return larger(-limit, smaller(limit, value));
}
/// Bits of |value|, ordered like the magnitudes, NaN last: comparing floats takes an AVR four times
/// as long.
inline uint32_t magnitude_bits(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof bits);
  return bits & 0x7FFFFFFFUL;
}
/// |value| <= limit, for limit >= 0; false for NaN.
inline bool limited(float value, float limit) {
  return magnitude_bits(value) <= magnitude_bits(limit);
}
inline float clamp(float value, float limit) {
  if (limited(value, limit)) return value;
  const uint32_t infinity_bits = 0x7F800000UL;
  if (magnitude_bits(value) > infinity_bits) return 0.0f;
  return __builtin_signbit(value) ? -limit : limit;
}

/// `balance` moved towards 0 by `by` >= 0, and not beyond.
template <class Real>
Real drained(Real balance, Real by) {
  if (balance > by) return balance - by;
  if (balance < -by) return balance + by;
  return Real(0);
}

/// From `a` to `b` while `value` goes from `low` to `high`, and constant beyond.
template <class Real>
Real between(Real value, Real low, Real high, Real a, Real b) {
  const Real share = (value - low) / (high - low);
  return a + (b - a) * larger(Real(0), smaller(Real(1), share));
}

/// The same angle in [-pi, pi], for |rad| < 1e4.
inline float wrap_angle(float rad) {
  if (limited(rad, kPi)) return rad;
  const float turns = rad * (0.5f / kPi);
  const int32_t whole = static_cast<int32_t>(turns + (turns < 0.0f ? -0.5f : 0.5f));
  return rad - static_cast<float>(whole) * (2.0f * kPi);
}

/// How far `newer` is ahead of `older`, two values of a counter that wraps: exact up to half its
/// range, negative if it is behind.
inline int16_t wrapped_difference(uint16_t newer, uint16_t older) {
  return static_cast<int16_t>(newer - older);
}
inline int32_t wrapped_difference(uint32_t newer, uint32_t older) {
  return static_cast<int32_t>(newer - older);
}
inline int32_t wrapped_difference(int32_t newer, int32_t older) {
  return wrapped_difference(static_cast<uint32_t>(newer), static_cast<uint32_t>(older));
}

}  // namespace shared
}  // namespace tp100

#endif
