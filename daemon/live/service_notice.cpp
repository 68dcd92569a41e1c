#include "live/service_notice.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

#include "core/clock.h"
#include "text/format.h"
#include "text/standard_streams.h"

namespace tp100::live {
namespace {

constexpr std::chrono::milliseconds kLook{100};

/// 0 unless it is a whole number above 0.
std::int64_t number(std::string_view text) {
  return std::max<std::int64_t>(text::number_in<std::int64_t>(text).value_or(0), 0);
}

}  // namespace

ServiceSettings service_settings() {
  ServiceSettings settings;
  settings.socket = text::environment_variable("NOTIFY_SOCKET");
  const std::string guarded = text::environment_variable("WATCHDOG_PID");
  const std::int64_t us = number(text::environment_variable("WATCHDOG_USEC"));
  // Inherited from a parent that is itself watched, it does not apply to us.
  const bool ours = guarded.empty() || number(guarded) == ::getpid();
  if (ours && us < std::numeric_limits<HostNs>::max() / kNsPerUs)
    settings.watchdog_ns = us * kNsPerUs;
  return settings;
}

ServiceNotice::ServiceNotice(ServiceSettings settings) : settings_(std::move(settings)) {
  if (!settings_.socket.empty())
    socket_ = Descriptor(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
}

std::string ServiceNotice::ready() {
  if (settings_.socket.empty()) return {};
  const int error = send("READY=1");
  if (error == 0) return {};
  return "NOTIFY_SOCKET=" + settings_.socket + ": the service manager cannot be notified (" +
         std::strerror(error) + "); start the program by systemctl, or without that variable";
}

void ServiceNotice::status(const std::string& line) {
  if (line == status_) return;
  status_ = line;
  send("STATUS=" + line);
}

void ServiceNotice::alive(std::uint64_t cycles, HostNs now) {
  if (settings_.watchdog_ns == 0 || now < next_ns_ || cycles == cycles_) return;
  cycles_ = cycles;
  next_ns_ = now + settings_.watchdog_ns / 4;
  send("WATCHDOG=1");
}

bool ServiceNotice::wait(Time deadline, const std::function<bool(Time)>& done_by) {
  for (Time now = Time::clock::now(); !done_by(now + kLook); now = Time::clock::now()) {
    if (now >= deadline) return false;
    alive(cycles_ + 1, monotonic_now());
  }
  return true;
}

void ServiceNotice::stopping() { send("STOPPING=1"); }

// The errno of a failure, or 0.
int ServiceNotice::send(const std::string& text) const {
  sockaddr_un address{};
  const std::string& name = settings_.socket;
  if (!socket_) return ENOTSOCK;
  if (name.size() >= sizeof address.sun_path) return ENAMETOOLONG;
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), address.sun_path);
  if (name.front() == '@') address.sun_path[0] = '\0';
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
  const ssize_t sent =
      ::sendto(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT,
               reinterpret_cast<const sockaddr*>(&address), size);
  return sent < 0 ? errno : 0;
}

}  // namespace tp100::live
