#pragma once
// Datagrams of an overhead camera to camera samples in host time. Fed bytes and time; it opens no
// socket. Input is hostile. Allocates while decoding: not for the real-time thread.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/camera_sample.h"
#include "link/camera_message.h"
#include "link/clock_offset.h"

namespace tp100::link {

/// What became of the datagrams, since the start.
struct CameraCounters {
  std::uint64_t received = 0;
  std::uint64_t accepted = 0;
  std::uint64_t malformed = 0;  ///< not of the format, or out of its ranges
  std::uint64_t late = 0;       ///< too old, or not newer than the one before
  std::uint64_t early = 0;      ///< stamped in the future: wrong clock
  std::uint64_t foreign = 0;    ///< of a second stream while the first one speaks
  std::uint64_t missing = 0;    ///< pictures that did not come: gaps in the sequence
  std::uint64_t dropped = 0;    ///< accepted, but the step had no room (counted by the caller)
  std::uint32_t streams = 0;    ///< senders so far, restarts included
};

class CameraIntake {
 public:
  /// `own_clock` is the name of our monotonic clock (see camera_message.h): stamps of that clock
  /// are taken as they are, others through an estimated offset. Older than `max_age_ns` is late.
  CameraIntake(std::string own_clock, HostNs max_age_ns);

  /// A datagram that arrived at `now`. Returns its sample if it may be used: in range, from the
  /// stream that speaks, newer than the one before, and taken between now - max_age and now.
  std::optional<CameraSample> receive(std::string_view datagram, HostNs now);

  const CameraCounters& counters() const { return counters_; }
  /// The step had no room for the last sample.
  void count_dropped() { ++counters_.dropped; }

 private:
  bool follow(const CameraMessage& message, HostNs now);
  HostNs host_time(const CameraMessage& message, HostNs now);

  std::string own_clock_;
  HostNs max_age_ns_;
  CameraCounters counters_{};
  ClockOffset offset_{};
  std::string clock_;
  std::uint32_t stream_ = 0;
  HostNs useful_ns_ = 0;  ///< when the stream was taken up, or last gave a sample
  std::optional<std::uint32_t> sequence_;
  HostNs measured_ns_ = 0;
};

}  // namespace tp100::link
