#include "loop/pacing.h"

#include <time.h>

#include <cerrno>

#include "core/clock.h"

namespace tp100::loop {
namespace {

timespec to_timespec(HostNs ns) {
  return {static_cast<time_t>(ns / kNsPerS), static_cast<long>(ns % kNsPerS)};
}

}  // namespace

std::uint64_t Schedule::advance(HostNs now) {
  deadline_ns_ += period_ns_;
  if (deadline_ns_ > now) return 0;
  const HostNs missed = (now - deadline_ns_) / period_ns_ + 1;
  deadline_ns_ += missed * period_ns_;
  return static_cast<std::uint64_t>(missed);
}

void sleep_until(HostNs deadline) {
  if (deadline <= 0) return;
  const timespec at = to_timespec(deadline);
  while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) == EINTR) {
  }
}

void spin_until(HostNs deadline) {
  while (monotonic_now() < deadline) {
  }
}

}  // namespace tp100::loop
