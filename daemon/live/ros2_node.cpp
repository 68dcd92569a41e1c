#include "live/ros2_node.h"

#include <pthread.h>

#include <algorithm>
#include <utility>

#include "core/clock.h"
#include "loop/pacing.h"

namespace tp100::live {
namespace {

// The loop wakes no other thread. This thread looks for the next step a little after it is due, so
// as not to wake together with the loop; if there is none, it looks again repeatedly. A step that
// comes late does not delay the next one: what is due follows the early ones.
constexpr HostNs kAfterStepNs = 300 * kNsPerUs;
constexpr HostNs kAgainNs = kNsPerMs / 2;
constexpr HostNs kLongestNs = 5 * kNsPerMs;
// Period and phase of the steps are means over about so many of them.
constexpr HostNs kMeanOf = 16;
constexpr HostNs kLongestPeriodNs = 20 * kNsPerMs;
// Steps that wait while the thread does not run; on a busy machine that can last half a second.
constexpr std::size_t kWaitingSteps = 256;

// STOP is last: it is accepted from everybody, alone if nothing else is.
constexpr std::array kInputs = {ros2::Input::kVelocity, ros2::Input::kVelocityStamped,
                                ros2::Input::kDrive,    ros2::Input::kInitialPose,
                                ros2::Input::kGoal,     ros2::Input::kCourse,
                                ros2::Input::kMark,     ros2::Input::kStop};

}  // namespace

std::string why_no_ros2_requests(const config::Configuration& configuration) {
  const config::CommandsFrom from = configuration.server.commands;
  if (from == config::CommandsFrom::kNone) return "server.commands is \"none\"";
  if (from == config::CommandsFrom::kLocal && configuration.ros2.interface != "lo")
    return "server.commands is \"local\", and ros2.interface is not lo";
  return {};
}

std::unique_ptr<ros2::Participant> ros2_participant(const config::Configuration& configuration) {
  if (!configuration.ros2.enabled) return nullptr;
  const std::span<const ros2::Input> all(kInputs);
  const bool taken = why_no_ros2_requests(configuration).empty();
  return std::make_unique<ros2::Participant>(configuration.ros2, "tp100d", ros2::kLiveTopics,
                                             taken ? all : all.last(1));
}

Ros2Node::Ros2Node(ros2::Participant& participant, messages::RunContext run_context,
                   const messages::PublishClock& clock, LiveCycle& cycle, Ros2Requests requests,
                   const std::string& why_no_requests)
    : participant_(participant),
      publisher_(participant, std::move(run_context), clock, false),
      requests_(std::move(requests)),
      steps_(kWaitingSteps),
      thread_([this] { run(); }) {
  ::pthread_setname_np(thread_.native_handle(), "ros2");
  cycle.record_first(steps_);
  requests_.say(clock.start_ns, why_no_requests.empty()
                                    ? "ROS 2 may drive (/tp100/drive, /cmd_vel) and start "
                                      "(/goal_pose, /tp100/course)"
                                    : "ROS 2 may not drive: " + why_no_requests);
}

Ros2Node::~Ros2Node() {
  stop_.store(true, std::memory_order_relaxed);
  thread_.join();
}

void Ros2Node::exchange(const Exchange& exchange) {
  requests_.set_course(exchange.run->course());
  const std::lock_guard lock(mutex_);
  next_ = exchange;
}

/// Publishes the waiting steps, and returns when to look for the next one.
HostNs Ros2Node::publish() {
  if (const auto answer = requests_.take_answer()) publisher_.answer(*answer);
  std::optional<Exchange> next;
  {
    const std::lock_guard lock(mutex_);
    next = std::exchange(next_, std::nullopt);
  }
  if (next) publisher_.exchange(next->run->context, *next->for_nodes);
  while (const StepRecord* step = steps_.front()) {
    publisher_.take(*step);
    requests_.observe(*step, monotonic_now());
    const HostNs period_ns = step->now_ns - std::exchange(last_step_ns_, step->now_ns);
    period_ns_ += (std::min(period_ns, kLongestPeriodNs) - period_ns_) / kMeanOf;
    const HostNs late_ns = step->now_ns - due_ns_;
    due_ns_ = late_ns > 0 && late_ns < period_ns_ ? due_ns_ + late_ns / kMeanOf : step->now_ns;
    due_ns_ += period_ns_;
    steps_.release();
  }
  return std::max(std::min(due_ns_, last_step_ns_ + kLongestNs) + kAfterStepNs,
                  monotonic_now() + kAgainNs);
}

void Ros2Node::run() {
  while (!stop_.load(std::memory_order_relaxed)) {
    const HostNs next_ns = publish();
    const HostNs now = monotonic_now();
    participant_.take([&](const ros2::Received& received) { requests_.take(received, now); });
    loop::sleep_until(next_ns);
  }
  publish();
}

}  // namespace tp100::live
