#include "live/live_events.h"

#include <utility>
#include <variant>

#include "core/arithmetic.h"
#include "core/board.h"
#include "core/faults.h"
#include "text/format.h"

namespace tp100::live {
namespace {

using messages::Event;
using Level = messages::Event::Level;

const char* request_name(wire::Type type) {
  switch (type) {
    case wire::Type::kParameters:
      return "parameters";
    case wire::Type::kArm:
      return "arm";
    case wire::Type::kDisarm:
      return "disarm";
    case wire::Type::kStop:
      return "stop";
    default:
      return "request";
  }
}

std::string hex(std::uint32_t value) { return text::format("%08x", value); }

/// Why the robot refused the request.
std::string refusal(const link::Acknowledged& answer) {
  switch (answer.result) {
    case wire::Result::kWrongBoot:
      return "it has restarted";
    case wire::Result::kStaleToken:
      return "stale token";
    case wire::Result::kFaultPersists:
      return "a fault persists: " + fault_names(answer.detail);
    case wire::Result::kOutOfRange:
      if (answer.request != wire::Type::kParameters)
        return "its expiry is out of range, the clock relation is wrong; start again";
      return "value out of range: " + bridge::parameter_name(answer.detail) +
             "; correct it in the robot file";
    case wire::Result::kWrongState:
      return "not in this state";
    default:
      return "unknown reason";
  }
}

std::string versions(const wire::Hello& hello) {
  return "robot has protocol " + std::to_string(hello.protocol) + " schema " + hex(hello.schema) +
         " (firmware " + firmware_text(hello) + "), tp100d needs protocol " +
         std::to_string(wire::kProtocolVersion) + " schema " + hex(wire::kSchemaHash);
}

/// Why the handshake gets no reply, and what to do.
void explain_unanswered(const link::Unanswered& unanswered, Event& out) {
  out.fix = "check cable, adapter and hub";
  switch (unanswered.state) {
    case SessionState::kHello:
      out.cause = "the board sends frames of the protocol but no hello";
      out.fix = "reset the board, or flash it with " + flash_command();
      break;
    case SessionState::kParameters:
      out.cause = "the robot sends hello but receives nothing";
      break;
    default:
      out.cause = "the robot sends samples but no reply to clock requests";
      if (unanswered.too_late_ns == 0) break;
      out.cause = "the robot answers clock requests later than link.clock_answer_ms = " +
                  std::to_string(unanswered.too_late_ns / kNsPerMs) + " ms";
      out.fix =
          "find what delays the port (a network, a hub, a busy machine), or raise "
          "link.clock_answer_ms";
  }
}

std::vector<Event> describe_run(const RunChange& event) {
  std::vector<Event> out;
  if (event.from != event.to)
    out.push_back(
        {.at_ns = event.at_ns, .kind = "run", .text = change_text("state", event.from, event.to)});
  if (event.refused != StartRefusal::kNone)
    out.push_back({.at_ns = event.at_ns,
                   .kind = "run",
                   .level = Level::kError,
                   .text = "start refused",
                   .cause = std::string(to_string(event.refused))});
  const bool on_its_way = event.from == RunState::kRunning &&
                          (event.to == RunState::kIdle || event.to == RunState::kAborted);
  if (on_its_way)
    out.push_back(
        {.at_ns = event.at_ns,
         .kind = "run",
         .text = text::format("the robot is estimated to be at x %.3f m, y %.3f m, yaw %.1f deg, "
                              "%.3f m along the course",
                              event.place.x_m, event.place.y_m, event.place.yaw_rad * kDegPerRad,
                              event.progress_m),
         .fix = "to start again, put it back at the course's start, or continue from there: the "
                "start asks which"});
  if (event.to != RunState::kAborted) return out;
  each_fault(event.faults,
             [&](Fault fault) { out.push_back(messages::fault_event(event.at_ns, fault)); });
  return out;
}

Event describe_dropped(const RequestDropped& event) {
  return {.at_ns = event.at_ns,
          .kind = "run",
          .level = Level::kWarning,
          .text = std::string("'") + to_string(event.request) + "' of " + to_string(event.by) +
                  " is not carried out",
          .cause = event.waited_for == StartRefusal::kNone
                       ? to_string(event.loss)
                       : std::string(to_string(event.waited_for))};
}

/// Describes each event of a session in `out`, whose time is already set.
struct SessionDescriber {
  const wire::Hello& hello;
  Event& out;

