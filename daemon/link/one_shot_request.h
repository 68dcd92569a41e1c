#pragma once
// One request (arm, disarm, stop) under way: repeated until acknowledged or given up. No
// allocation.

#include <cstdint>

#include "core/time.h"

namespace tp100::link {

inline constexpr HostNs kRequestRepeatNs = 30 * kNsPerMs;
inline constexpr HostNs kRequestLimitNs = 200 * kNsPerMs;

class OneShotRequest {
 public:
  /// Starts (or replaces) the request; `token` comes back in the acknowledgement.
  void start(std::uint32_t token, HostNs now) {
    token_ = token;
    started_ns_ = now;
    next_ns_ = now;
    pending_ = true;
    overdue_ = false;
  }
  void cancel() { pending_ = false; }

  /// True if a copy is to be sent now. After the limit copies come at the limit's interval.
  bool due(HostNs now) const { return pending_ && now >= next_ns_; }
  void sent(HostNs now) { next_ns_ = now + (overdue_ ? kRequestLimitNs : kRequestRepeatNs); }

  /// True once, when the limit has passed without an acknowledgement.
  bool take_overdue(HostNs now) {
    if (!pending_ || overdue_ || now - started_ns_ < kRequestLimitNs) return false;
    overdue_ = true;
    return true;
  }
  /// True, and the request is over, if `token` is its own.
  bool acknowledge(std::uint32_t token) {
    if (!pending_ || token != token_) return false;
    pending_ = false;
    return true;
  }

  bool pending() const { return pending_; }
  std::uint32_t token() const { return token_; }

 private:
  std::uint32_t token_ = 0;
  HostNs started_ns_ = 0;
  HostNs next_ns_ = 0;
  bool pending_ = false;
  bool overdue_ = false;
};

}  // namespace tp100::link
