#pragma once
// Notifies a service manager of the state of `tp100d run` over $NOTIFY_SOCKET (systemd:
// Type=notify, WatchdogSec). Never used by the real-time thread; only wait() waits.

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "core/descriptor.h"
#include "core/time.h"

namespace tp100::live {

/// What a service manager passes to the programs that it starts.
struct ServiceSettings {
  std::string socket;      ///< path, or @name of an abstract socket; empty: no service manager
  HostNs watchdog_ns = 0;  ///< longest time between two watchdog messages; 0: no limit
};

/// Reads NOTIFY_SOCKET, WATCHDOG_USEC and WATCHDOG_PID of the environment.
ServiceSettings service_settings();

class ServiceNotice {
 public:
  using Time = std::chrono::steady_clock::time_point;

  explicit ServiceNotice(ServiceSettings settings);

  /// Reports that the program has started. Returns why this failed, or nothing.
  std::string ready();
  /// Reports the state in one line; an unchanged line is not sent again.
  void status(const std::string& line);
  /// Feeds the watchdog four times per period, but only if `cycles`, the real-time loop's count,
  /// has grown since: a hung loop gets the program killed.
  void alive(std::uint64_t cycles, HostNs now);
  /// After the loop's end: calls `done_by`, which waits until the time that it is passed, until it
  /// returns true, and feeds the watchdog in between. False: `deadline` passed first.
  bool wait(Time deadline, const std::function<bool(Time)>& done_by);
  void stopping();

 private:
  int send(const std::string& text) const;

  ServiceSettings settings_;
  std::string status_;
  std::uint64_t cycles_ = 0;
  HostNs next_ns_ = 0;
  Descriptor socket_;
};

}  // namespace tp100::live
