#pragma once
// Charts as SVG: one string, no script, no external references; for pages and papers.

#include <string>
#include <utility>
#include <vector>

#include "report/colours.h"

namespace tp100::report {

struct ChartSeries {
  std::string name = {};    ///< in the legend; empty: none
  std::string colour = {};  ///< SVG syntax; of kColours, the page adapts it to light and dark
  std::vector<std::pair<double, double>> points = {};
  bool dashed = false;
  bool marks = false;  ///< a dot at every point, no line
  bool broad = false;  ///< drawn as a broad band, visible under a line
};

struct Chart {
  std::string title = {}, x_label = {}, y_label = {};
  std::vector<ChartSeries> series = {};
  bool equal_scale = false;             ///< a map: one metre has the same length in both directions
  int width_px = 460, height_px = 300;  ///< without the legend, which is above
};

/// Draws the chart; points that are not finite interrupt their line. Long series are thinned to
/// what the image can show.
std::string svg(const Chart& chart);

/// One row of a box plot.
struct Box {
  std::string label = {};
  std::vector<double> values = {};  ///< only the finite ones are drawn; the label counts all
};

/// Box plots below each other: box from the first to the third quartile with the median in it,
/// whiskers from 5 to 95 %, a dot for every value beyond them.
struct BoxChart {
  std::string title = {}, x_label = {};
  std::vector<Box> boxes = {};
  int width_px = 460;
};
std::string box_plot(const BoxChart& chart);

}  // namespace tp100::report
