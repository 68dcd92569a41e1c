#include "live/link_monitor.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "core/faults.h"
#include "core/limits.h"

namespace tp100::live {
namespace {

using messages::Event;

// A false detection now and then is usual; so are a bump and a push.
constexpr std::uint64_t kFewestPoses = 30;
constexpr double kUsualShare = 0.2;
constexpr double kTiltedRad = 8.0 * kRadPerDeg;
constexpr HostNs kTiltedNs = 300 * kNsPerMs;

}  // namespace

struct LinkMonitor::Text {
  std::uint64_t least;  // a session's first frames and a brief pause do not count
  const char* kind;
  const char* what;
  const char* cause;
  std::string fix;
};

void LinkMonitor::take(const StepRecord& record) {
  count(record.link);
  time(record);
  see(record.snapshot);
  tilt(record.snapshot);
}

void LinkMonitor::take(const link::CameraCounters& poses) {
  tallies_[kCameraMalformed].now = poses.malformed;
  tallies_[kCameraLate].now = poses.late + poses.early;
}

void LinkMonitor::see(const Snapshot& snapshot) {
  const FilterFigures& now = snapshot.filter;
  // The step counts anew with each run.
  const auto more = [](std::uint32_t before, std::uint32_t after) {
    return after < before ? after : after - before;
  };
  const std::uint32_t rejected = more(camera_.camera_rejected, now.camera_rejected);
  camera_poses_ += rejected + more(camera_.camera_used, now.camera_used);
  tallies_[kCameraRejected].now += rejected;
  camera_ = now;
  // What was usual long ago says nothing about now.
  if (now_ns_ - window_ns_ < kQuietNs) return;
  window_ns_ = now_ns_;
  tallies_[kCameraRejected].reported = tallies_[kCameraRejected].now;
  reported_of_ = camera_poses_;
}

void LinkMonitor::tilt(const Snapshot& snapshot) {
  const double pitch_rad = std::abs(snapshot.imu_pitch_rad);
  const bool tilted = armed(snapshot.run_state) && pitch_rad > kTiltedRad &&
                      snapshot.terrain_contact.pitch_source != PitchSource::kImu;
  if (!tilted) {
    tilted_since_ns_ = 0;
    return;
  }
  steepest_rad_ = std::max(steepest_rad_, pitch_rad);
  if (tilted_since_ns_ == 0) tilted_since_ns_ = now_ns_;
  const bool counted = tilted_since_ns_ < 0;
  if (counted || now_ns_ - tilted_since_ns_ < kTiltedNs) return;
  ++tallies_[kTiltedOnFlat].now;
  tilted_since_ns_ = -1;
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
  if (gap_ns > from_s(kLongestSeenS)) {
    ++tallies_[kStoodStill].now;
    longest_ms_ = std::max(longest_ms_, gap_ns / kNsPerMs);
  }
  const Snapshot& snapshot = record.snapshot;
  if (record.inputs.session != SessionState::kReady || !snapshot.has_sample) return;
  if (snapshot.age_us <= kLateUs) return;
  ++tallies_[kLate].now;
  oldest_us_ = std::max(oldest_us_, snapshot.age_us);
}

const LinkMonitor::Text& LinkMonitor::text_of(std::size_t kind) {
  static const std::array<Text, kCount> kTexts{
      {{1, "session", "corrupted frames",
        "bytes change or are lost on their way, or another program writes",
        "check cable and hub; run tp100d doctor to examine the port"},
       {1, "session", "frames corrupted on their way to the robot",
        "bytes change or are lost, or its board was busy for too long",
        "check cable and hub; run tp100d doctor to examine the port"},
       {1, "session", "encoder edges missed by the robot",
        "an encoder's wires pick up noise or make bad contact",
        "check the encoders' plugs and shields"},
       {1, "session", "frames of an unknown type or size",
        "the firmware or another program sends other messages",
        "flash the board with " + flash_command() + "; run tp100d doctor to examine the port"},
       {5, "session", "samples repeated or out of order", "a hub or its driver repeats or reorders",
        "use another cable or hub"},
       {1, "session", "impossible values", "glitches on an encoder's wires, or a clock that jumped",
        "check the encoders' plugs and shields, and the board's supply"},
       {5, "session", "unusable replies to clock requests",
        "they arrive late, twice or out of order", "use another cable or hub"},
       {1, "session", "frames that the port did not accept",
        "the robot or its USB bridge reads nothing", "check the cable; plug it in again"},
       {3, "session", "steps without a fresh sample",
        "a USB bridge or hub holds data back, or the machine is busy",
        "set the bridge's latency timer to 1 ms; run tp100d doctor to examine the machine"},
       {1, "session", "cycles of the loop that started late",
        "the machine is busy or the loop lacks privileges",
        "end other programs; see the lines `real time:` and tp100d doctor"},
       {1, "camera", "malformed poses of the camera",
        "its program sends another format, or numbers out of range",
        "use tp100-camera of this version; see the camera's datagrams in CAMERA.md"},
       {10, "camera", "poses of the camera that arrived too late or from the future",
        "the camera's program, the machine or the network holds them back, or the stamps are of "
        "another clock",
        "check the load of both machines and the stamps; see camera.max_age_ms"},
       {1, "camera", "poses of the camera rejected",
        "they contradict the robot's own sensors: mirrored, turned or scaled, false detections, or "
        "the robot was moved",
        "check the camera's image, its view file and the markers"},
       {1, "run", "times that the IMU measured a slope on a set-up without one",
        "the set-up does not match the floor: only on terrain are ramps and blocks real",
        "start with --setup terrain, or take the obstacles off the floor"}}};
  return kTexts[kind];
}

std::vector<Event> LinkMonitor::drain_events() {
  std::vector<Event> out;
  for (std::size_t i = 0; i < kCount; ++i) {
    Tally& tally = tallies_[i];
    const Text& text = text_of(i);
    if (tally.now < tally.reported + text.least) continue;
    const HostNs since_ns = now_ns_ - tally.reported_ns;
    if (since_ns < tally.quiet_ns) continue;
    const std::uint64_t fresh = tally.now - tally.reported, poses = camera_poses_ - reported_of_;
    const double share = static_cast<double>(fresh) / static_cast<double>(std::max(poses, fresh));
    if (i == kCameraRejected && (poses < kFewestPoses || share < kUsualShare)) continue;
    std::string line = std::to_string(fresh) + " " + text.what;
    if (i == kLate) line += ", the oldest of " + std::to_string(oldest_us_ / 1000) + " ms";
    if (i == kStoodStill) line += ", the longest after " + std::to_string(longest_ms_) + " ms";
    if (i == kCameraRejected) line += ", of " + std::to_string(poses);
    if (i == kTiltedOnFlat)
      line += ", up to " + std::to_string(std::lround(steepest_rad_ * kDegPerRad)) + " deg";
    const bool no_usb = i == kLate && pseudo_terminal_;
    out.push_back({.at_ns = now_ns_,
                   .kind = text.kind,
                   .level = Event::Level::kWarning,
                   .text = std::move(line),
                   .cause = no_usb ? "the machine is busy" : text.cause,
                   .fix = no_usb ? "end other programs; tp100d doctor tells the load" : text.fix});
    tally.quiet_ns =
        since_ns < 2 * tally.quiet_ns ? std::min(2 * tally.quiet_ns, kLongestQuietNs) : kQuietNs;
    tally.reported = tally.now;
    tally.reported_ns = now_ns_;
    if (i == kLate) oldest_us_ = 0;
    if (i == kStoodStill) longest_ms_ = 0;
    if (i == kCameraRejected) reported_of_ = camera_poses_;
    if (i == kTiltedOnFlat) steepest_rad_ = 0.0;
  }
  return out;
}

}  // namespace tp100::live
