#include "live/live_events.h"

#include <cstdio>
#include <utility>

#include "core/flash_command.h"

namespace tp100::live {
namespace {

using Kind = link::SessionEvent::Kind;
using messages::Event;
using Level = messages::Event::Level;

const char* request_name(std::int32_t type) {
  switch (static_cast<wire::Type>(type)) {
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

const char* board_name(std::uint8_t board) {
  switch (static_cast<wire::Board>(board)) {
    case wire::Board::kMega2560:
      return "a Mega 2560";
    case wire::Board::kNative:
      return "an emulated board";
    default:
      return "an unknown board";
  }
}

std::string hex(std::uint32_t value) {
  char digits[9];
  std::snprintf(digits, sizeof digits, "%08x", value);
  return digits;
}

/// Why the robot refused the request.
std::string refusal(const link::SessionEvent& event) {
  switch (static_cast<wire::Result>(event.b)) {
    case wire::Result::kWrongBoot:
      return "it has restarted";
    case wire::Result::kStaleToken:
      return "stale token";
    case wire::Result::kFaultPersists:
      return "a fault persists: " + fault_names(event.detail);
    case wire::Result::kOutOfRange:
      if (event.a != static_cast<std::int32_t>(wire::Type::kParameters))
        return "its expiry is out of range, the clock relation is wrong; start again";
      return std::string("value out of range: ") + bridge::parameter_name(event.detail) +
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

/// Why the handshake hangs, and what helps.
void explain_unanswered(SessionState state, Event& out) {
  out.remedy = "check cable, adapter and hub";
  switch (state) {
    case SessionState::kHello:
      out.cause = "the board speaks the protocol's frames but says no hello";
      out.remedy = "reset the board, or flash it with " + flash_command();
      break;
    case SessionState::kParameters:
      out.cause = "the robot says hello but hears nothing of what is sent to it";
      break;
    default:
      out.cause = "the robot sends samples but answers no clock request";
  }
}

template <class State>
std::string change(State from, State to) {
  return "state: " + std::string(to_string(from)) + " -> " + std::string(to_string(to));
}

std::vector<Event> run_words(const LiveEvent& event) {
  std::vector<Event> out;
  if (event.from != event.to)
    out.push_back({.at_ns = event.at_ns, .kind = "run", .text = change(event.from, event.to)});
  if (event.refused != StartRefusal::kNone)
    out.push_back({.at_ns = event.at_ns,
                   .kind = "run",
                   .level = Level::kError,
                   .text = "start refused",
                   .cause = std::string(to_string(event.refused))});
  if (event.to != RunState::kAborted) return out;
  FaultMask faults = event.faults;
  while (const auto fault = first_fault(faults)) {
    const FaultText& text = describe(*fault);
    out.push_back({.at_ns = event.at_ns,
                   .kind = "fault",
                   .level = Level::kError,
                   .text = std::string(text.name),
                   .cause = std::string(text.cause),
                   .remedy = std::string(text.remedy)});
    faults &= ~fault_bit(*fault);
  }
  return out;
}

Event session_words(const LiveEvent& live) {
  const link::SessionEvent& event = live.session;
  Event out;
  out.at_ns = event.at_ns;
  out.kind = "session";
  switch (event.kind) {
    case Kind::kState:
      out.text = change(static_cast<SessionState>(event.a), static_cast<SessionState>(event.b));
      break;
    case Kind::kHello:
      out.text = std::string("hello from ") + board_name(live.hello.board) + ", firmware " +
                 firmware_text(live.hello) + ", boot " + hex(live.hello.boot_nonce);
      break;
    case Kind::kVersionMismatch:
      out.level = Level::kError;
      out.text = "wrong version";
      out.cause = versions(live.hello);
      out.remedy = "flash the board with " + flash_command();
      break;
    case Kind::kUnknownBoard:
      out.level = Level::kWarning;
      out.text = "unknown board";
      out.cause = "hello names board " + std::to_string(event.a) +
                  ", which this version does not know; it speaks the same messages and may drive";
      out.remedy = "check that it is the right port (tp100d ports), update the daemon";
      break;
    case Kind::kReboot:
      out.level = Level::kWarning;
      out.text = "the robot restarted";
      out.cause = "its hello has another boot number";
      out.remedy = "check its supply if nobody reset it or pulled its plug";
      break;
    case Kind::kBadHello:
      out.level = Level::kError;
      out.text = "a hello that no TP100 sends";
      out.cause =
          event.a == 0 ? "its boot number is 0" : "it names state " + std::to_string(event.b);
      out.remedy = "flash the board with " + flash_command();
      break;
    case Kind::kRobotFault: {
      // Beyond the robot's sixteen bits the numbers are the daemon's own.
      const FaultText& text = describe(static_cast<Fault>(event.a < 16 ? event.a : 255));
      out.kind = "fault";
      out.level = Level::kWarning;
      out.text = "robot fault " + std::string(text.name);
      if (text.name == "unknown") out.text += " (" + std::to_string(event.a) + ")";
      out.cause = text.cause;
      out.remedy = text.remedy;
      break;
    }
    case Kind::kRobotLog:
      out.kind = "robot";
      out.text = std::string("robot: ") + event.text.data();
      break;
    case Kind::kAcknowledged:
      out.kind = "acknowledge";
      out.text = request_name(event.a);
      if (event.b == 0) {
        out.text += " acknowledged";
      } else {
        out.level = Level::kWarning;
        out.text += " refused by the robot: " + refusal(event);
      }
      break;
    case Kind::kNotAcknowledged:
      out.kind = "acknowledge";
      out.level = Level::kWarning;
      out.text = std::string(request_name(event.a)) + " not acknowledged";
      break;
    case Kind::kTimeout:
      out.level = Level::kWarning;
      out.text = "no good frame from the robot in time (state " +
                 std::string(to_string(static_cast<SessionState>(event.a))) + ")";
      out.cause = "it is silent, or what comes is damaged";
      out.remedy = "check its cable and supply; the daemon goes on listening";
      break;
    case Kind::kUnanswered:
      out.level = Level::kWarning;
      out.text = "no answer from the robot (state " +
                 std::string(to_string(static_cast<SessionState>(event.a))) + ")";
      explain_unanswered(static_cast<SessionState>(event.a), out);
      break;
  }
  return out;
}

}  // namespace

std::vector<Event> words_for(const LiveEvent& event) {
  if (event.kind == LiveEvent::Kind::kRunState) return run_words(event);
  return {session_words(event)};
}

bool acknowledges_stop(const LiveEvent& event) {
  return event.kind == LiveEvent::Kind::kSession && event.session.kind == Kind::kAcknowledged &&
         event.session.a == static_cast<std::int32_t>(wire::Type::kStop) && event.session.b == 0;
}

std::string firmware_text(const wire::Hello& hello) {
  return std::to_string(hello.firmware[0]) + "." + std::to_string(hello.firmware[1]) + "." +
         std::to_string(hello.firmware[2]);
}

std::string version_mismatch(const wire::Hello& hello) {
  return "wrong version: " + versions(hello) + "; flash the board with " + flash_command();
}

std::string fault_names(FaultMask faults) {
  std::string names;
  while (const auto fault = first_fault(faults)) {
    names += names.empty() ? "" : ", ";
    names += describe(*fault).name;
    faults &= ~fault_bit(*fault);
  }
  return names.empty() ? "none" : names;
}

}  // namespace tp100::live
