#include "loop/pacing.h"

#include <poll.h>
#include <sys/timerfd.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include "core/clock.h"
#include "core/error.h"

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
  if (policy_ == OverrunPolicy::kSkipMissed) {
    deadline_ns_ += missed * period_ns_;
  } else {
    deadline_ns_ = now + period_ns_;
  }
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

PortWait::PortWait(HostNs spare_ns)
    : spare_ns_(spare_ns), timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)) {
  if (timer_ < 0) {
    throw SetupError(std::string("no timer for the real-time loop (") + std::strerror(errno) +
                     "); raise the limit of open files (ulimit -n)");
  }
}

PortWait::~PortWait() { ::close(timer_); }

bool PortWait::readable(int fd, HostNs until) {
  if (rings_ns_ == 0 || rings_ns_ > until) set(until);
  std::array<pollfd, 2> of{{{fd, POLLIN, 0}, {timer_, POLLIN, 0}}};
  if (::poll(of.data(), of.size(), -1) <= 0) return false;
  if (of[1].revents != 0) set(rings_ns_ < until ? until : monotonic_now() + spare_ns_);
  return of[0].revents != 0;
}

// Setting the timer also clears its expiration.
void PortWait::set(HostNs at) {
  rings_ns_ = std::max<HostNs>(at, 1);
  const itimerspec once{{}, {static_cast<time_t>(rings_ns_ / kNsPerS), rings_ns_ % kNsPerS}};
  ::timerfd_settime(timer_, TFD_TIMER_ABSTIME, &once, nullptr);
}

}  // namespace tp100::loop
