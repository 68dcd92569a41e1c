#pragma once
// A session with the robot on a port, run by the calling thread: for commands of the program that
// examine a robot or test its tracks without the loop, the step and the server of a run. One
// thread.

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "core/sample.h"
#include "core/time.h"
#include "doctor/robot.h"
#include "link/session.h"
#include "link/transport.h"

namespace tp100::doctor {

class ProbeSession {
 public:
  /// `stop` ends every call of run(), and must outlive the session.
  ProbeSession(link::Port port, const link::SessionSettings& settings,
               const std::atomic<bool>& stop);
  ProbeSession(const ProbeSession&) = delete;
  ProbeSession& operator=(const ProbeSession&) = delete;

  /// Reads, replies and sends commands until `enough` holds, `limit_s` has passed, the port is gone
  /// or `stop` is set. Returns whether `enough` held.
  bool run(double limit_s, const std::function<bool()>& enough);

  /// Sets the command from now on, initially zero. An armed robot follows it.
  void command(double speed_mps, double yaw_rate_radps);
  /// Arms and waits. False: refused, or not acknowledged; see why() and fix().
  bool arm();
  /// Switches the motors off and waits for the acknowledgement or a timeout. Works after `stop`,
  /// too. False: not acknowledged.
  bool disarm();

  /// Measures the link for a while, as far as run() goes.
  LinkTest test_link(double duration_s);

  /// Called with each sample.
  std::function<void(const Sample&)> on_sample = [](const Sample&) {};

  const link::Session& session() const { return session_; }
  const Sample& newest() const { return newest_; }
  bool identified() const { return identified_; }  ///< a hello of any version arrived
  bool gone() const { return gone_; }
  /// Whether its motors were on for kUnaskedNs without a request of arm(). Sends STOP as long as
  /// they are.
  bool moved_unasked() const { return moved_unasked_; }
  const std::string& why() const { return why_; }
  const std::string& fix() const { return fix_; }
  /// Index of the parameter that the firmware refused; -1: none.
  int refused_parameter() const { return refused_parameter_; }

 private:
  void cycle_once();
  void read(HostNs now);
  void take(HostNs now);
  void note(const link::SessionEvent& event);
  void watch(const Sample& sample, HostNs now);
  void send(HostNs now);
  void write();

  link::Port port_;
  link::Session session_;
  const std::atomic<bool>& stop_;
  Sample newest_{};
  bool identified_ = false;
  bool gone_ = false;
  std::string why_;
  std::string fix_;
  int refused_parameter_ = -1;
  bool acknowledged_ = false;
  bool asked_ = false;  // arm() was called
  std::optional<HostNs> on_since_ns_;
  HostNs next_stop_ns_ = 0;
  bool moved_unasked_ = false;

  double speed_mps_ = 0.0;
  double yaw_rate_radps_ = 0.0;
  std::uint32_t session_number_ = 0;
  HostNs next_command_ns_ = 0;
  LinkMeter meter_{};
};

struct ProbeOptions {
  std::string port;
  link::PortOptions serial{};
  link::SessionSettings session{};
  double battery_cutoff_v = 0.0;
  double link_test_s = kLinkTestS;  ///< 0: no link test
};

/// Examines the robot on a port: identity, state, quality of the link. Nothing moves. Opening the
/// port resets a Mega; a silent one is given up after 5 s. Throws nothing: errors are
/// in the result.
ProbeResult probe_robot(const ProbeOptions& options, const std::atomic<bool>& stop);

}  // namespace tp100::doctor
