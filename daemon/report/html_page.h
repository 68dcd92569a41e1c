#pragma once
// One offline HTML page: headings, paragraphs, tables and figures, no external references. And line
// charts as SVG for it.

#include <concepts>
#include <string>
#include <utility>
#include <vector>

namespace tp100::report {

/// `text` with HTML's and SVG's five special characters escaped.
std::string escaped(const std::string& text);

/// One cell of a table.
struct Cell {
  /// From anything that makes a string.
  template <class Text>
  requires std::constructible_from<std::string, Text> Cell(Text&& content, bool is_missed = false)
      : text(std::forward<Text>(content)), missed(is_missed) {}

  std::string text;
  bool missed = false;  ///< limit broken: shown in red
};
/// The first row is the head.
using Rows = std::vector<std::vector<Cell>>;

class HtmlPage {
 public:
  explicit HtmlPage(std::string title) : title_(std::move(title)) {}

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  void table(const Rows& rows, const std::string& caption);
  /// Figures side by side; each is an SVG.
  void figures(const std::vector<std::string>& svgs, const std::string& caption);

  /// A verbatim text, collapsed under its name.
  void folded(const std::string& name, const std::string& text);
  /// Inserts HTML that was made elsewhere.
  void insert(const std::string& html) { body_ += html; }

  std::string text() const;

 private:
  std::string title_;
  std::string body_;
};

/// Line charts as SVG: one string, no script, no external references; for pages and papers.
struct ChartSeries {
  std::string name = {};    ///< in the legend; empty: none
  std::string colour = {};  ///< SVG syntax, e.g. "#c0392b"
  std::vector<std::pair<double, double>> points = {};
  bool dashed = false;
  bool marks = false;  ///< a dot at every point, no line
};

struct Chart {
  std::string title = {}, x_label = {}, y_label = {};
  std::vector<ChartSeries> series = {};
  bool equal_scale = false;  ///< a map: one metre has the same length in both directions
  int width_px = 460, height_px = 300;
};

/// Draws the chart; points that are not finite interrupt their line. Long series are thinned to
/// what the image can show.
std::string svg(const Chart& chart);

}  // namespace tp100::report
