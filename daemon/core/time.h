#pragma once
// Time of the host and of the robot. Neither is ever the wall clock.

#include <concepts>
#include <cstdint>
#include <type_traits>

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
/// What no clock has (a recording may hold any number) ends here: sums and differences of two such
/// times still fit.
inline constexpr std::int64_t kMostTime = std::int64_t{1} << 61;

/// A time or a way between two, rounded towards zero, within +-kMostTime.
inline constexpr std::int64_t whole_time(double value) {
  constexpr double kMost = static_cast<double>(kMostTime);
  if (!(value > -kMost)) return -kMostTime;
  return value < kMost ? static_cast<std::int64_t>(value) : kMostTime;
}

/// Seconds as nanoseconds.
inline constexpr HostNs from_s(double s) { return whole_time(s * 1e9); }

/// How far `newer` is ahead of `older`, two values of a counter that wraps: exact up to half its
/// range, negative if it is behind.
template <std::unsigned_integral Counter>
constexpr std::make_signed_t<Counter> wrapped_difference(Counter newer, Counter older) {
  return static_cast<std::make_signed_t<Counter>>(static_cast<Counter>(newer - older));
}

}  // namespace tp100
