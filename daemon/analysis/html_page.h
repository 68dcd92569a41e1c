#pragma once
// One offline HTML page: headings, paragraphs, tables and figures, no outside reference.

#include <string>
#include <vector>

namespace tp100::analysis {

/// Text with the five characters that HTML and SVG give a meaning.
std::string escaped(const std::string& text);

class HtmlPage {
 public:
  explicit HtmlPage(std::string title) : title_(std::move(title)) {}

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  /// First row is the head. A cell that begins with '!' did not hold its limit and is marked.
  void table(const std::vector<std::vector<std::string>>& rows, const std::string& caption);
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

}  // namespace tp100::analysis
