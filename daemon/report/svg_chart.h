#pragma once
// Line charts as SVG: one string, no script, no outside reference; for pages and papers.

#include <string>
#include <utility>
#include <vector>

namespace tp100::report {

struct ChartSeries {
  std::string name = {};    ///< in the legend; empty: none
  std::string colour = {};  ///< as SVG has it, e.g. "#c0392b"
  std::vector<std::pair<double, double>> points = {};
  bool dashed = false;
  bool marks = false;  ///< a dot at every point, no line
};

struct Chart {
  std::string title = {}, x_label = {}, y_label = {};
  std::vector<ChartSeries> series = {};
  bool equal_scale = false;  ///< a map: one metre is as long in both directions
  int width_px = 460, height_px = 300;
};

/// The chart; points that are not finite interrupt their line. Long series are thinned to what the
/// picture can show.
std::string svg(const Chart& chart);

}  // namespace tp100::report
