#pragma once
// Finds, opens and reopens the port and hands its descriptor to the loop. Ticked by the Asio
// thread.

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/time.h"
#include "link/port_discovery.h"
#include "link/transport.h"
#include "loop/fixed_rate_loop.h"
#include "selftest/port_handover.h"

namespace tp100::live {

struct ConnectorSettings {
  /// Path, or auto: link::choose_for_auto(); once a robot was found, only its board.
  std::string port = "auto";
  link::PortOptions options{};
  bool wait = false;  ///< keep trying before the first hello, too
  /// Through which a check may ask for the port; null: none. Must outlive the connector.
  selftest::PortHandover* handover = nullptr;
};

class Connector {
 public:
  static constexpr HostNs kFirstRetryNs = 50 * kNsPerMs;
  static constexpr HostNs kLongestRetryNs = 2 * kNsPerS;

  /// `say` receives one line per event for the log; `loop` must outlive the connector's ticks.
  Connector(ConnectorSettings settings, loop::FixedRateLoop& loop,
            std::function<void(const std::string&)> say);

  /// Takes lost ports back and reopens when due. Throws UserError if no port can be opened and
  /// `wait` is off.
  void tick(HostNs now);
  /// The robot sent its hello: from now on the connector never gives up.
  void robot_found() {
    found_ = true;
    robot_ = opened_;
  }
  /// A session is ready: the next retry comes early again.
  void session_ready() { retry_ns_ = kFirstRetryNs; }
  /// The program is ending: opens no more ports. The port closes with the connector, after the
  /// loop.
  void stop() { stopped_ = true; }

  /// Whether the robot was plugged in, or in again, after the program's start.
  bool came_later() const { return came_later_; }
  /// Port in use, or the last one.
  const std::string& path() const { return path_; }
  bool pseudo_terminal() const { return pseudo_terminal_; }

 private:
  void take_back(const loop::LostPort& lost, HostNs now);
  void try_open(HostNs now);
  link::Port open_next();
  link::AutoChoice choose() const;
  bool handed_over() const { return settings_.handover != nullptr && settings_.handover->given(); }
  void say_once(const std::string& line);

  ConnectorSettings settings_;
  loop::FixedRateLoop& loop_;
  std::function<void(const std::string&)> say_;
  link::Port port_;
  std::string path_;
  std::string last_line_;
  // For "auto": the open port; the robot's port, once it sent hello; and the ports where no TP100
  // replied, by device file, which changes when they are replugged.
  std::optional<link::PortInfo> opened_, robot_;
  std::set<std::string> silent_;
  std::uint32_t id_ = 0;
  HostNs next_try_ns_ = 0;
  HostNs retry_ns_ = kFirstRetryNs;
  bool pseudo_terminal_ = false;
  bool found_ = false;
  bool stopped_ = false;
  bool came_later_ = false;
};

}  // namespace tp100::live
