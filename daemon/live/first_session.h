#pragma once
// The wait for the first session: until then a robot that cannot be used is an error, unless the
// program waits for a robot (--wait). Later it is an event like any other.

#include <string>

#include "core/link_state.h"
#include "live/connector.h"
#include "live/live_cycle.h"

namespace tp100::live {

class FirstSession {
 public:
  /// `connector` must outlive it; `robot` is the name for messages.
  FirstSession(const Connector& connector, const ConnectorSettings& settings, std::string robot)
      : connector_(connector),
        wait_(settings.wait),
        port_(settings.port),
        robot_(std::move(robot)) {}

  /// An event of the session. Throws UserError if it shows an incompatible robot.
  void on_event(const SessionReport& report) const;
  /// The session's state changed at `now`.
  void on_state(SessionState state, HostNs now);
  /// Time passes. Throws UserError if no session was established in time.
  void check(HostNs now) const;
  /// Another robot file is now in use.
  void expect(std::string robot) { robot_ = std::move(robot); }
  /// The program ends: nothing is an error from now on.
  void stop() { over_ = true; }

 private:
  const Connector& connector_;
  bool wait_;
  std::string port_;
  std::string robot_;
  SessionState state_ = SessionState::kClosed;
  HostNs tried_ns_ = 0;  // since when a port is open that is probably the robot's
  bool over_ = false;
};

}  // namespace tp100::live
