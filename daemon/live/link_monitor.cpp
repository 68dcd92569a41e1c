#include "live/link_monitor.h"

#include <algorithm>

#include "core/faults.h"

namespace tp100::live {
namespace {

using messages::Event;

// A longer pause of the loop is reported; other programs on the machine may cause it now and then.
constexpr HostNs kStillNs = 50 * kNsPerMs;

struct Text {
  std::uint64_t least;  // a session's first frames and a brief pause do not count
  const char* what;
  const char* cause;
  std::string fix;
};

}  // namespace

void LinkMonitor::take(const StepRecord& record) {
  count(record.link);
  time(record);
}

void LinkMonitor::count(const LinkCounters& link) {
  tallies_[kCorrupted].now = link.corrupted();
  tallies_[kRobotCorrupted].now = link.robot_corrupted;
  tallies_[kMissedEdges].now = link.missed_edges;
  tallies_[kForeign].now = link.unknown_type + link.wrong_size;
  tallies_[kRepeated].now = link.duplicated + link.reordered;
  tallies_[kImplausible].now = link.implausible;
  tallies_[kClockAnswers].now = link.sync_rejected;
  tallies_[kUnwritten].now = link.unwritten;
}

void LinkMonitor::time(const StepRecord& record) {
  // A missing step was dropped on its way to this thread; the loop did execute it.
  const bool next = record.step == step_ + 1;
  const HostNs gap_ns = next && now_ns_ != 0 ? record.now_ns - now_ns_ : 0;
  now_ns_ = record.now_ns;
  step_ = record.step;
  if (gap_ns > kStillNs) {
    ++tallies_[kStoodStill].now;
    longest_ms_ = std::max(longest_ms_, gap_ns / kNsPerMs);
  }
  const Snapshot& snapshot = record.snapshot;
  if (record.inputs.session != SessionState::kReady || !snapshot.has_sample) return;
  if (snapshot.age_us <= kLateUs) return;
  ++tallies_[kLate].now;
  oldest_us_ = std::max(oldest_us_, snapshot.age_us);
}

std::vector<Event> LinkMonitor::drain_events() {
  static const std::array<Text, kCount> kTexts{
      {{1, "corrupted frames", "bytes change or are lost on their way, or another program writes",
        "check cable and hub; run tp100d doctor to examine the port"},
       {1, "frames corrupted on their way to the robot",
        "bytes change or are lost, or its board was busy for too long",
        "check cable and hub; run tp100d doctor to examine the port"},
       {1, "encoder edges missed by the robot",
        "an encoder's wires pick up noise or make bad contact",
        "check the encoders' plugs and shields"},
       {1, "frames of an unknown type or size",
        "the firmware or another program sends other messages",
        "flash the board with " + flash_command() + "; run tp100d doctor to examine the port"},
       {5, "samples repeated or out of order", "a hub or its driver repeats or reorders",
        "use another cable or hub"},
       {1, "impossible values", "glitches on an encoder's wires, or a clock that jumped",
        "check the encoders' plugs and shields, and the board's supply"},
       {5, "unusable replies to clock requests", "they arrive late, twice or out of order",
        "use another cable or hub"},
       {1, "frames that the port did not accept", "the robot or its USB bridge reads nothing",
        "check the cable; plug it in again"},
       {3, "steps without a fresh sample",
        "a USB bridge or hub holds data back, or the machine is busy",
        "set the bridge's latency timer to 1 ms; run tp100d doctor to examine the machine"},
       {1, "cycles of the loop that started late",
        "the machine is busy or the loop lacks privileges",
        "end other programs; see the lines `real time:` and tp100d doctor"}}};
  std::vector<Event> out;
  for (std::size_t i = 0; i < kCount; ++i) {
    Tally& tally = tallies_[i];
    const Text& text = kTexts[i];
    if (tally.now < tally.reported + text.least) continue;
    if (tally.has_reported && now_ns_ - tally.reported_ns < kQuietNs) continue;
    std::string line = std::to_string(tally.now - tally.reported) + " " + text.what;
    if (i == kLate) line += ", the oldest of " + std::to_string(oldest_us_ / 1000) + " ms";
    if (i == kStoodStill) line += ", the longest after " + std::to_string(longest_ms_) + " ms";
    out.push_back({.at_ns = now_ns_,
                   .kind = "session",
                   .level = Event::Level::kWarning,
                   .text = std::move(line),
                   .cause = text.cause,
                   .fix = text.fix});
    tally.reported = tally.now;
    tally.reported_ns = now_ns_;
    tally.has_reported = true;
    if (i == kLate) oldest_us_ = 0;
    if (i == kStoodStill) longest_ms_ = 0;
  }
  return out;
}

}  // namespace tp100::live
