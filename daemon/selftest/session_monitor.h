#pragma once
// Collects what doctor needs to know of a robot from the session that the running daemon has with
// it: the port is never opened a second time. Pure; one thread.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/step_record.h"
#include "doctor/robot.h"
#include "link/session_event.h"
#include "wire/messages.h"

namespace tp100::selftest {

/// A port that the daemon has open, or had last.
struct OpenPort {
  std::string path{};  ///< empty: none yet
  bool pseudo_terminal = false;
};

class SessionMonitor {
 public:
  void on_event(const link::SessionEvent& event, const wire::Hello& hello, const OpenPort& port);
  /// Every step.
  void take(const StepRecord& record);

  /// Begins a probe at the next step.
  void begin();
  /// The probe, once: a second after it began or the session became ready, or five seconds after it
  /// began without a robot that is ready. Battery cut-off and the error of a port that is not open
  /// are left to the caller.
  std::optional<doctor::ProbeResult> done();

  const OpenPort& port() const { return port_; }
  SessionState session() const { return session_; }

 private:
  void follow(const StepRecord& record);

  OpenPort port_{};
  wire::Hello hello_{};
  bool identified_ = false;
  int refused_parameter_ = -1;
  SessionState session_ = SessionState::kClosed;

  std::uint64_t step_ = 0;
  std::uint32_t session_number_ = 0;
  doctor::LinkMeter meter_{};

  // State of a probe.
  enum class Probing { kNo, kAsked, kWaiting, kMeasuring, kDone };
  Probing probing_ = Probing::kNo;
  HostNs begun_ns_ = 0, ready_ns_ = 0, ended_ns_ = 0;
  LinkCounters before_{}, after_{};
  ClockState clock_{};
  Sample newest_{};
  bool has_sample_ = false;
  FaultMask faults_ = 0;
};

}  // namespace tp100::selftest
