#pragma once
// How much data may be on its way to a viewer, so that what it shows is fresh: the buffers of a
// slow link hold seconds, and a socket does not tell. Pure; one thread; times are passed in.

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/time.h"

namespace tp100::server {

class LinkWindow {
 public:
  static constexpr double kFirstBytes = 65'536.0, kLeastBytes = 16'384.0, kMostBytes = 4'194'304.0;
  /// A link on which answers take this longer than at best is full.
  static constexpr HostNs kFullNs = 100 * kNsPerMs;
  static constexpr HostNs kPingNs = 250 * kNsPerMs;

  /// Whether more data may be sent; answers always may.
  bool open() {
    const bool open = static_cast<double>(sent_ - received_) < window_;
    limits_ = limits_ || !open;
    return open;
  }
  void sent(std::uint64_t bytes) { sent_ += bytes; }
  /// Call it after sending. True: send a ping now; its pong tells what has arrived.
  bool ping(HostNs now) {
    if (pinged_ || (now < at_ns_ + kPingNs && open())) return false;
    pinged_ = true;
    at_ns_ = now;
    marked_ = sent_;
    return true;
  }
  void pong(HostNs now) {
    if (!pinged_) return;
    pinged_ = false;
    const HostNs took_ns = now - std::exchange(at_ns_, now);
    const std::uint64_t came = marked_ - std::exchange(received_, marked_);
    const double rate_ps = static_cast<double>(came) / to_s(now - std::exchange(pong_ns_, now));
    least_ns_ = std::min(least_ns_, took_ns);
    const HostNs most_ns = least_ns_ + kFullNs;
    if (took_ns > most_ns) {
      window_ *= static_cast<double>(most_ns) / static_cast<double>(took_ns);
    } else if (limits_) {
      window_ = std::min(2.0 * window_, rate_ps * to_s(most_ns));
    }
    window_ = std::clamp(window_, kLeastBytes, kMostBytes);
    limits_ = false;
  }

 private:
  std::uint64_t sent_ = 0, received_ = 0, marked_ = 0;
  double window_ = kFirstBytes;
  HostNs at_ns_ = -kPingNs, pong_ns_ = 0;  // of the last ping or pong, and of the last pong
  HostNs least_ns_ = 3600 * kNsPerS;
  bool pinged_ = false, limits_ = false;
};

}  // namespace tp100::server
