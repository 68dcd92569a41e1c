#include "loop/port_wait.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/signalfd.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

#include "core/clock.h"
#include "core/error.h"

namespace tp100::loop {
namespace {

sigset_t announcements() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGIO);
  return set;
}

/// Lets a terminal announce its bytes to this thread.
bool announce(int fd) {
  const f_owner_ex owner{F_OWNER_TID, ::gettid()};
  const int flags = ::fcntl(fd, F_GETFL);
  return flags >= 0 && ::fcntl(fd, F_SETOWN_EX, &owner) == 0 &&
         ::fcntl(fd, F_SETFL, flags | O_ASYNC) == 0;
}

}  // namespace

PortWait::PortWait(HostNs spare_ns)
    : spare_ns_(spare_ns), timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)) {
  const sigset_t set = announcements();
  if (timer_) signals_ = Descriptor(::signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC));
  if (!signals_)
    throw UserError(std::string("no timer for the real-time loop (") + std::strerror(errno) +
                    "); raise the limit of open files (ulimit -n)");
}

void PortWait::watch(int fd) {
  const sigset_t set = announcements();
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
  fd_ = fd;
  by_signal_ = ::isatty(fd) != 0 && announce(fd);
}

bool PortWait::readable(HostNs until) {
  if (rings_ns_ == 0 || rings_ns_ > until) set(until);
  std::array<pollfd, 2> of{
      {{by_signal_ ? signals_.get() : fd_, POLLIN, 0}, {timer_.get(), POLLIN, 0}}};
  if (::poll(of.data(), of.size(), -1) <= 0) return false;
  if (of[1].revents != 0) set(rings_ns_ < until ? until : monotonic_now() + spare_ns_);
  return of[0].revents != 0;
}

// Without an announcement FIONREAD costs nothing; after one it could wait for the worker that is
// still delivering.
bool PortWait::may_read() {
  if (!by_signal_ || take_signal()) return true;
  int bytes = 0;
  return ::ioctl(fd_, FIONREAD, &bytes) != 0 || bytes > 0;
}

bool PortWait::take_signal() {
  signalfd_siginfo info;
  return ::read(signals_.get(), &info, sizeof info) == sizeof info;
}

// Setting the timer also clears its expiration.
void PortWait::set(HostNs at) {
  rings_ns_ = std::max<HostNs>(at, 1);
  const itimerspec once{{}, {static_cast<time_t>(rings_ns_ / kNsPerS), rings_ns_ % kNsPerS}};
  ::timerfd_settime(timer_.get(), TFD_TIMER_ABSTIME, &once, nullptr);
}

}  // namespace tp100::loop
