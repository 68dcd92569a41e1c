#pragma once
// The daemon as node /tp100d of a ROS 2 domain: every topic but those of simulations.

#include "messages/sink.h"
#include "ros2/participant.h"
#include "ros2/topics.h"

namespace tp100::ros2 {

/// Publishes what follows from each step, in the thread that calls it.
class Publisher : public messages::Sink {
 public:
  /// Joins the domain: see Participant.
  Publisher(const config::Ros2Settings& settings, const messages::RunContext& run_context,
            const messages::PublishClock& clock)
      : clock_(clock),
        messages_(run_context, clock, false),
        participant_(settings, "tp100d", kLiveTopics) {
    messages_.begin(clock.start_ns, send_);
  }
  void take(const StepRecord& record) override { messages_.take(record, send_); }
  void take_setup(const messages::RunContext& run_context, HostNs at) override {
    messages_ = TopicMessages(run_context, clock_, false);
    messages_.begin(at, send_);
  }

 private:
  messages::PublishClock clock_;
  TopicMessages messages_;
  Participant participant_;
  TopicMessages::Send send_ = [this](Topic topic, Bytes cdr) {
    participant_.write(topic, std::move(cdr));
  };
};

}  // namespace tp100::ros2
