#pragma once
// From steps and events to channels: what is said when. No socket; one thread; time is passed in.

#include <memory>
#include <optional>
#include <string>

#include "messages/messages.h"
#include "messages/trail.h"
#include "server/controls.h"
#include "server/hub.h"
#include "server/link_meter.h"
#include "server/stop_watch.h"

namespace tp100::server {

class Feed {
 public:
  /// `hub` and `controls` must outlive the feed.
  Feed(Hub& hub, messages::Messages messages, Controls& controls);

  void take(const StepRecord& record);
  void take_truth(const messages::Truth& truth) { truth_ = truth; }
  void take(const messages::Event& event);
  /// Somebody pressed STOP; the robot answered one.
  void stop_pressed(const std::string& by, HostNs now);
  void stop_answered(HostNs at, HostNs now);
  /// Time passes; call it twenty times a second or more.
  void tick(HostNs now);

  const messages::StateFigures& state() const { return state_; }
  const StopWatch& stop() const { return stop_; }
  const messages::Subject& subject() const { return messages_.subject(); }
  const messages::PublishClock& clock() const { return messages_.clock(); }
  /// When the last step was taken.
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
  void publish_step(const StepRecord& record);
  void update_state(const StepRecord& record);
  void publish_state(HostNs now, bool always);
  void publish_recording(HostNs now);

  Hub& hub_;
  messages::Messages messages_;
  Controls& controls_;
  LinkMeter link_;
  messages::Trail trail_;
  StopWatch stop_;
  messages::StateFigures state_{};
  std::shared_ptr<const std::string> whole_trail_;
  std::optional<messages::Truth> truth_;
  HostNs truth_sent_ns_ = 0;
  HostNs last_step_ns_ = 0;
  HostNs run_began_ns_ = 0;
  HostNs last_stop_event_ns_ = -kNsPerS;
  std::string last_state_key_;
  messages::RecordingFigures last_recording_{};
  Every slip_{50 * kNsPerMs}, link_due_{200 * kNsPerMs}, loop_due_{500 * kNsPerMs},
      state_due_{200 * kNsPerMs}, trail_due_{500 * kNsPerMs}, recording_due_{kNsPerS};
};

}  // namespace tp100::server
