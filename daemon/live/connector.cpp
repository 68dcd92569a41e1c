#include "live/connector.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "bridge/cycle.h"
#include "core/error.h"
#include "core/faults.h"
#include "live/live_events.h"

namespace tp100::live {
namespace {

// A board needs 2 s after its reset, and less for a handshake; a silent port is given up sooner.
constexpr HostNs kFirstSessionNs = 6 * kNsPerS;

/// Distinguishes a port from the one that had the same name before replugging.
std::string device_file(const std::string& path) {
  struct stat status {};
  const bool there = ::stat(path.c_str(), &status) == 0;
  return path + " " + std::to_string(there ? status.st_ino : 0);
}

bool same_board(const link::PortInfo& a, const link::PortInfo& b) {
  return a.vendor_id == b.vendor_id && a.product_id == b.product_id && a.serial == b.serial;
}

}  // namespace

Connector::Connector(const config::LinkSettings& link, bool wait, selftest::PortHandover& handover,
                     loop::FixedRateLoop& loop, EventLog& log, LiveControls& controls)
    : wanted_(link.port),
      options_{.baud = link.baud, .hang_up = link.hang_up},
      wait_(wait),
      handover_(handover),
      loop_(loop),
      log_(log),
      controls_(controls) {}

void Connector::tick(HostNs now) {
  loop::LostPort lost;
  while (loop_.take_lost(lost)) take_back(lost, now);
  if (!stopped_ && !handed_over() && !port_.is_open() && now >= next_try_ns_) try_open(now);
  if (awaits_first() && tried_ns_ != 0 && now - tried_ns_ >= kFirstSessionNs)
    throw UserError(path_ + ": no session with the robot was established in " +
                    std::to_string(kFirstSessionNs / kNsPerS) + " s, last state " +
                    std::string(to_string(session_)) +
                    ": its hello or its answers do not belong to this version; flash this "
                    "version's firmware (scripts/flash, installed: tp100-flash)");
}

void Connector::on_event(const SessionReport& report, const std::string& robot) {
  if (awaits_first()) require_usable(report, robot);
  if (link::as<link::HelloReceived>(report.event) != nullptr) {
    found_ = true;
    robot_ = opened_;
  } else if (const auto* changed = link::as<link::StateChanged>(report.event)) {
    session_ = changed->to;
    const bool meant = session_ != SessionState::kListening || wanted_ != "auto";
    if (tried_ns_ == 0 && session_ != SessionState::kClosed && meant)
      tried_ns_ = report.event.at_ns;
    if (session_ != SessionState::kReady) return;
    had_session_ = true;
    retry_ns_ = kFirstRetryNs;
  }
}

void Connector::require_usable(const SessionReport& report, const std::string& robot) const {
  const bool mismatch = link::as<link::VersionMismatch>(report.event) != nullptr;
  if (mismatch || link::as<link::Unanswered>(report.event) != nullptr ||
      link::as<link::BadHello>(report.event) != nullptr) {
    const messages::Event event = describe_event(report).front();
    throw UserError(path_ + ": " + (mismatch ? event.text + ": " : "") + event.cause + "; " +
                    event.fix);
  }
  const link::Acknowledged* answer = link::as<link::Acknowledged>(report.event);
  if (answer != nullptr && answer->request == wire::Type::kParameters &&
      answer->result == wire::Result::kOutOfRange)
    throw UserError("robot " + robot + ": the firmware refuses " +
                    bridge::parameter_name(answer->detail) +
                    " as out of range; correct it in the robot file");
}

void Connector::take_back(const loop::LostPort& lost, HostNs now) {
  if (!port_.is_open() || lost.id != id_) return;
  port_.close();
  if (handover_.give(path_)) {
    next_try_ns_ = now;
    return say_once(path_ + ": handed over to the check of the tracks");
  }
  next_try_ns_ = now + retry_ns_;
  retry_ns_ = std::min(2 * retry_ns_, kLongestRetryNs);
  const bool silent = lost.end == loop::PortEnd::kSilent;
  if (!silent) came_later_ = true;
  if (silent && !robot_) silent_.insert(device_file(path_));
  std::string line = path_ + ": ";
  if (silent) {
    line += found_ ? "the robot fell silent"
                   : "no answer from a TP100; flash the board with " + flash_command() +
                         ", or choose another port with --port";
    if (!found_ && wanted_ == "auto") line += "; auto ignores it until it is plugged in again";
  } else {
    line += std::string("port is gone (") +
            (lost.error == 0 ? "end of file" : std::strerror(lost.error)) +
            "); plug the robot in again";
  }
  if (!found_ && !wait_ && !stopped_) throw UserError(line);
  say_once(line);
}

void Connector::try_open(HostNs now) {
  try {
    port_ = open_next();
  } catch (const UserError& error) {
    if (!found_ && !wait_) throw;
    came_later_ = true;
    say_once(std::string(error.what()) + "; waiting");
    next_try_ns_ = now + retry_ns_;
    retry_ns_ = std::min(2 * retry_ns_, kLongestRetryNs);
    return;
  }
  path_ = port_.path();
  pseudo_terminal_ = port_.pseudo_terminal();
  say_once(path_ + ": open");
  loop_.offer({port_.fd(), ++id_});
}

link::AutoChoice Connector::choose() const {
  std::vector<link::PortInfo> ports = link::list_ports();
  if (robot_)
    std::erase_if(ports, [this](const link::PortInfo& port) { return !same_board(port, *robot_); });
  link::AutoChoice choice =
      link::choose_for_auto(ports, [](const std::string& path) { return link::port_holder(path); });
  if (choice.open && silent_.contains(device_file(choice.open->path))) {
    choice.passed_over.push_back({*choice.open, "no TP100 answered on it"});
    choice.open.reset();
  }
  return choice;
}

link::Port Connector::open_next() {
  if (wanted_ != "auto") return link::open_port(wanted_, options_);
  const link::AutoChoice choice = choose();
  if (!choice.open) {
    if (robot_ && choice.passed_over.empty())
      throw UserError(path_ + ": the robot's port is gone; plug it in again");
    throw UserError(link::why_none(choice));
  }
  link::Port open = link::open_port(choice.open->path, options_);
  opened_ = choice.open;
  return open;
}

void Connector::say_once(const std::string& line) {
  if (line == last_line_) return;
  last_line_ = line;
  log_.info(line);
  controls_.note_port(line);
}

}  // namespace tp100::live
