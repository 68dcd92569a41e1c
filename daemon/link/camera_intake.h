#pragma once
// Turns the datagrams of a camera into samples and images in host time. It receives bytes and times
// and opens no socket. Input is hostile. Allocates while decoding: not for the real-time thread.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/fields.h"
#include "core/sample.h"
#include "link/camera_message.h"

namespace tp100::link {

/// Counts of the datagrams since the start, by outcome.
struct CameraCounters {
  std::uint64_t received = 0;
  std::uint64_t accepted = 0;
  std::uint64_t malformed = 0;  ///< malformed, or out of range
  std::uint64_t late = 0;       ///< too old, or not newer than the one before
  std::uint64_t early = 0;      ///< stamped in the future: wrong clock
  std::uint64_t foreign = 0;    ///< of a second stream while the first one is active
  std::uint64_t missing = 0;    ///< images not received: gaps in the sequence
  /// Detections: accepted, but the step had no room for them (counted by the caller). Images:
  /// valid, but more often than requested.
  std::uint64_t dropped = 0;
  std::uint32_t streams = 0;  ///< senders so far, restarts included
};
TP100_FIELDS(CameraCounters, received, accepted, malformed, late, early, foreign, missing, dropped,
             streams)

/// Difference between two monotonic clocks: receiver's minus sender's. Every datagram shows that
/// difference plus its transit time; the smallest value of the last seconds is from the datagram
/// that was delayed least. It is too large by the shortest transit time (local network: well below
/// a millisecond). Old values expire, so that drifting clocks are followed. No allocation.
class ClockOffset {
 public:
  /// A datagram left at `sent_ns`, sender's clock, and arrived at `received_ns`, ours.
  void add(HostNs sent_ns, HostNs received_ns) {
    const HostNs seen = received_ns - sent_ns;
    if (!current_ || received_ns - began_ns_ >= kWindowNs) {
      // After a long silence older values no longer count.
      if (current_ && received_ns - began_ns_ < 2 * kWindowNs) {
        previous_ = current_;
      } else {
        previous_.reset();
      }
      current_ = seen;
      began_ns_ = received_ns;
    }
    if (seen < *current_) current_ = seen;
  }
  void reset() {
    current_.reset();
    previous_.reset();
  }
  /// Offset to add to a time of the sender. 0 before the first datagram.
  HostNs offset_ns() const {
    if (!current_) return 0;
    return previous_ && *previous_ < *current_ ? *previous_ : *current_;
  }

 private:
  static constexpr HostNs kWindowNs = 5 * kNsPerS;
  std::optional<HostNs> current_, previous_;
  HostNs began_ns_ = 0;
};

/// An image and when it was taken.
struct CameraImage {
  HostNs taken_ns = 0;
  std::string jpeg;
};

/// Follows one stream, of detections or of images.
class CameraIntake {
 public:
  /// `own_clock` is the name of our monotonic clock (see camera_message.h): stamps of that clock
  /// are used as they are, others with an estimated offset. Datagrams older than `max_age_ns` are
  /// late.
  CameraIntake(std::string own_clock, HostNs max_age_ns);

  /// Takes a datagram received at `now`. Returns its sample if it may be used: in range, from the
  /// active stream, newer than the one before, and measured between now - max_age and now.
  std::optional<CameraSample> receive(std::string_view datagram, HostNs now);
  /// The same for an image; on average at most one in `interval_ns` is taken.
  std::optional<CameraImage> receive_image(std::string_view datagram, HostNs interval_ns,
                                           HostNs now);

  const CameraCounters& counters() const { return counters_; }
  /// Counts the last sample as dropped: the step had no room for it.
  void count_dropped() { ++counters_.dropped; }

 private:
  template <class Message>
  bool follow(const Message& message, HostNs now);
  template <class Message>
  HostNs host_time(const Message& message, HostNs now);
  /// When the message was measured, if it may be used.
  template <class Message>
  std::optional<HostNs> admit(const std::optional<Message>& message, HostNs now);

  std::string own_clock_;
  HostNs max_age_ns_;
  CameraCounters counters_{};
  ClockOffset offset_{};
  std::string clock_;
  std::uint32_t stream_ = 0;
  HostNs useful_ns_ = 0;  ///< when the stream became active, or last gave a sample
  std::optional<std::uint32_t> sequence_;
  HostNs measured_ns_ = 0;
  HostNs image_due_ns_ = 0;
};

}  // namespace tp100::link
