#pragma once
// How long the robot takes to confirm a STOP. Pure: fed with times.

#include <string>

#include "messages/figures.h"

namespace tp100::server {

class StopWatch {
 public:
  static constexpr HostNs kLimitNs = 200 * kNsPerMs;

  /// Somebody pressed STOP. While one is unanswered, its time runs on.
  void press(const std::string& by, HostNs now);
  /// The robot acknowledged one.
  void answered(HostNs at);
  /// A run was under way at host time `at`, and perhaps began then. Only a start ends a STOP; a run
  /// that goes on at the moment of the press does not know of it yet.
  void under_way(HostNs at, bool began) {
    if (at > pressed_ns_ + (began ? 0 : kLimitNs)) figures_.latched = false;
  }
  /// Time passes. True if the state changed.
  bool tick(HostNs now);

  const messages::StopFigures& figures() const { return figures_; }
  bool unanswered() const {
    return figures_.status == messages::StopFigures::Status::kPending ||
           figures_.status == messages::StopFigures::Status::kNotAcknowledged;
  }

 private:
  messages::StopFigures figures_{};
  HostNs pressed_ns_ = 0;  // last
};

}  // namespace tp100::server
