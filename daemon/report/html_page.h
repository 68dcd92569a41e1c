#pragma once
// One offline HTML page: headings, paragraphs, tables and figures, no outside reference.

#include <concepts>
#include <string>
#include <utility>
#include <vector>

namespace tp100::report {

/// Text with the five characters that HTML and SVG give a meaning.
std::string escaped(const std::string& text);

/// One cell of a table.
struct Cell {
  /// From anything that makes a string.
  template <class Text>
  requires std::constructible_from<std::string, Text> Cell(Text&& content, bool is_missed = false)
      : text(std::forward<Text>(content)), missed(is_missed) {}

  std::string text;
  bool missed = false;  ///< its limit was not held: shown in red
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

  /// A text as it is, folded away under its name.
  void folded(const std::string& name, const std::string& text);
  /// HTML as it is, for what is made elsewhere.
  void insert(const std::string& html) { body_ += html; }

  std::string text() const;

 private:
  std::string title_;
  std::string body_;
};

}  // namespace tp100::report
