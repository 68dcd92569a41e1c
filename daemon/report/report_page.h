#pragma once
// Reports of recorded runs as offline HTML pages, with a 3-D view of a run in them.

#include <optional>
#include <string>
#include <vector>

#include "report/metrics.h"
#include "report/recorded_run.h"
#include "report/report_figures.h"

namespace tp100::report {

/// One run: figures of merit, charts, replay, link, events, settings, versions.
std::string report_page(const RecordedRun& run, const std::optional<RunFigures>& judged,
                        const std::vector<Figure>& figures);

/// Several runs, side by side; `judged` has an entry for each.
std::string compare_page(const std::vector<ComparedRun>& runs,
                         const std::vector<std::optional<RunFigures>>& judged,
                         const std::vector<Figure>& figures);

}  // namespace tp100::report
