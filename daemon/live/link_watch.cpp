#include "live/link_watch.h"

#include <algorithm>

#include "core/flash_command.h"

namespace tp100::live {
namespace {

using messages::Event;

// Of the loop; a machine that runs other programs too may take that long now and then.
constexpr HostNs kStillNs = 50 * kNsPerMs;

struct Text {
  std::uint64_t least;  // a session's beginning and a moment's pause are no trouble
  const char* what;
  const char* cause;
  std::string remedy;
};

}  // namespace

void LinkWatch::take(const StepRecord& record) {
  count(record.link);
  time(record);
}

void LinkWatch::count(const LinkCounters& link) {
  tallies_[kDamaged].now = link.damaged();
  tallies_[kRobotDamaged].now = link.robot_damaged;
  tallies_[kMissedEdges].now = link.missed_edges;
  tallies_[kForeign].now = link.unknown_type + link.wrong_size;
  tallies_[kRepeated].now = link.duplicated + link.reordered;
  tallies_[kImplausible].now = link.implausible;
  tallies_[kClockAnswers].now = link.sync_rejected;
  tallies_[kUnwritten].now = link.unwritten;
}

void LinkWatch::time(const StepRecord& record) {
  // A step that is missing here found no room on its way; the loop made it.
  const bool next = record.step == step_ + 1;
  const HostNs gap_ns = next && now_ns_ != 0 ? record.now_ns - now_ns_ : 0;
  now_ns_ = record.now_ns;
  step_ = record.step;
  if (gap_ns > kStillNs) {
    ++tallies_[kStoodStill].now;
    longest_ms_ = std::max(longest_ms_, gap_ns / kNsPerMs);
  }
  const Snapshot& snapshot = record.snapshot;
  if (record.session != SessionState::kReady || !snapshot.has_sample) return;
  if (snapshot.age_us <= kLateUs) return;
  ++tallies_[kLate].now;
  oldest_us_ = std::max(oldest_us_, snapshot.age_us);
}

std::vector<Event> LinkWatch::take_words() {
  static const std::array<Text, kCount> kTexts{
      {{1, "damaged frames", "bytes change or are lost on their way, or another program writes",
        "check cable and hub; see what tp100d doctor says of the port"},
       {1, "frames damaged on their way to the robot",
        "bytes change or are lost, or its board was busy for too long",
        "check cable and hub; see what tp100d doctor says of the port"},
       {1, "encoder edges missed by the robot",
        "an encoder's wires pick up noise or make bad contact",
        "check the encoders' plugs and shields"},
       {1, "frames that no robot sends", "the firmware or another program speaks other messages",
        "flash the board with " + flash_command() + "; see what tp100d doctor says of the port"},
       {5, "samples that come again or too late", "a hub or its driver repeats or reorders",
        "use another cable or hub"},
       {1, "values that cannot be", "glitches on an encoder's wires, or a clock that jumped",
        "check the encoders' plugs and shields, and the board's supply"},
       {5, "answers to clock requests that are of no use", "they come late, twice or not in turn",
        "use another cable or hub"},
       {1, "frames that the port did not take", "the robot or its USB bridge reads nothing",
        "check the cable; plug it in again"},
       {3, "steps without a fresh sample", "a USB bridge or hub that waits, or a busy machine",
        "set the bridge's latency timer to 1 ms; see what tp100d doctor says of the machine"},
       {1, "turns of the loop that came late", "the machine is busy or the loop has no rights",
        "end other programs; see the lines `real time:` and tp100d doctor"}}};
  std::vector<Event> out;
  for (std::size_t i = 0; i < kCount; ++i) {
    Tally& tally = tallies_[i];
    const Text& text = kTexts[i];
    if (tally.now < tally.said + text.least) continue;
    if (tally.spoken && now_ns_ - tally.said_ns < kQuietNs) continue;
    std::string line = std::to_string(tally.now - tally.said) + " " + text.what;
    if (i == kLate) line += ", the oldest of " + std::to_string(oldest_us_ / 1000) + " ms";
    if (i == kStoodStill) line += ", the longest after " + std::to_string(longest_ms_) + " ms";
    out.push_back({.at_ns = now_ns_,
                   .kind = "session",
                   .level = Event::Level::kWarning,
                   .text = std::move(line),
                   .cause = text.cause,
                   .remedy = text.remedy});
    tally.said = tally.now;
    tally.said_ns = now_ns_;
    tally.spoken = true;
    if (i == kLate) oldest_us_ = 0;
    if (i == kStoodStill) longest_ms_ = 0;
  }
  return out;
}

}  // namespace tp100::live
