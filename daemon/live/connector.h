#pragma once
// Finds, opens and reopens the port and hands its descriptor to the loop. Until the first session a
// robot that cannot be used is an error, unless the program waits for one (--wait); later it is an
// event like any other. The main thread.

#include <optional>
#include <set>
#include <string>

#include "config/configuration.h"
#include "core/link_state.h"
#include "core/time.h"
#include "link/port_discovery.h"
#include "link/transport.h"
#include "live/event_log.h"
#include "live/live_controls.h"
#include "live/live_cycle.h"
#include "loop/fixed_rate_loop.h"
#include "selftest/port_handover.h"

namespace tp100::live {

class Connector {
 public:
  static constexpr HostNs kFirstRetryNs = 50 * kNsPerMs;
  static constexpr HostNs kLongestRetryNs = 2 * kNsPerS;

  /// Port auto: link::choose_for_auto(); once a robot was found, only its board. `wait`: keeps
  /// trying before the first hello, too. Through `handover` a check may ask for the port. Tells
  /// `log` and `controls` about the search for it. All must outlive the connector.
  Connector(const config::LinkSettings& link, bool wait, selftest::PortHandover& handover,
            loop::FixedRateLoop& loop, EventLog& log, LiveControls& controls);

  /// Takes lost ports back and reopens when due. Without `wait`, throws UserError if no port can
  /// be opened or no session was established in time.
  void tick(HostNs now);
  /// An event of the session with the robot of that name. Without `wait`, throws UserError if it
  /// shows an incompatible robot before the first session. After a hello the connector never gives
  /// up.
  void on_event(const SessionReport& report, const std::string& robot);
  /// The program is ending: opens no more ports, and nothing is an error any more. The port closes
  /// with the connector, after the loop.
  void stop() { stopped_ = true; }

  /// Whether the robot was plugged in, or in again, after the program's start.
  bool came_later() const { return came_later_; }
  SessionState session() const { return session_; }
  bool had_session() const { return had_session_; }  ///< one was ready
  /// Port in use, or the last one.
  const std::string& path() const { return path_; }
  bool pseudo_terminal() const { return pseudo_terminal_; }

 private:
  bool awaits_first() const { return !wait_ && !had_session_ && !stopped_; }
  void require_usable(const SessionReport& report, const std::string& robot) const;
  void take_back(const loop::LostPort& lost, HostNs now);
  void try_open(HostNs now);
  link::Port open_next();
  link::AutoChoice choose() const;
  bool handed_over() const { return handover_.given(); }
  void say_once(const std::string& line);

  const std::string wanted_;  // as link.port
  const link::PortOptions options_;
  const bool wait_;
  selftest::PortHandover& handover_;
  loop::FixedRateLoop& loop_;
  EventLog& log_;
  LiveControls& controls_;
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
  SessionState session_ = SessionState::kClosed;
  HostNs tried_ns_ = 0;  // since when a port is open that is probably the robot's
  bool pseudo_terminal_ = false;
  bool found_ = false;  // a robot sent its hello
  bool had_session_ = false;
  bool stopped_ = false;
  bool came_later_ = false;
};

}  // namespace tp100::live
