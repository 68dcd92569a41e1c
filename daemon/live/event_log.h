#pragma once
// The log: one line per event on standard error. spdlog stays in the source file. Never used by the
// real-time thread. A thread of its own writes the lines: a reader that stalls (a pager, a stopped
// terminal) blocks nothing and loses the oldest lines, whose number the log tells.

#include <memory>
#include <string>
#include <vector>

#include "live/live_cycle.h"
#include "loop/real_time.h"
#include "messages/figures.h"
#include "messages/messages.h"

namespace tp100::live {

class EventLog {
 public:
  EventLog();
  /// Writes the waiting lines; gives up if the reader takes nothing for a second.
  ~EventLog();

  /// Waits until everything is written; false: it is not read. Then the thread still waits in a
  /// write, so that standard output and error must not be used any more: end by std::_Exit.
  bool flush();

  void info(const std::string& line);
  void say(const std::string& line, bool warning) { warning ? warn(line) : info(line); }
  void warn(const std::string& line);
  /// `described`: the event as describe_event() describes it, one line each. Bursts are folded into
  /// a count.
  void event(const LiveEvent& event, const std::vector<messages::Event>& described);
  void write(const std::vector<messages::Event>& all);
  /// Logs a recording that began since the last call, and what it lost.
  void recording(const messages::RecordingFigures& now);
  void privileges(const std::vector<loop::Privilege>& privileges);
  /// Logs the line of figures every ten seconds, and why a start has been impossible for over a
  /// second.
  void status(const LiveStatus& status, std::uint64_t overruns, HostNs now);
  /// Call it regularly: logs the sum of folded lines, and of those that were lost.
  void tick(HostNs now);
  /// Writes the last lines of the program on standard output.
  void summary(const std::string& lines);

 private:
  struct Writer;
  void refusal(StartRefusal refusal, HostNs now);

  std::unique_ptr<Writer> writer_;

  HostNs next_status_ns_ = 0;
  HostNs burst_began_ns_ = 0;
  int burst_ = 0;
  bool silence_reported_ = false;
  StartRefusal refusal_ = StartRefusal::kNone;
  HostNs refusal_since_ns_ = 0;
  bool refusal_reported_ = false;
  std::uint64_t lost_ = 0;
  messages::RecordingFigures recording_{};
};

}  // namespace tp100::live
