#pragma once
// One offline HTML page for screens of every width, light and dark, and for paper: verdict, facts,
// headings with a table of contents, paragraphs, tables and figures; no external references.

#include <concepts>
#include <string>
#include <utility>
#include <vector>

namespace tp100::report {

/// `text` with HTML's and SVG's five special characters escaped.
std::string escaped(const std::string& text);

/// How a cell is shown. Its text or its column expresses the same.
enum class Mark { kNone, kMissed, kBetter };

/// One cell of a table.
struct Cell {
  /// From anything that a string can be made from.
  template <class Text>
  requires std::constructible_from<std::string, Text> Cell(Text&& content, bool is_missed = false)
      : Cell(std::forward<Text>(content), is_missed ? Mark::kMissed : Mark::kNone) {}
  template <class Text>
  requires std::constructible_from<std::string, Text> Cell(Text&& content, Mark shown_as)
      : text(std::forward<Text>(content)), mark(shown_as) {}

  std::string text;
  Mark mark = Mark::kNone;  ///< kMissed: limit broken, in red; kBetter: in green
};
/// The first row is the head.
using Rows = std::vector<std::vector<Cell>>;

class HtmlPage {
 public:
  explicit HtmlPage(std::string title) : title_(std::move(title)) {}

  /// The verdict of the page, one sentence. Call it first.
  void verdict(bool good, const std::string& text);
  /// Names and values, below each other.
  void facts(const std::vector<std::pair<std::string, Cell>>& list);
  /// A heading, which is also an entry of the table of contents.
  void heading(const std::string& text);
  void paragraph(const std::string& text);
  /// Columns of numbers are aligned to the right. A table wider than the screen scrolls in itself.
  void table(const Rows& rows, const std::string& caption);
  /// Figures side by side under one caption; each is an SVG.
  void figures(const std::vector<std::string>& svgs, const std::string& caption);
  /// One figure; those that follow each other stand side by side where there is room.
  void figure(const std::string& svg, const std::string& caption) { figures({svg}, caption); }

  /// A verbatim text, collapsed under its name.
  void folded(const std::string& name, const std::string& text);
  /// Inserts HTML that was made elsewhere.
  void insert(const std::string& html) { body_ += html; }

  std::string text() const;

 private:
  std::string title_;
  std::string body_;
  std::vector<std::string> headings_;
};

/// Layout of the page (html_page.css); colours as custom properties.
extern const char* const kPageStyle;

}  // namespace tp100::report
