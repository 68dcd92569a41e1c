#pragma once
// A participant of a ROS 2 domain, without ROS: ROS 2 programs see it as a node with these topics.

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "config/configuration.h"
#include "core/bytes.h"
#include "ros2/inputs.h"
#include "ros2/topics.h"

namespace tp100::ros2 {

class Participant {
 public:
  /// Joins the domain as `node`, which publishes `published` and subscribes to `taken`. Its threads
  /// inherit the caller's scheduling and processors: call it from an ordinary thread, before a
  /// real-time loop starts. Throws UserError: no such interface or domain, or this build has no
  /// DDS.
  Participant(const config::Ros2Settings& settings, const std::string& node,
              std::span<const Topic> published, std::span<const Input> taken = {});
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// Publishes a message as TopicMessages makes it, on one of the topics. Allocates, and waits for
  /// no subscriber: a slow one misses the older of the kept messages. One thread.
  void write(Topic topic, Bytes cdr);
  /// Calls `receive` for what has arrived since the last call, in order for each topic; if many
  /// have arrived, for the newest. One thread.
  void take(const std::function<void(const Received&)>& receive);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tp100::ros2
