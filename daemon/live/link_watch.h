#pragma once
// What is wrong with a link that holds: frames that are damaged, repeated or late. In words for the
// log and for viewers. No clock, no port.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "messages/messages.h"
#include "messages/sink.h"

namespace tp100::live {

class LinkWatch : public messages::Sink {
 public:
  /// A kind of trouble is reported at most once in this time; the next line counts what came since.
  static constexpr HostNs kQuietNs = 10 * kNsPerS;
  /// A step's sample is too old from here on: a frame and a turn of the loop take less.
  static constexpr std::int64_t kLateUs = 15'000;

  void take(const StepRecord& record) override;
  /// What there is to say since the last call; empty nearly always.
  std::vector<messages::Event> take_words();

 private:
  enum Trouble : std::uint8_t {
    kDamaged,
    kRobotDamaged,
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
  /// One kind of trouble, and what of it was reported.
  struct Tally {
    std::uint64_t now = 0;   ///< counted so far
    std::uint64_t said = 0;  ///< of these, in a line that was reported
    HostNs said_ns = 0;      ///< time of that line
    bool spoken = false;     ///< there was one
  };
  void count(const LinkCounters& link);
  void time(const StepRecord& record);

  std::array<Tally, kCount> tallies_{};
  HostNs now_ns_ = 0;
  std::uint64_t step_ = 0;
  std::int64_t oldest_us_ = 0, longest_ms_ = 0;
};

}  // namespace tp100::live
