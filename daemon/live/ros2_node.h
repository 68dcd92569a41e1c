#pragma once
// The daemon as node /tp100d of a ROS 2 domain, in a thread of its own: publishes each step soon
// after it was made, and passes on requests of other nodes.

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "config/configuration.h"
#include "core/step_record.h"
#include "live/active_run.h"
#include "live/live_cycle.h"
#include "loop/rings.h"
#include "messages/event_queue.h"
#include "ros2/inputs.h"
#include "ros2/participant.h"
#include "ros2/publisher.h"
#include "server/controls.h"

namespace tp100::live {

/// Why nodes may request nothing but STOP, in one line; empty: each node on the participant's
/// network may request everything.
std::string why_no_ros2_requests(const config::Configuration& configuration);

/// The daemon's participant; null: switched off. Throws UserError; see ros2::Participant.
std::unique_ptr<ros2::Participant> ros2_participant(const config::Configuration& configuration);

/// Carries out requests of ROS 2 programs, by the rules that hold for viewers: one driver at a
/// time, velocities never arm, and old messages are ignored.
class Ros2Requests {
 public:
  /// Shortest time between two lines about an ignored stream, and between two about refusals.
  static constexpr HostNs kQuietNs = 10 * kNsPerS, kRefusedQuietNs = kNsPerS;
  /// A goal or course starts the robot only after its topic was silent for this long, so that a
  /// node that repeats one does not start the robot again.
  static constexpr HostNs kSilenceNs = 2 * kNsPerS;
  /// A node, or the person who uses it, has seen the STOPs that were this old when it wrote its
  /// message.
  static constexpr HostNs kSeenNs = kNsPerS;
  /// Writers of /tp100/drive that are remembered; the one that was silent longest is forgotten.
  static constexpr std::size_t kMaxWriters = 64;

  /// `controls` must outlive all requests that it was passed, and `events` the controls.
  /// `stop_pressed` is called after a STOP, which is carried out already.
  Ros2Requests(server::Controls& controls, messages::EventQueue& events,
               std::function<void()> stop_pressed)
      : controls_(controls),
        stop_pressed_(std::move(stop_pressed)),
        shared_(std::make_shared<Shared>(events)) {}

  // One thread, not the real-time one.
  /// Takes a step, at `now`; the last one decides whether the robot may start, be driven or be
  /// placed.
  void observe(const StepRecord& record, HostNs now);
  void take(const ros2::Received& received, HostNs now);
  /// The newest answer to a node, once.
  std::optional<messages::Event> take_answer();

  // Any thread:
  /// Sets the course in force; empty: none. Call it before its choice is answered.
  void set_course(const std::string& name);
  /// A line for log and viewers.
  void say(HostNs now, const std::string& text);

 private:
  /// Written by threads of the controls, which may outlive these requests.
  struct Shared {
    explicit Shared(messages::EventQueue& queue) : events(queue) {}
    void say(messages::Event event, bool answers);
    messages::EventQueue& events;
    std::mutex mutex;  // guards what follows
    std::optional<messages::Event> answer;
    std::string course;
    std::pair<std::uint32_t, std::string> choice;  ///< number of the choice that was answered; why
  };
  enum Note : std::uint8_t {
    kNotTaken,
    kOtherWriter,
    kRepeated,
    kStale,
    kVelocityRefused,
    kDriveRefused,
    kPoseRefused,
    kGoalRefused,
    kCourseRefused,
    kMarkRefused,
    kStopped,
    kCount
  };
  /// A start whose course is being chosen.
  struct Start {
    std::uint32_t number = 0;  ///< of the choice
    ros2::Input input{};
    server::SetupChoice choice;
    OperatorRequest request = OperatorRequest::kStart;
    Consent consent{};
    HostNs asked_ns = 0;
    bool chosen = false;  ///< the course is in force
  };
  /// A writer of /tp100/drive.
  struct Writer {
    std::uint64_t id = 0;
    bool said_false = false;  ///< since its last true
  };

  /// The consent that this message of a node is.
  Consent consent_of(const ros2::Received& received, HostNs now);
  void note_stops(HostNs now);
  Writer& writer_of(std::uint64_t id);
  void drive(const ros2::Received& received, bool wanted, HostNs now);
  void velocity(const ros2::Received& received, HostNs now);
  void place(const ros2::Received& received, const Pose& at, HostNs now);
  void start(const ros2::Received& received, const server::SetupChoice& choice,
             OperatorRequest request, HostNs now);
  void advance(Start& start, const Snapshot& snapshot, HostNs now);
  std::string why_not(const Start& start, const Snapshot& snapshot) const;
  void stop(HostNs now);
  void reply(HostNs now, const std::string& text);
  void note(Note kind, HostNs now, const std::string& text);
  void refuse(ros2::Input input, HostNs now, const std::string& why);

  server::Controls& controls_;
  const std::function<void()> stop_pressed_;
  std::shared_ptr<Shared> shared_;
  std::array<HostNs, kCount> quiet_until_ns_{};
  StartRefusal drive_refusal_ = StartRefusal::kNoSession;
  RunState run_state_ = RunState::kIdle;
  Pose at_{};                          // in the course's world
  std::vector<HostNs> stop_times_;     // when the last STOPs were noted here, oldest first
  std::uint64_t stops_ = 0;            // noted so far
  std::vector<Writer> drive_writers_;  // the last to write is last
  std::string token_;                  // empty: ROS 2 does not drive
  std::uint64_t writer_ = 0;           // whose velocities count; 0: the next one's
  ros2::Input writer_input_{};
  std::optional<Start> start_;
  std::uint32_t choices_ = 0;
  std::array<HostNs, ros2::kInputCount> silent_until_ns_{};  // of inputs that start
};

class Ros2Node {
 public:
  /// Starts the thread. `requests`: for those of other nodes; `why_no_requests` is for the log,
  /// empty: they are taken. All others must outlive the node, and so must the node the loop that
  /// `cycle` is in.
  Ros2Node(ros2::Participant& participant, messages::RunContext run_context,
           const messages::PublishClock& clock, LiveCycle& cycle, Ros2Requests requests,
           const std::string& why_no_requests);
  /// Publishes what is left.
  ~Ros2Node();

  /// Any thread.
  void exchange(const Exchange& exchange);

 private:
  void run();
  HostNs publish();

  ros2::Participant& participant_;
  ros2::Publisher publisher_;
  Ros2Requests requests_;
  loop::SlotRing<StepRecord> steps_;
  std::mutex mutex_;  // guards next_
  std::optional<Exchange> next_;
  // The node's thread only:
  HostNs last_step_ns_ = 0;
  HostNs period_ns_ = 0;
  HostNs due_ns_ = 0;  // the next step
  std::atomic<bool> stop_{false};
  std::thread thread_;  // declared last: it uses the others
};

}  // namespace tp100::live
