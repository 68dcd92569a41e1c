#pragma once
// Finds, opens and reopens the port and lends its descriptor to the loop. Ticked by the Asio
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

namespace tp100::live {

struct ConnectorSettings {
  std::string port = "auto";  ///< path, or auto: link::choose_for_auto(), and after a robot was
                              ///< found that one only
  link::PortOptions options{};
  bool wait = false;     ///< do not give up before the first hello
  bool attended = true;  ///< no service: see link::choose_for_auto()
};

class Connector {
 public:
  static constexpr HostNs kFirstRetryNs = 50 * kNsPerMs;
  static constexpr HostNs kLongestRetryNs = 2 * kNsPerS;

  /// `say` gets one line for each thing worth a log line; `loop` must outlive the connector's
  /// ticks.
  Connector(ConnectorSettings settings, loop::FixedRateLoop& loop,
            std::function<void(const std::string&)> say);

  /// Takes lost ports back and opens again when it is time. Throws SetupError if there is no port
  /// to be had and nobody asked to wait.
  void tick(HostNs now);
  /// The robot said hello: from now on the connector waits whatever happens.
  void robot_found() {
    found_ = true;
    robot_ = opened_;
  }
  /// A session is ready: the next retry is quick again.
  void session_ready() { retry_ns_ = kFirstRetryNs; }
  /// The program ends: no more opening. The port closes with the connector, after the loop.
  void stop() { stopped_ = true; }

  /// Port in use, or the last one.
  const std::string& path() const { return path_; }
  bool pseudo_terminal() const { return pseudo_terminal_; }

 private:
  void take_back(const loop::LostPort& lost, HostNs now);
  void try_open(HostNs now);
  link::Port open_next();
  link::AutoChoice choose() const;
  void say_once(const std::string& line);

  ConnectorSettings settings_;
  loop::FixedRateLoop& loop_;
  std::function<void(const std::string&)> say_;
  link::Port port_;
  std::string path_;
  std::string last_line_;
  // By auto: which one is open; the robot's, once it said hello; and those on which nothing spoke
  // like a TP100, by device file, which is another one after they were plugged in again.
  std::optional<link::PortInfo> opened_, robot_;
  std::set<std::string> silent_;
  std::size_t candidates_ = 1;
  std::uint32_t id_ = 0;
  HostNs next_try_ns_ = 0;
  HostNs retry_ns_ = kFirstRetryNs;
  bool pseudo_terminal_ = false;
  bool found_ = false;
  bool stopped_ = false;
  bool several_said_ = false;
};

}  // namespace tp100::live
