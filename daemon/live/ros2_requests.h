#pragma once
// What ROS 2's programs ask of the daemon, by the rules that hold for viewers: one driver at a
// time, velocities never arm, and whatever is old is worth nothing.

#include <array>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/step_record.h"
#include "messages/messages.h"
#include "ros2/inputs.h"
#include "server/controls.h"

namespace tp100::live {

class Ros2Requests {
 public:
  /// One line about a stream that is ignored is enough for this long, and one about a refusal.
  static constexpr HostNs kQuietNs = 10 * kNsPerS, kRefusedQuietNs = kNsPerS;

  /// `controls` must outlive all requests that it was passed.
  explicit Ros2Requests(server::Controls& controls) : controls_(controls) {}

  // One thread, not the real-time one.
  /// A step: whether the robot may be driven or placed follows from the last one.
  void observe(const StepRecord& record);
  void take(const ros2::Received& received, HostNs now);

  // Any thread:
  /// A line for log and viewers.
  void say(HostNs now, const std::string& text);
  /// Appends the lines since the last call.
  void take_words(std::vector<messages::Event>& words);

 private:
  /// Receives lines from threads of the controls, which may outlive these requests.
  struct Words {
    void add(messages::Event event);
    std::mutex mutex;
    std::vector<messages::Event> all;
  };
  enum Note : std::uint8_t {
    kNotTaken,
    kOtherWriter,
    kRepeated,
    kVelocityRefused,
    kDriveRefused,
    kPoseRefused,
    kCount
  };

  void drive(bool wanted, HostNs now);
  void velocity(const ros2::Received& received, HostNs now);
  void place(const Pose& at, HostNs now);
  void note(Note kind, HostNs now, const std::string& text);

  server::Controls& controls_;
  std::shared_ptr<Words> words_ = std::make_shared<Words>();
  std::array<HostNs, kCount> quiet_until_ns_{};
  StartRefusal drive_refusal_ = StartRefusal::kNoSession;
  RunState run_state_ = RunState::kIdle;
  bool drive_wanted_ = false;  // as last received
  std::string token_;          // empty: ROS 2 does not drive
  std::uint64_t writer_ = 0;   // whose velocities count; 0: the next one's
  ros2::Input writer_input_{};
};

}  // namespace tp100::live
