#pragma once
// Limits of a run that are no settings: what completes it, what counts as recovered, what ends it,
// and when motion without a request is noticed. The settings are in control/parameters.h.

#include <cstdint>

#include "core/arithmetic.h"
#include "core/time.h"

namespace tp100 {

// Completion.

/// A robot that moves more slowly stands still: its reference point by the steering pose's twist.
inline constexpr double kStandstillMps = 0.005;
inline constexpr double kStandstillRadps = 0.05;
/// How far from the end of the path a completed run may truly end.
inline constexpr double kEndToleranceM = 0.15;

// Recovery from a disturbance: this close to the path, for this long.

inline constexpr double kRecoveredM = 0.01;
inline constexpr double kRecoveredRad = 3.0 * kRadPerDeg;
inline constexpr double kRecoveredForS = 0.5;

// Interruption and end.

/// Without a newer sample a run ends: link_lost or samples_stale.
inline constexpr HostNs kSampleTimeoutNs = 200 * kNsPerMs;
/// IMU values of more samples ago are stale. The robot calls them so from kRobotStaleImu on: then
/// its own fault comes first.
inline constexpr std::uint8_t kOldestImu = 20, kRobotStaleImu = 10;
/// A longer pause ends the run.
inline constexpr double kLongestPauseS = 120.0;
/// A drive by hand without input for this long is over.
inline constexpr HostNs kDriveSilenceNs = 2 * kNsPerS;

/// Time beyond this between two steps was not observed: it does not count towards durations, and is
/// reported.
inline constexpr double kLongestSeenS = 0.05;

// Requests to the robot, and motion without one.

/// The link repeats a request for this long; without an acknowledgement by then it has failed.
inline constexpr HostNs kAnswerNs = 200 * kNsPerMs;
/// The motors must be on, or off, this long after the request.
inline constexpr double kOnWithinS = 1.0;
inline constexpr double kOffWithinS = 0.25;
/// Motors that are on for this long without a request move unasked; STOP is then sent again and
/// again.
inline constexpr HostNs kUnaskedNs = 50 * kNsPerMs;
inline constexpr HostNs kStopAgainNs = 200 * kNsPerMs;

/// No battery has so little left: it is off, and the board's own supply feeds the measured pin.
inline constexpr double kBatteryOffV = 4.0;

}  // namespace tp100
