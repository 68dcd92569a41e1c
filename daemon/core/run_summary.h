#pragma once
// How a run went, from its steps. Pure.

#include <algorithm>
#include <cmath>

#include "core/step_record.h"

namespace tp100 {

struct RunSummary {
  HostNs began_ns = 0, ended_ns = 0;  ///< under way; 0: never
  double distance_m = 0.0;            ///< along the path
  double largest_m = 0.0;             ///< largest distance from the path
  bool by_hand = false;
  RunState end = RunState::kIdle;  ///< after it, or so far
  FaultMask faults = 0;            ///< then

  /// A run or a drive begins with its arming, and is forgotten when the next one begins.
  void take(const StepRecord& record) {
    const Snapshot& now = record.snapshot;
    const bool on = under_way(now.run_state);
    if (on && !under_way(end)) *this = {.began_ns = record.now_ns};
    if (began_ns == 0 || (!on && !under_way(end))) return;
    end = now.run_state;
    faults = now.faults;
    ended_ns = record.now_ns;
    by_hand = by_hand || end == RunState::kDriving;
    if (end == RunState::kRunning || end == RunState::kFinished) {
      distance_m = now.progress_m;
      largest_m = std::max(largest_m, std::abs(now.cross_track_m));
    }
  }
};

}  // namespace tp100
