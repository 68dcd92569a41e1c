#include "app/event_log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <utility>

namespace tp100::app {
namespace {

using Kind = link::SessionEvent::Kind;

// More lines than this within a second are noise.
constexpr int kBurst = 50;
constexpr HostNs kStatusPeriodNs = 10 * kNsPerS;

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

std::string refusal(const link::SessionEvent& event) {
  switch (static_cast<wire::Result>(event.b)) {
    case wire::Result::kWrongBoot:
      return "it has restarted";
    case wire::Result::kStaleToken:
      return "stale token";
    case wire::Result::kFaultPersists:
      return "a fault persists: " + fault_names(event.detail);
    case wire::Result::kOutOfRange:
      return std::string("value out of range: ") + parameter_name(event.detail) +
             "; correct it in the robot file";
    case wire::Result::kWrongState:
      return "not in this state";
    default:
      return "unknown reason";
  }
}

std::string version_text(const wire::Hello& hello) {
  return fmt::format("{}.{}.{}", hello.firmware[0], hello.firmware[1], hello.firmware[2]);
}

}  // namespace

std::string fault_names(FaultMask faults) {
  std::string names;
  while (const auto fault = first_fault(faults)) {
    names += names.empty() ? "" : ", ";
    names += describe(*fault).name;
    faults &= ~fault_bit(*fault);
  }
  return names.empty() ? "none" : names;
}

std::string version_mismatch(const wire::Hello& hello) {
  return fmt::format(
      "wrong version: robot has protocol {} schema {:08x} (firmware {}), tp100d needs protocol {} "
      "schema {:08x}; flash the board with scripts/flash",
      hello.protocol, hello.schema, version_text(hello), wire::kProtocolVersion, wire::kSchemaHash);
}

EventLog::EventLog() {
  if (spdlog::get("tp100d") == nullptr) {
    spdlog::set_default_logger(spdlog::stderr_color_mt("tp100d"));
  }
  spdlog::set_pattern("%H:%M:%S.%e %^%l%$ %v");
  spdlog::flush_on(spdlog::level::info);
}

void EventLog::info(const std::string& line) { spdlog::info("{}", line); }
void EventLog::warn(const std::string& line) { spdlog::warn("{}", line); }

bool EventLog::allow(HostNs at_ns) {
  if (at_ns - burst_began_ns_ > kNsPerS) {
    if (folded_ > 0) spdlog::warn("{} more events within a second are not shown", folded_);
    burst_began_ns_ = at_ns;
    burst_ = 0;
    folded_ = 0;
  }
  if (++burst_ <= kBurst) return true;
  ++folded_;
  return false;
}

void EventLog::event(const LiveEvent& event) {
  if (event.kind == LiveEvent::Kind::kRunState) {
    spdlog::info("state: {} -> {}", to_string(event.from), to_string(event.to));
    if (event.to != RunState::kAborted) return;
    FaultMask faults = event.faults;
    while (const auto fault = first_fault(faults)) {
      const FaultText& text = describe(*fault);
      spdlog::error("{}: {}; {}", text.name, text.cause, text.remedy);
      faults &= ~fault_bit(*fault);
    }
    return;
  }
  if (allow(event.session.at_ns)) session_event(event);
}

void EventLog::session_event(const LiveEvent& live) {
  const link::SessionEvent& event = live.session;
  // A port on which nothing is heard says so once.
  const bool told = std::exchange(silence_told_, event.kind == Kind::kTimeout);
  switch (event.kind) {
    case Kind::kState:
      spdlog::info("state: {} -> {}", to_string(static_cast<SessionState>(event.a)),
                   to_string(static_cast<SessionState>(event.b)));
      return;
    case Kind::kHello:
      spdlog::info("hello from {}, firmware {}, boot {:08x}", board_name(live.hello.board),
                   version_text(live.hello), live.hello.boot_nonce);
      return;
    case Kind::kVersionMismatch:
      spdlog::error("{}", version_mismatch(live.hello));
      return;
    case Kind::kReboot:
      spdlog::warn("the robot restarted");
      return;
    case Kind::kRobotFault: {
      const FaultText& text = describe(static_cast<Fault>(event.a & 0x1F));
      spdlog::warn("robot fault {}: {}; {}", text.name, text.cause, text.remedy);
      return;
    }
    case Kind::kRobotLog:
      spdlog::info("robot: {}", event.text.data());
      return;
    case Kind::kAcknowledged:
      if (event.b == 0) {
        spdlog::info("{} acknowledged", request_name(event.a));
      } else {
        spdlog::warn("{} refused by the robot: {}", request_name(event.a), refusal(event));
      }
      return;
    case Kind::kNotAcknowledged:
      spdlog::warn("{} not acknowledged", request_name(event.a));
      return;
    case Kind::kTimeout:
      if (told) return;
      spdlog::warn("no good frame from the robot in time (state {})",
                   to_string(static_cast<SessionState>(event.a)));
      return;
  }
}

void EventLog::grants(const std::vector<loop::Grant>& grants) {
  for (const loop::Grant& grant : grants) {
    if (grant.granted) {
      spdlog::info("real time: {}", grant.what);
    } else {
      spdlog::info("real time: no {}; {}", grant.what, grant.remedy);
    }
  }
}

void EventLog::status(const LiveStatus& status, std::uint64_t overruns, HostNs now) {
  if (status.session != SessionState::kReady || now < next_status_ns_) return;
  next_status_ns_ = now + kStatusPeriodNs;
  const LinkCounters& link = status.counters;
  const Pose& pose = status.snapshot.odometry;
  spdlog::info(
      "x {:.3f} m, y {:.3f} m, yaw {:.1f} deg; samples {}, lost {}, bad frames {}, overruns {}; "
      "clock "
      "drift {:.1f} ppm, +-{:.0f} us; battery {:.2f} V",
      pose.x_m, pose.y_m, pose.yaw_rad * 57.29577951308232, link.samples, link.lost,
      link.crc_errors + link.cobs_errors + link.oversize + link.undersize, overruns,
      status.clock.drift * 1e6, status.clock.uncertainty_us, status.snapshot.sample.battery_v);
}

}  // namespace tp100::app
