#pragma once
// The metrics of a recorded run: metrics.json and tables. Errors of the model, of the estimates and
// of the tracking are relative to the truth and exist only where it is known; the controller's own
// estimates are separate.

#include <optional>
#include <string>
#include <vector>

#include "report/metrics.h"
#include "report/recorded_run.h"

namespace tp100::report {

/// Nothing if no run began, or if the truth or the course is not known.
std::optional<RunFigures> judged(const RecordedRun& run);

/// One JSON object with line breaks: the fields that `tp100-sim course --json` prints (`model`,
/// `odometry`, `fused`, `tracking`, `slope`: null where the truth is not known), and `estimated`,
/// `differences` (both null if no run began), `timing`, `recording`, `versions`.
std::string metrics_json(const RecordedRun& run, const std::optional<RunFigures>& figures);

/// Largest and last distance between two estimates. [m]
struct Difference {
  double max_m = 0.0, final_m = 0.0;
};
Difference model_from_odometry(const RecordedRun& run);

/// Counters of the link by name, in their order.
std::vector<std::pair<std::string, std::uint64_t>> counters_of(const LinkCounters& link);

}  // namespace tp100::report
