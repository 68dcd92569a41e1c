#pragma once
// Where counters become messages for the log and for viewers: trouble on a link that is up (frames
// that are corrupted, repeated or late), poses of the camera that are of no use, and a set-up that
// the IMU contradicts. No clock, no port.

#include <array>
#include <cstdint>
#include <vector>

#include "link/camera_intake.h"
#include "messages/messages.h"
#include "messages/sink.h"

namespace tp100::live {

class LinkMonitor : public messages::Sink {
 public:
  /// Shortest time between two reports of one kind; the later one counts everything since the
  /// first. What lasts is said less and less often.
  static constexpr HostNs kQuietNs = 10 * kNsPerS;
  static constexpr HostNs kLongestQuietNs = 320 * kNsPerS;
  /// A sample of at least this age is late: a frame and a cycle of the loop take less.
  static constexpr std::int64_t kLateUs = 15'000;

  void take(const StepRecord& record) override;
  /// The datagrams of the camera's poses so far.
  void take(const link::CameraCounters& poses);
  /// The robot is on a pseudo-terminal: no USB holds its samples back.
  void set_pseudo_terminal(bool is) { pseudo_terminal_ = is; }
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
    kCameraMalformed,
    kCameraLate,
    kCameraRejected,
    kTiltedOnFlat,
    kCount
  };
  /// Count of one kind of trouble, and how much of it was reported.
  struct Tally {
    std::uint64_t now = 0;           ///< count so far
    std::uint64_t reported = 0;      ///< count at the last report
    HostNs reported_ns = -kQuietNs;  ///< time of the last report
    HostNs quiet_ns = kQuietNs;      ///< until the next one
  };
  struct Text;
  static const Text& text_of(std::size_t kind);
  void count(const LinkCounters& link);
  void time(const StepRecord& record);
  void see(const Snapshot& snapshot);
  void tilt(const Snapshot& snapshot);

  std::array<Tally, kCount> tallies_{};
  HostNs now_ns_ = 0;
  std::uint64_t step_ = 0;
  std::int64_t oldest_us_ = 0, longest_ms_ = 0;
  FilterFigures camera_{};          ///< as last seen
  std::uint64_t camera_poses_ = 0;  ///< used or rejected
  std::uint64_t reported_of_ = 0;   ///< at the last report, or when the window began
  HostNs window_ns_ = 0;
  bool pseudo_terminal_ = false;
  double steepest_rad_ = 0.0;
  HostNs tilted_since_ns_ = 0;  ///< 0: it is level
};

}  // namespace tp100::live
