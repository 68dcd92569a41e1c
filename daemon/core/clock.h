#pragma once
// The clocks of the host. Only the outer layers read them; nothing that computes a pose or a
// command does.

#include <time.h>

#include "core/time.h"

namespace tp100 {

/// Host time now: CLOCK_MONOTONIC. Any thread; safe in the real-time thread.
inline HostNs monotonic_now() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<HostNs>(now.tv_sec) * kNsPerS + now.tv_nsec;
}

/// Processor time that the calling thread has used. [ns]
inline HostNs thread_cpu_ns() {
  timespec used{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<HostNs>(used.tv_sec) * kNsPerS + used.tv_nsec;
}

/// Unix time now, by the wall clock, which may jump. [ns]
inline std::int64_t unix_now_ns() {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  return static_cast<std::int64_t>(now.tv_sec) * kNsPerS + now.tv_nsec;
}

}  // namespace tp100
