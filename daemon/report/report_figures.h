#pragma once
// The figures of recorded runs as SVG, for one run or several overlaid.

#include <string>
#include <vector>

#include "report/recorded_run.h"

namespace tp100::report {

// One colour per pose, in every figure.
inline constexpr const char* kPathColour = "#8a8a8a";
inline constexpr const char* kTruthColour = "#2e8b3d";
inline constexpr const char* kModelColour = "#c0392b";
inline constexpr const char* kOdometryColour = "#1f5fbf";
inline constexpr const char* kFusedColour = "#8e44ad";

struct Figure {
  std::string name;  ///< file name without .svg
  std::string svg;
  std::string caption;
};

/// Path, yaw, errors of the estimates, tracking, slip, jitter; climb angle if the course has
/// obstacles. Figures that need the truth are omitted if it is not known.
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
