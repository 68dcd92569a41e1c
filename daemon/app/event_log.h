#pragma once
// The log: one line per event on standard error. spdlog stays in the source file; never used by the
// real-time thread.

#include <string>
#include <vector>

#include "app/live_cycle.h"
#include "app/live_events.h"
#include "loop/real_time.h"

namespace tp100::app {

class EventLog {
 public:
  EventLog();

  void info(const std::string& line);
  void warn(const std::string& line);
  /// `all_words`: of the event, one line each. Bursts of the same kind are folded.
  void event(const LiveEvent& event, const std::vector<publish::Event>& all_words);
  /// What the real-time thread asked for and got.
  void grants(const std::vector<loop::Grant>& grants);
  /// The line of figures, every ten seconds.
  void status(const LiveStatus& status, std::uint64_t overruns, HostNs now);

 private:
  bool allow(HostNs at_ns);

  HostNs next_status_ns_ = 0;
  HostNs burst_began_ns_ = 0;
  int burst_ = 0;
  bool silence_told_ = false;
  std::uint64_t folded_ = 0;
};

}  // namespace tp100::app
