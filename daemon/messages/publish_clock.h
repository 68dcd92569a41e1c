#pragma once
// Host time as viewers and recordings see it: Unix time that never jumps, and seconds since the
// start.

#include "core/time.h"

namespace tp100::messages {

/// The wall clock is read once, at the start; from then on only monotonic time counts.
struct PublishClock {
  HostNs start_ns = 0;             ///< monotonic
  std::int64_t start_unix_ns = 0;  ///< the same instant, by the wall clock

  double t_s(HostNs at) const { return to_s(at - start_ns); }
  /// Never negative.
  std::uint64_t unix_ns(HostNs at) const {
    const std::int64_t unix = start_unix_ns + (at - start_ns);
    return unix < 0 ? 0 : static_cast<std::uint64_t>(unix);
  }
  HostNs host_ns(std::uint64_t unix_ns) const {
    return start_ns + (static_cast<std::int64_t>(unix_ns) - start_unix_ns);
  }
};

}  // namespace tp100::messages
