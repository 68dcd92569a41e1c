// Small float helpers without libm.
#ifndef TP100_FIRMWARE_NUMBER_H
#define TP100_FIRMWARE_NUMBER_H

#include <stdint.h>
#include <string.h>

namespace tp100 {
namespace firmware {

const float kPi = 3.14159265f;

/// False for NaN and infinities too, because every comparison with NaN is false.
inline bool within(float value, float low, float high) { return value >= low && value <= high; }

inline float magnitude(float value) { return __builtin_fabsf(value); }

/// Limits to [-limit, limit], for limit >= 0. NaN becomes 0, because the result may move a motor.
/// It compares bit patterns, which are ordered like the magnitudes: comparing floats takes an AVR
/// four times as long.
inline float clamp(float value, float limit) {
  uint32_t bits;
  uint32_t limit_bits;
  memcpy(&bits, &value, sizeof bits);
  memcpy(&limit_bits, &limit, sizeof limit_bits);
  const uint32_t size_bits = bits & 0x7FFFFFFFUL;
  if (size_bits <= limit_bits) return value;
  const uint32_t infinity_bits = 0x7F800000UL;
  if (size_bits > infinity_bits) return 0.0f;
  return (bits >> 31) != 0 ? -limit : limit;
}

inline float smaller(float a, float b) { return a < b ? a : b; }
inline float larger(float a, float b) { return a > b ? a : b; }

/// The same angle in [-pi, pi], for |rad| < 1e4.
inline float wrap_angle(float rad) {
  const float turns = rad * (0.5f / kPi);
  const int32_t whole = static_cast<int32_t>(turns + (turns < 0.0f ? -0.5f : 0.5f));
  return rad - static_cast<float>(whole) * (2.0f * kPi);
}

/// a - b of wrapping counters, as a signed distance.
inline int32_t distance(uint32_t a, uint32_t b) { return static_cast<int32_t>(a - b); }
inline int32_t distance(int32_t a, int32_t b) {
  return static_cast<int32_t>(static_cast<uint32_t>(a) - static_cast<uint32_t>(b));
}

}  // namespace firmware
}  // namespace tp100

#endif
