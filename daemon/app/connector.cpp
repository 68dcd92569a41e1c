#include "app/connector.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/error.h"
#include "core/flash_command.h"
#include "link/port_discovery.h"

namespace tp100::app {

Connector::Connector(ConnectorSettings settings, loop::FixedRateLoop& loop,
                     std::function<void(const std::string&)> say)
    : settings_(std::move(settings)), loop_(loop), say_(std::move(say)) {}

void Connector::tick(HostNs now) {
  loop::LostPort lost;
  while (loop_.take_lost(lost)) take_back(lost, now);
  if (!stopped_ && !port_.is_open() && now >= next_try_ns_) try_open(now);
}

void Connector::take_back(const loop::LostPort& lost, HostNs now) {
  if (!port_.is_open() || lost.id != id_) return;
  port_.close();
  next_try_ns_ = now + retry_ns_;
  retry_ns_ = std::min(2 * retry_ns_, kLongestRetryNs);
  const bool silent = lost.end == loop::PortEnd::kSilent;
  if (silent) silent_.insert(path_);
  std::string line = path_ + ": ";
  if (silent) {
    line += found_ ? "the robot fell silent"
                   : "nothing that speaks like a TP100; flash the board with " + flash_command() +
                         ", or choose another port with --port";
  } else {
    line += std::string("port is gone (") +
            (lost.error == 0 ? "end of file" : std::strerror(lost.error)) +
            "); plug the robot in again";
  }
  if (!found_ && !settings_.wait && !(silent && silent_.size() < candidates_)) {
    throw SetupError(line);
  }
  say_once(line);
}

void Connector::try_open(HostNs now) {
  try {
    port_ = open_next();
  } catch (const SetupError& error) {
    if (!found_ && !settings_.wait) throw;
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

// One that is held or forbidden is somebody else's: the next is tried, and the first one's error is
// told if none can be opened.
link::Port Connector::open_next() {
  if (settings_.port != "auto") return link::open_port(settings_.port, settings_.options);
  std::vector<link::PortInfo> ports = link::candidates(link::list_ports());
  if (ports.empty()) {
    throw SetupError(
        "no USB port that may be a TP100; plug the robot in, or name its port with --port (see "
        "`tp100d ports`)");
  }
  candidates_ = ports.size();
  if (candidates_ > 1 && !std::exchange(several_said_, true))
    say_(std::to_string(candidates_) +
         " ports may be a TP100 (see `tp100d ports`), the likeliest first; name the robot's with "
         "--port or link.port");
  const auto silent = [this](const link::PortInfo& port) { return silent_.contains(port.path); };
  if (std::all_of(ports.begin(), ports.end(), silent)) silent_.clear();
  std::stable_partition(ports.begin(), ports.end(), std::not_fn(silent));
  std::string refused;
  for (const link::PortInfo& port : ports) {
    if (silent(port) && !settings_.wait && !found_) break;
    try {
      return link::open_port(port.path, settings_.options);
    } catch (const SetupError& error) {
      if (refused.empty()) refused = error.what();
    }
  }
  throw SetupError(refused);
}

void Connector::say_once(const std::string& line) {
  if (line == last_line_) return;
  last_line_ = line;
  say_(line);
}

}  // namespace tp100::app
