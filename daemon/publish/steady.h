#pragma once
// Host time as the real-time loop has it.

#include <ctime>

#include "core/time.h"

namespace tp100::publish {

/// CLOCK_MONOTONIC.
inline HostNs steady_now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<HostNs>(time.tv_sec) * kNsPerS + time.tv_nsec;
}

}  // namespace tp100::publish
