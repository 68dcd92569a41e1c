#pragma once
// Notifies a service manager of the state of `tp100d run` over $NOTIFY_SOCKET (systemd:
// Type=notify, WatchdogSec). Never used by the real-time thread; never waits.

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
  explicit ServiceNotice(ServiceSettings settings);

  /// Reports that the program has started. Returns why this failed, or nothing.
  std::string ready();
  /// Reports the state in one line; an unchanged line is not sent again.
  void status(const std::string& line);
  /// Feeds the watchdog four times per period, but only if `cycles`, the real-time loop's count,
  /// has grown since: a hung loop gets the program killed.
  void alive(std::uint64_t cycles, HostNs now);
  void stopping();

 private:
  int send(const std::string& text) const;

  ServiceSettings settings_;
  std::string status_;
  std::uint64_t cycles_ = 0;
  HostNs next_ns_ = 0;
  Descriptor socket_;
};

/// Waits for disks when the loop has ended, and feeds the watchdog meanwhile.
class LastWait {
 public:
  /// The 5 s for all waits begin now; the unit's TimeoutStopSec is longer. `cycles`: the loop's
  /// last count.
  LastWait(ServiceNotice& notice, std::uint64_t cycles) : notice_(notice), cycles_(cycles) {}

  /// `done_by(deadline)` waits until the work is done. False: not within the 5 s.
  bool operator()(const std::function<bool(std::chrono::steady_clock::time_point)>& done_by);

 private:
  ServiceNotice& notice_;
  std::uint64_t cycles_;
  std::chrono::steady_clock::time_point deadline_ =
      std::chrono::steady_clock::now() + std::chrono::seconds(5);
};

}  // namespace tp100::live
