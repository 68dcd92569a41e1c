#pragma once
// The clock of another machine, from datagrams that go one way only.

#include <optional>

#include "core/time.h"

namespace tp100::link {

/// Difference between two monotonic clocks: receiver's minus sender's. Every datagram shows that
/// difference plus its time on the way; the least of the last seconds is the one that was hardly
/// delayed. It stays too large by the shortest way (a local network: well below a millisecond).
/// Old figures go, so that drifting clocks are followed. No allocation.
class ClockOffset {
 public:
  /// A datagram left at `sent_ns`, sender's clock, and arrived at `received_ns`, ours.
  void add(HostNs sent_ns, HostNs received_ns) {
    const HostNs seen = received_ns - sent_ns;
    if (!current_ || received_ns - began_ns_ >= kWindowNs) {
      // After a long silence nothing older counts.
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
  /// Add it to a time of the sender. 0 before the first datagram.
  HostNs offset_ns() const {
    if (!current_) return 0;
    return previous_ && *previous_ < *current_ ? *previous_ : *current_;
  }

 private:
  static constexpr HostNs kWindowNs = 5 * kNsPerS;
  std::optional<HostNs> current_, previous_;
  HostNs began_ns_ = 0;
};

}  // namespace tp100::link
