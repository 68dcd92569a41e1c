#pragma once
// The daemon as node /tp100d of a ROS 2 domain, in a thread of its own: publishes each step soon
// after it was made, and passes on requests of other nodes.

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "config/configuration.h"
#include "live/active_run.h"
#include "live/live_cycle.h"
#include "live/ros2_requests.h"
#include "loop/rings.h"
#include "ros2/participant.h"
#include "ros2/publisher.h"

namespace tp100::live {

/// Why nodes may request nothing but STOP, in one line; empty: each node on the participant's
/// network may request everything.
std::string why_no_ros2_requests(const config::Configuration& configuration);

/// The daemon's participant; null: switched off. Throws UserError; see ros2::Participant.
std::unique_ptr<ros2::Participant> ros2_participant(const config::Configuration& configuration);

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
  Ros2Node(const Ros2Node&) = delete;
  Ros2Node& operator=(const Ros2Node&) = delete;

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
