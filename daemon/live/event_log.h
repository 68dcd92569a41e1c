#pragma once
// The log: one line per event on standard error. spdlog stays in the source file; never used by the
// real-time thread. Lines are written by a thread of its own: who does not read them (a pager, a
// stopped terminal) holds up nobody, and loses the oldest.

#include <memory>
#include <string>
#include <vector>

#include "live/live_cycle.h"
#include "live/live_events.h"
#include "loop/real_time.h"
#include "messages/figures.h"

namespace tp100::live {

class EventLog {
 public:
  EventLog();
  /// Writes what waits; gives up on a reader who takes nothing for a second.
  ~EventLog();

  /// Waits until all is written; false: the reader took nothing for a second.
  bool flush();

  void info(const std::string& line);
  void warn(const std::string& line);
  /// `all_words`: of the event, one line each. Bursts of the same kind are folded.
  void event(const LiveEvent& event, const std::vector<messages::Event>& all_words);
  /// One line each.
  void words(const std::vector<messages::Event>& all);
  /// What the real-time thread asked for and got.
  void grants(const std::vector<loop::Grant>& grants);
  /// The line of figures, every ten seconds, and what stands against a start for over a second.
  void status(const LiveStatus& status, std::uint64_t overruns, HostNs now);
  /// Time passes: what was folded is summed up.
  void tick(HostNs now);
  /// The loop's times since its start in one line.
  void times(const messages::LoopFigures& loop);

 private:
  struct Writer;
  bool allow();
  void refusal(StartRefusal refusal, HostNs now);

  std::unique_ptr<Writer> writer_;

  HostNs next_status_ns_ = 0;
  HostNs burst_began_ns_ = 0;
  int burst_ = 0;
  bool silence_told_ = false;
  StartRefusal refusal_ = StartRefusal::kNone;
  HostNs refusal_since_ns_ = 0;
  bool refusal_told_ = false;
  std::uint64_t folded_ = 0;
};

}  // namespace tp100::live
