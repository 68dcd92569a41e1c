#pragma once
// What a service manager hears of `tp100d run` over $NOTIFY_SOCKET (systemd: Type=notify,
// WatchdogSec). Never used by the real-time thread; never waits.

#include <cstdint>
#include <string>

#include "core/time.h"

namespace tp100::live {

/// What a service manager says to the programs that it starts.
struct ServiceSettings {
  std::string socket;      ///< path, or @name of an abstract socket; empty: nobody listens
  HostNs watchdog_ns = 0;  ///< without a sign of life for this long the program is killed; 0: never
};

/// From NOTIFY_SOCKET, WATCHDOG_USEC and WATCHDOG_PID of the environment.
ServiceSettings service_settings();

class ServiceNotice {
 public:
  explicit ServiceNotice(ServiceSettings settings);
  ~ServiceNotice();
  ServiceNotice(const ServiceNotice&) = delete;
  ServiceNotice& operator=(const ServiceNotice&) = delete;

  /// The program has begun. Returns why nobody can be told so, or nothing.
  std::string ready();
  /// One line for who asks how it is; the same line again is not sent.
  void status(const std::string& line);
  /// Four times a watchdog's period says that the program lives, but only if `turns`, the real-time
  /// loop's so far, has grown since: who hangs there is killed.
  void alive(std::uint64_t turns, HostNs now);
  void stopping();

 private:
  int send(const std::string& text) const;

  ServiceSettings settings_;
  std::string status_;
  std::uint64_t turns_ = 0;
  HostNs next_ns_ = 0;
  int socket_ = -1;
};

}  // namespace tp100::live
