#pragma once
// The figures of recorded runs as SVG, for one run or several overlaid.

#include <cstddef>
#include <string>
#include <vector>

#include "report/colours.h"
#include "report/recorded_run.h"

namespace tp100::report {

struct Figure {
  std::string name;  ///< file name without .svg
  std::string svg;
  std::string caption;
};

/// Path, yaw, errors of the estimates, tracking, slip, jitter; climb angle if the course has
/// obstacles. Without the truth, figures that need it are omitted.
std::vector<Figure> figures_of(const RecordedRun& run);

/// A run in a comparison: its name in legends, and its points thinned to what a figure can show.
struct ComparedRun {
  std::string name;
  RecordedRun run;
};

/// The same figures with all runs overlaid.
std::vector<Figure> figures_of(const std::vector<ComparedRun>& runs);

/// Thins the run to at most two thousand points.
void thin_for_figures(RecordedRun& run);

}  // namespace tp100::report
