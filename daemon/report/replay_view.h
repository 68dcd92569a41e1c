#pragma once
// The replay in a report.

#include <string>

#include "report/recorded_run.h"

namespace tp100::report {

/// A 3-D view of a run, as a part of an HTML page: canvas, controls, script and data; no external
/// references. Shows the robot at the steering pose in the course's world, and its outline at the
/// true pose, if known. At most two thousand instants. Colours are the page's custom properties.
std::string replay_view(const RecordedRun& run);

/// The function `tp100Replay` of the view (replay_view.js).
extern const char* const kReplayScript;

}  // namespace tp100::report