  void operator()(const link::StateChanged& changed) const {
    out.text = change_text("state", changed.from, changed.to);
  }
  void operator()(const link::HelloReceived&) const {
    out.text = std::string("hello from ") + board_name(hello.board) + ", firmware " +
               firmware_text(hello) + ", boot " + hex(hello.boot_nonce);
  }
  void operator()(const link::VersionMismatch&) const {
    out.level = Level::kError;
    out.text = "wrong version";
    out.cause = versions(hello);
    out.fix = "flash the board with " + flash_command();
  }
  void operator()(const link::BadHello& bad) const {
    out.level = Level::kError;
    out.text = "invalid hello";
    out.cause = bad.boot_nonce == 0 ? "its boot number is 0"
                                    : "it names state " + std::to_string(bad.state);
    out.fix = "flash the board with " + flash_command();
  }
  void operator()(const link::UnknownBoard& unknown) const {
    out.level = Level::kWarning;
    out.text = "unknown board";
    out.cause = "hello names board " + std::to_string(unknown.board) +
                ", which this version does not know; it uses the same messages and may drive";
    out.fix = "check that it is the right port (tp100d ports), update the daemon";
  }
  void operator()(const link::Rebooted&) const {
    out.level = Level::kWarning;
    out.text = "the robot restarted";
    out.cause = "its hello has another boot number";
    out.fix = "check its supply unless it was reset or unplugged on purpose";
  }
  void operator()(const link::RobotFault& reported) const {
    // A robot's fault number is below 16; higher numbers are faults of the daemon.
    const FaultText& text =
        describe(reported.fault < 16 ? static_cast<Fault>(reported.fault) : Fault{255});
    out.kind = "fault";
    out.level = Level::kWarning;
    out.text = "robot fault " + std::string(text.name);
    if (text.name == "unknown") out.text += " (" + std::to_string(reported.fault) + ")";
    out.cause = text.cause;
    out.fix = text.fix;
  }
  void operator()(const link::RobotLog& log) const {
    out.kind = "robot";
    out.text = std::string("robot: ") + log.text.data();
  }
  void operator()(const link::Acknowledged& answer) const {
    out.kind = "acknowledge";
    out.text = request_name(answer.request);
    if (answer.result == wire::Result::kAccepted) {
      out.text += " acknowledged";
    } else {
      out.level = Level::kWarning;
      out.text += " refused by the robot: " + refusal(answer);
    }
  }
  void operator()(const link::NotAcknowledged& request) const {
    out.kind = "acknowledge";
    out.level = Level::kWarning;
    out.text = std::string(request_name(request.request)) + " not acknowledged";
  }
  void operator()(const link::Silence& silence) const {
    out.level = Level::kWarning;
    out.text = "no good frame from the robot in time (state " +
               std::string(to_string(silence.state)) + ")";
    out.cause = "it is silent, or what comes is corrupted";
    out.fix = "check its cable and supply; the daemon keeps listening";
  }
  void operator()(const link::Unanswered& unanswered) const {
    out.level = Level::kWarning;
    out.text = "no answer from the robot (state " + std::string(to_string(unanswered.state)) + ")";
    explain_unanswered(unanswered, out);
  }
};

Event describe_session(const SessionReport& report) {
  Event out;
  out.at_ns = report.event.at_ns;
  out.kind = "session";
  std::visit(SessionDescriber{report.hello, out}, report.event.what);
  return out;
}

}  // namespace

std::vector<Event> describe_event(const LiveEvent& event) {
  if (const RunChange* run = std::get_if<RunChange>(&event)) return describe_run(*run);
  if (const RequestDropped* dropped = std::get_if<RequestDropped>(&event))
    return {describe_dropped(*dropped)};
  return {describe_session(std::get<SessionReport>(event))};
}

bool acknowledges_stop(const link::SessionEvent& event) {
  const link::Acknowledged* answer = link::as<link::Acknowledged>(event);
  return answer != nullptr && answer->request == wire::Type::kStop &&
         answer->result == wire::Result::kAccepted;
}

std::string state_line(SessionState session, RunState run, const std::string& course,
                       const std::string& page) {
  std::string line = "link " + std::string(to_string(session)) + ", run ";
  line += to_string(run);
  if (!course.empty()) line += ", course " + course;
  if (!page.empty()) line += "; page " + page;
  return line;
}

std::string fault_names(FaultMask faults) {
  std::string names;
  each_fault(faults, [&](Fault fault) {
    names += names.empty() ? "" : ", ";
    names += describe(fault).name;
  });
  return names.empty() ? "none" : names;
}

}  // namespace tp100::live
