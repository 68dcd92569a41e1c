#pragma once
// State of the link: the session's state, counters and the clock relation.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/enum_names.h"
#include "core/fields.h"
#include "core/time.h"

namespace tp100 {

/// States of a session, in the order in which a connection passes them.
enum class SessionState : std::uint8_t {
  kClosed,      ///< no port
  kListening,   ///< port open, silent until the robot's first frame (a bootloader must not receive
                ///< anything)
  kHello,       ///< hello requested
  kParameters,  ///< parameters sent, acknowledgement awaited
  kSyncing,     ///< samples flow, the clock relation is being found
  kReady,       ///< samples and commands flow
  kRefused,     ///< the robot uses another version
};

/// Names as printed in `state: A -> B`.
inline constexpr std::array<EnumName<SessionState>, 7> kSessionStateNames = {{
    {SessionState::kClosed, "closed"},
    {SessionState::kListening, "listening"},
    {SessionState::kHello, "hello"},
    {SessionState::kParameters, "parameters"},
    {SessionState::kSyncing, "syncing"},
    {SessionState::kReady, "ready"},
    {SessionState::kRefused, "refused"},
}};
constexpr std::string_view to_string(SessionState state) {
  return name_in(kSessionStateNames, state);
}

/// Counters since the start; every lost byte or frame is in exactly one of them.
struct LinkCounters {
  std::uint64_t bytes_in = 0, bytes_out = 0;
  std::uint64_t frames_in = 0, frames_out = 0;  ///< good frames
  std::uint64_t samples = 0;                    ///< samples handed on
  std::uint64_t early = 0;       ///< samples before the clock relation was known; not handed on
  std::uint64_t lost = 0;        ///< samples missing by sequence
  std::uint64_t duplicated = 0;  ///< samples with a sequence that was already handed on
  std::uint64_t reordered = 0;   ///< samples older than one already handed on
  std::uint64_t crc_errors = 0;
  std::uint64_t cobs_errors = 0;
  std::uint64_t oversize = 0;
  std::uint64_t undersize = 0;
  std::uint64_t unknown_type = 0;  ///< good frames of a type that a robot never sends
  std::uint64_t wrong_size = 0;    ///< good frames whose payload has another size than its type
  std::uint64_t implausible = 0;   ///< good frames with impossible values (time going back, ...)
  /// Bytes before the first good frame (boot banner, modem probe).
  std::uint64_t foreign_bytes = 0;
  std::uint64_t unwritten = 0;  ///< frames dropped because the port did not take them
  std::uint64_t sync_replies = 0, sync_rejected = 0;
  std::uint64_t reconnects = 0;     ///< sessions after the first one
  std::uint64_t reboots = 0;        ///< new boot nonce
  std::uint64_t silences = 0;       ///< no good frame within the time-out
  std::uint64_t unanswered = 0;     ///< frames came, but no answer for link.first_frame_timeout_ms
  std::uint64_t refused = 0;        ///< unknown hellos, parameters out of range
  std::uint64_t unknown_board = 0;  ///< hellos of a board that this version does not know
  std::uint64_t robot_faults = 0;   ///< faults that the robot reported
  /// Frames that the robot received corrupted, by its own count.
  std::uint64_t robot_corrupted = 0;
  std::uint64_t missed_edges = 0;  ///< of the encoders, by the robot's own count

  /// Frames that did not arrive as they were sent.
  std::uint64_t corrupted() const { return crc_errors + cobs_errors + oversize + undersize; }
};

TP100_FIELDS(LinkCounters, bytes_in, bytes_out, frames_in, frames_out, samples, early, lost,
             duplicated, reordered, crc_errors, cobs_errors, oversize, undersize, unknown_type,
             wrong_size, implausible, foreign_bytes, unwritten, sync_replies, sync_rejected,
             reconnects, reboots, silences, unanswered, refused, unknown_board, robot_faults,
             robot_corrupted, missed_edges)

/// Counts since `before`, an earlier state of the same counters.
inline LinkCounters operator-(LinkCounters now, LinkCounters before) {
  std::array<std::uint64_t, sizeof(LinkCounters) / sizeof(std::uint64_t)> earlier{};
  std::size_t i = 0;
  visit_fields([&](auto, std::uint64_t counter) { earlier[i++] = counter; }, before);
  i = 0;
  visit_fields([&](auto, std::uint64_t& counter) { counter -= earlier[i++]; }, now);
  return now;
}

/// Device clock against host clock: host_ns = reference_host_ns + (device - reference_us)(1 +
/// drift).
struct ClockState {
  bool valid = false;
  HostNs reference_host_ns = 0;
  DeviceUs reference_us = 0;
  double drift = 0.0;           ///< how much faster host time runs, e.g. 40e-6 for a slow crystal
  double uncertainty_us = 0.0;  ///< half the distance between the bounds of the fastest messages
                                ///< each way, aged
  /// Impossible clock values (a recording may hold any) are limited to +-kMaxTime instead of
  /// overflowing.
  HostNs to_host(DeviceUs device_us) const {
    return moved(reference_host_ns, difference(device_us, reference_us) * 1e3 * (1.0 + drift));
  }
  DeviceUs to_device(HostNs host_ns) const {
    return moved(reference_us, difference(host_ns, reference_host_ns) * 1e-3 / (1.0 + drift));
  }

 private:
  static double difference(std::int64_t a, std::int64_t b) {
    return static_cast<double>(
        static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b)));
  }
  static std::int64_t moved(std::int64_t from, double by) {
    return std::clamp(std::clamp(from, -kMaxTime, kMaxTime) + whole_time(by), -kMaxTime, kMaxTime);
  }
};

}  // namespace tp100
