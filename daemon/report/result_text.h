#pragma once
// The figures of a run as JSON and as a table. Errors of the model, of the estimates and of the
// tracking are relative to the truth and exist only where it is known; of a recorded run, the
// controller's own estimates are told apart from them.

#include <optional>
#include <string>

#include "report/metrics.h"
#include "report/recorded_run.h"

namespace tp100::report {

/// The result as one JSON object on one line, without line break. Keys in fixed order; doubles are
/// the shortest text that reads back the same, so that equal runs print equal text. `cause` appears
/// only in a run that was not completed, `fused` only in one with an overhead camera; the recovery
/// from a disturbance is null if there was none.
std::string result_json(const RunResult& run, const RunFigures& figures);

/// The result as text: several lines, at most 100 columns, with notes on what they mean.
std::string result_table(const RunResult& run, const RunFigures& figures);

/// Nothing if no run began, or if the truth or the course is not known.
std::optional<RunFigures> judged(const RecordedRun& run);

/// metrics.json of a recorded run, one JSON object with line breaks: what result_json() has besides
/// the speed of the machine (null where the truth is not known), and `estimated`, `differences`
/// (both null if no run began), `timing`, `recording`, `versions`.
std::string metrics_json(const RecordedRun& run, const std::optional<RunFigures>& figures);

/// Largest and last distance between two estimates. [m]
struct Difference {
  double max_m = 0.0, final_m = 0.0;
};
Difference model_from_odometry(const RecordedRun& run);

}  // namespace tp100::report
