#pragma once
// `tp100d replay` of a recording: runs its inputs through the step again and checks whether every
// pose and command is reproduced: bit for bit, or, if it was recorded on another kind of processor
// (core/arithmetic.h), except for rounding.

#include <functional>
#include <optional>
#include <string>

#include "bridge/step.h"
#include "config/run_setup.h"
#include "record/recording.h"
#include "record/step_difference.h"

namespace tp100::app {

/// The files of a recorded run. Throws UserError: they are missing or invalid.
config::RunFiles recorded_files(const record::Recording& recording);

/// Result of a replay.
struct Replayed {
  std::uint64_t first = 1;   ///< number of the first step: 1, or a restart of the step
  std::uint64_t steps = 0;   ///< replayed
  std::uint64_t before = 0;  ///< of them before the recording, to reach its initial state
  HostNs last_ns = 0;        ///< time of the last step that was compared
  /// First step after a gap. A gap ends the replay, since the state after it is unknown.
  std::optional<std::uint64_t> gap_before;
  std::optional<std::uint64_t> differs_at;  ///< number of the first step with a different result
  HostNs differs_ns = 0;                    ///< its time
  record::StepDifference difference{};
  record::LargestDifference largest{};  ///< of all steps
};

/// Differences from results of another kind of processor below this, in m and rad, are rounding.
inline constexpr double kRounding = 1e-9;

/// Feeds the recorded inputs to a step with these parameters and course. `each` receives the
/// recorded inputs with the results of the replay. `verify`: compares the results.
Replayed replay_steps(const record::Recording& recording, const bridge::Parameters& parameters,
                      std::shared_ptr<const course::Course> course, bool verify,
                      const std::function<void(const StepRecord&)>& each);

}  // namespace tp100::app
