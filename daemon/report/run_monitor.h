#pragma once
// Derives the events of a run from its steps: changes of state, faults, requests, gaps.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/step_record.h"

namespace tp100::report {

struct RunEvent {
  HostNs at_ns = 0;
  std::string text = {}, fix = {};
  bool bad = false;
  double t_s = 0.0;  ///< as in the points of a run; negative before it
};

/// Takes steps in their order.
class RunMonitor {
 public:
  static constexpr std::size_t kMax = 500;

  void step(const StepRecord& record);
  void add(RunEvent event);

  const std::vector<RunEvent>& events() const { return events_; }
  /// Number of events beyond kMax.
  std::uint64_t more() const { return more_; }

 private:
  void states(const StepRecord& record);
  void faults(const StepRecord& record);

  std::vector<RunEvent> events_;
  std::uint64_t more_ = 0;
  bool first_ = true;
  std::uint64_t step_ = 0;
  SessionState session_ = SessionState::kClosed;
  RunState run_ = RunState::kIdle;
  std::optional<RobotState> robot_;
  FaultMask faults_ = 0;
  bool recovering_ = false;
};

}  // namespace tp100::report
