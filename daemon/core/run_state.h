#pragma once
// States of a run, as printed in `state: A -> B` and in snapshots.

#include <cstdint>
#include <string_view>

namespace tp100 {

enum class RunState : std::uint8_t {
  kIdle,      ///< no run; commands say "stand still"
  kArming,    ///< operator started; robot not armed yet
  kRunning,   ///< following the course
  kFinished,  ///< path completed, robot disarmed
  kAborted,   ///< a fault ended the run, robot disarmed; its cause is latched
};

/// Name as printed in `state: A -> B`.
std::string_view to_string(RunState state);

}  // namespace tp100
