#pragma once
// `tp100d replay` of a recording: its inputs once more through the step, and whether every pose and
// command comes out as it was, bit for bit.

#include <functional>
#include <optional>
#include <string>

#include "app/replay.h"
#include "bridge/step.h"
#include "config/run_setup.h"
#include "record/recording.h"
#include "record/step_codec.h"

namespace tp100::app {

/// What the step was given, as views into `record`.
bridge::Inputs inputs_of(const StepRecord& record);

/// The files of a recorded run. Throws SetupError: they are not in it, or make no sense.
config::RunFiles recorded_files(const record::Recording& recording);

/// What came of a replay.
struct Replayed {
  std::uint64_t steps = 0;   ///< replayed
  std::uint64_t before = 0;  ///< of them before the recording, to get to where it began
  HostNs last_ns = 0;        ///< time of the last step that was looked at
  /// Steps that are missing before this one end the replay: what follows cannot be known.
  std::optional<std::uint64_t> gap_before;
  std::optional<std::uint64_t> differs_at;  ///< number of the first step that came out otherwise
  record::StepDifference difference{};
};

/// Feeds the recorded inputs to a step with these parameters and course. `each` gets the recorded
/// inputs with the results of the replay. `verify`: compares them and stops at the first
/// difference.
Replayed replay_steps(const record::Recording& recording, const bridge::Parameters& parameters,
                      std::shared_ptr<const course::Course> course, bool verify,
                      const std::function<void(const StepRecord&)>& each);

/// The command for a recording. 0: every result was as recorded (or other parameters were asked
/// for); 1: not, or steps are missing, and nothing is written. Throws SetupError. The poses are
/// those of `options.model`, else those that steered: a row for each step that got a sample.
int run_replay_recording(const ReplayOptions& options);

}  // namespace tp100::app
