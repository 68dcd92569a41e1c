#pragma once
// Publishes steps and events on the channels, decides when, and keeps the last minutes. No socket;
// one thread; time is passed in.

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/limits.h"
#include "core/run_summary.h"
#include "core/time.h"
#include "messages/channels.h"
#include "messages/figures.h"
#include "messages/messages.h"
#include "messages/path_history.h"
#include "server/broker.h"
#include "server/controls.h"

namespace tp100::server {

/// Rates of the link over the last second, from its counters. Pure.
class LinkMeter {
 public:
  void take(const StepRecord& record);
  /// State and rates over the last second; leaves port and sample ages unset.
  messages::LinkFigures figures() const;

 private:
  struct Mark {
    HostNs at_ns;
    LinkCounters counters;
  };
  std::deque<Mark> marks_;        // ten a second, the newest last
  messages::LinkFigures last_{};  // without rates
  HostNs last_ns_ = 0;
};

/// Measures how long the robot takes to acknowledge a STOP. Pure: times are passed in.
class StopMonitor {
 public:
  /// STOP was pressed. A press while one is unanswered does not restart its time.
  void press(const std::string& by, HostNs now);
  void answered(HostNs at);
  /// A run was under way at host time `at`, and may have begun then (`began`). Only a start ends a
  /// STOP; a run under way when STOP is pressed has not received it yet.
  void under_way(HostNs at, bool began) {
    if (at > pressed_ns_ + (began ? 0 : kAnswerNs)) figures_.latched = false;
  }
  /// Call it regularly. True if the state changed.
  bool tick(HostNs now);

  const messages::StopFigures& figures() const { return figures_; }
  bool unanswered() const {
    return figures_.status == messages::StopFigures::Status::kPending ||
           figures_.status == messages::StopFigures::Status::kNotAcknowledged;
  }

 private:
  messages::StopFigures figures_{};
  HostNs pressed_ns_ = 0;   // time of the last press
  HostNs answered_ns_ = 0;  // ... and acknowledgement, which may be told before its press
};

/// The messages of the channels of figures over the last minutes, at a reduced rate, for pages that
/// are opened later.
class History {
 public:
  static constexpr HostNs kIntervalNs = 200 * kNsPerMs;
  static constexpr HostNs kSpanNs = 300 * kNsPerS;
  /// Limit of one channel; its oldest messages are dropped first.
  static constexpr std::size_t kMaxBytes = std::size_t{4} << 20;

  /// Whether the channel is kept at all, and a message of it is due.
  bool due(messages::Channel channel, HostNs now) const;
  void take(messages::Channel channel, HostNs now, std::string_view json);
  /// The messages of a topic without its slash in its last seconds, oldest first, as a JSON array;
  /// nothing: no such topic is kept.
  std::optional<std::string> json(std::string_view topic, double span_s = to_s(kSpanNs)) const;

 private:
  struct Message {
    HostNs at_ns;
    std::string json;
  };
  struct Line {
    messages::Channel channel;
    std::string_view topic;
    std::deque<Message> messages{};
    std::size_t bytes = 0;
    HostNs due_ns = 0;
  };
  std::array<Line, 7> lines_ = {{{messages::Channel::kEstimate, "estimate"},
                                 {messages::Channel::kSample, "sample"},
                                 {messages::Channel::kCommand, "command"},
                                 {messages::Channel::kSlip, "slip"},
                                 {messages::Channel::kLink, "link"},
                                 {messages::Channel::kLoop, "loop"},
                                 {messages::Channel::kState, "state"}}};
};

class Publisher {
 public:
  /// `broker` and `controls` must outlive the publisher.
  Publisher(Broker& broker, messages::Messages messages, Controls& controls);

  /// Another course, robot or set-up is in force; `setup` are its messages, made elsewhere.
  void exchange(messages::RunContext run_context, const messages::SharedMessages& setup,
                HostNs now);
  void take(const StepRecord& record);
  void take(const messages::Event& event);
  void take_image(HostNs at, std::string_view jpeg);
  /// `figures`: of the clients, without their subscriptions.
  void take(messages::ClientsFigures figures, HostNs now);
  /// The server could not do what a viewer asked for.
  void failed(const std::string& why, HostNs now);
  /// STOP was pressed; the robot acknowledged one.
  void stop_pressed(const std::string& by, HostNs now);
  void stop_answered(HostNs at, HostNs now);
  /// Call it twenty times a second or more.
  void tick(HostNs now);

  const messages::StateFigures& state() const { return state_; }
  const History& history() const { return history_; }
  const StopMonitor& stop() const { return stop_; }
  const messages::RunContext& run_context() const { return messages_.run_context(); }
  const messages::PublishClock& clock() const { return messages_.clock(); }
  /// Time of the last step taken.
  HostNs last_step_ns() const { return last_step_ns_; }

 private:
  /// True once in every `period`.
  struct Every {
    HostNs period_ns;
    HostNs next_ns = 0;
    bool due(HostNs now) {
      if (now < next_ns) return false;
      restart(now);
      return true;
    }
    void restart(HostNs now) { next_ns = now + period_ns; }
  };

  void publish(messages::Channel channel, HostNs at, std::string json);
  void publish_setup(const messages::SharedMessages& setup, HostNs at);
  void update_state(const StepRecord& record);
  std::string why_not_drive() const;
  void publish_state(HostNs now, bool always);
  void publish_recording(HostNs now);

  Broker& broker_;
  messages::Messages messages_;
  messages::StepMessages step_messages_;
  Controls& controls_;
  LinkMeter link_;
  History history_;
  messages::PathHistory path_history_;
  StopMonitor stop_;
  messages::StateFigures state_{};
  StartRefusal drive_refusal_ = StartRefusal::kNoSession;
  std::shared_ptr<const std::string> whole_path_history_;
  HostNs last_step_ns_ = 0;
  HostNs run_began_ns_ = 0;
  RunSummary summary_;
  HostNs last_stop_event_ns_ = -kNsPerS;
  std::string last_state_key_;
  messages::RecordingFigures last_recording_{};
  Every link_due_{200 * kNsPerMs}, loop_due_{500 * kNsPerMs}, state_due_{200 * kNsPerMs},
      path_history_due_{500 * kNsPerMs}, recording_due_{kNsPerS};
};

}  // namespace tp100::server
