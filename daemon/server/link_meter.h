#pragma once
// Rates of the link over the last second, from its counters. Pure.

#include <deque>

#include "core/step_record.h"
#include "messages/figures.h"

namespace tp100::server {

class LinkMeter {
 public:
  /// Takes the counters of one step.
  void take(const StepRecord& record);
  /// State and rates over the last second; port and sample ages are left to others.
  messages::LinkFigures figures() const;

 private:
  struct Mark {
    HostNs at_ns;
    LinkCounters counters;
  };
  std::deque<Mark> marks_;  // ten a second, the newest last
  LinkCounters last_{};
  HostNs last_ns_ = 0;
  SessionState session_ = SessionState::kClosed;
  ClockState clock_{};
};

}  // namespace tp100::server
