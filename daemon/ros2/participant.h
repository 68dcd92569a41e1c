#pragma once
// The daemon as a participant of a ROS 2 domain, without ROS: any ROS 2 program finds a node
// /tp100d with the topics of topics.h.

#include <memory>

#include "config/configuration.h"
#include "messages/messages.h"
#include "messages/sink.h"

namespace tp100::ros2 {

/// Joins the domain and returns what publishes each step, in the thread that calls it; publishing
/// does not wait for subscribers. The threads that it starts have the caller's scheduling and
/// processors: to be called from an ordinary thread, before the real-time loop starts. Throws
/// SetupError: no such interface or domain, or this build has no DDS.
std::unique_ptr<messages::Sink> join_domain(const config::Ros2Settings& settings,
                                            const messages::RunContext& run_context,
                                            const messages::PublishClock& clock);

}  // namespace tp100::ros2
