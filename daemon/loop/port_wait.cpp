#include "loop/port_wait.h"

#include <poll.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include "core/clock.h"
#include "core/error.h"

namespace tp100::loop {

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

// Setting also takes back that it rang.
void PortWait::set(HostNs at) {
  rings_ns_ = std::max<HostNs>(at, 1);
  const itimerspec once{{}, {static_cast<time_t>(rings_ns_ / kNsPerS), rings_ns_ % kNsPerS}};
  ::timerfd_settime(timer_, TFD_TIMER_ABSTIME, &once, nullptr);
}

}  // namespace tp100::loop
