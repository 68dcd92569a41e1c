#pragma once
// Detects trouble on a link that is up: frames that are corrupted, repeated or late. Reports it as
// messages for the log and for viewers. No clock, no port.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "messages/messages.h"
#include "messages/sink.h"

namespace tp100::live {

class LinkMonitor : public messages::Sink {
 public:
  /// Shortest time between two reports of one kind; the later one counts everything since the
  /// first.
  static constexpr HostNs kQuietNs = 10 * kNsPerS;
  /// A sample of at least this age is late: a frame and a cycle of the loop take less.
  static constexpr std::int64_t kLateUs = 15'000;

  void take(const StepRecord& record) override;
  /// Reports since the last call; nearly always empty.
  std::vector<messages::Event> drain_events();

 private:
  enum Trouble : std::uint8_t {
    kCorrupted,
    kRobotCorrupted,
    kMissedEdges,
    kForeign,
    kRepeated,
    kImplausible,
    kClockAnswers,
    kUnwritten,
    kLate,
    kStoodStill,
    kCount
  };
  /// Count of one kind of trouble, and how much of it was reported.
  struct Tally {
    std::uint64_t now = 0;       ///< count so far
    std::uint64_t reported = 0;  ///< count at the last report
    HostNs reported_ns = 0;      ///< time of the last report
    bool has_reported = false;   ///< there was a report
  };
  void count(const LinkCounters& link);
  void time(const StepRecord& record);

  std::array<Tally, kCount> tallies_{};
  HostNs now_ns_ = 0;
  std::uint64_t step_ = 0;
  std::int64_t oldest_us_ = 0, longest_ms_ = 0;
};

}  // namespace tp100::live
