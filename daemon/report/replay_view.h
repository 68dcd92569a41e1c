#pragma once
// A run to look at in three dimensions, as a part of an HTML page: canvas, controls, script and
// data; no outside reference.

#include <string>

#include "report/recorded_run.h"

namespace tp100::report {

/// The part. The robot stands where the steering pose puts it in the course's world, its outline
/// where the truth is, if it is known. At most two thousand instants.
std::string replay_view(const RecordedRun& run);

/// The function `tp100Replay` (replay_view.js).
extern const char* const kReplayScript;

}  // namespace tp100::report
