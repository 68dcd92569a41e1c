#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "../link/scripted_robot.h"
#include "course/course.h"
#include "live/live_cycle.h"
#include "support/real_time_monitor.h"

namespace tp100::live {

/// A cycle with a scripted robot, whose steps can be monitored for calls that a real-time thread
/// must not make.
class LiveRig {
 public:
  explicit LiveRig(std::shared_ptr<const course::Course> course = nullptr)
      : cycle(bridge::session_settings({}), {}, std::move(course), false) {
    cycle.opened(now);
  }
  void step() {
    now += 5 * kNsPerMs;
    robot.tick(now);
    const std::vector<std::uint8_t> bytes = robot.take();
    {
      // A sanitizer may make system calls when it meets a type for the first time: the monitor
      // covers only these calls.
      std::optional<test::RealTimeMonitor> watch;
      if (watched) watch.emplace(duty);
      cycle.received(bytes, now);
      cycle.step(now);
      cycle.wrote(now);
      cycle.after_write(now);
    }
    robot.receive(cycle.output(), now);
    cycle.written(cycle.output().size());
    LiveEvent event;
    while (cycle.take_event(event)) {
    }
  }
  // Number of the oldest waiting record; 0 if there is none.
  std::uint64_t front() const {
    const StepRecord* record = cycle.front_record();
    return record == nullptr ? 0 : record->step;
  }
  bool watched = false;
  test::RealTimeViolations duty;
  HostNs now = kNsPerS;
  ScriptedRobot robot;
  void steps(int count) {
    for (int i = 0; i < count; ++i) {
      step();
      while (cycle.front_record() != nullptr) cycle.release_record();
    }
  }
  /// Requests a start by a person who sees the robot now; `first_only`: as the first Enter.
  void start(bool first_only = false, OperatorRequest what = OperatorRequest::kStart) {
    cycle.request(what, {.acted_ns = now,
                         .seen_ns = now,
                         .stops_seen = first_only ? 0 : cycle.consents().stops(),
                         .first_only = first_only});
  }
  std::size_t arms() const { return robot.received.arms.size(); }
  LiveCycle cycle;
};

}  // namespace tp100::live
