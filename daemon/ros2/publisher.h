#pragma once
// The results of steps on the topics of a participant.

#include <utility>

#include "messages/sink.h"
#include "ros2/participant.h"
#include "ros2/topics.h"

namespace tp100::ros2 {

/// Publishes what follows from each step, in the thread that calls it.
class Publisher : public messages::Sink {
 public:
  /// `participant`, which publishes kLiveTopics, and with `virtual_time` also kVirtualTopics, must
  /// outlive the publisher.
  Publisher(Participant& participant, messages::RunContext run_context,
            const messages::PublishClock& clock, bool virtual_time)
      : participant_(participant),
        clock_(clock),
        virtual_time_(virtual_time),
        messages_(std::move(run_context), clock, virtual_time) {
    messages_.begin(clock.start_ns, send_);
  }
  void take(const StepRecord& record) override { messages_.take(record, send_); }
  void take_truth(HostNs at, const Pose& truth) {
    if (virtual_time_) send_(Topic::kGroundTruth, ground_truth(clock_.unix_ns(at), truth));
  }
  /// Another course, robot or set-up is in force; `setup` are its messages, made elsewhere.
  void exchange(messages::RunContext run_context, const SetupMessages& setup) {
    messages_.exchange(std::move(run_context));
    for (const auto& [topic, cdr] : setup) send_(topic, cdr);
  }

  /// Publishes an answer to a node.
  void answer(const messages::Event& answer) { messages_.answer(answer); }

 private:
  Participant& participant_;
  messages::PublishClock clock_;
  bool virtual_time_;
  TopicMessages messages_;
  TopicMessages::Send send_ = [this](Topic topic, Bytes cdr) {
    participant_.write(topic, std::move(cdr));
  };
};

}  // namespace tp100::ros2
