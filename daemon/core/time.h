#pragma once
// Time of the host and of the robot. Neither is ever the wall clock.

#include <cstdint>

namespace tp100 {

/// Host time: monotonic nanoseconds (CLOCK_MONOTONIC live, virtual time in lockstep).
using HostNs = std::int64_t;
/// Device time: the robot's microsecond clock extended to 64 bit, so that it never wraps.
using DeviceUs = std::int64_t;

inline constexpr HostNs kNsPerUs = 1'000;
inline constexpr HostNs kNsPerMs = 1'000'000;
inline constexpr HostNs kNsPerS = 1'000'000'000;

/// Nanoseconds as seconds.
inline constexpr double to_s(HostNs ns) { return static_cast<double>(ns) * 1e-9; }
/// Limit of times: impossible clock values (a recording may hold any number) are limited to it, so
/// that sums and differences of two of them do not overflow.
inline constexpr std::int64_t kMaxTime = std::int64_t{1} << 61;

/// A time or a difference of two, rounded towards zero, within +-kMaxTime.
inline constexpr std::int64_t whole_time(double value) {
  constexpr double kMax = static_cast<double>(kMaxTime);
  if (!(value > -kMax)) return -kMaxTime;
  return value < kMax ? static_cast<std::int64_t>(value) : kMaxTime;
}

/// Seconds as nanoseconds.
inline constexpr HostNs from_s(double s) { return whole_time(s * 1e9); }

}  // namespace tp100
