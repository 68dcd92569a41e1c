#include "report/html_page.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "report/colours.h"

namespace tp100::report {
namespace {

// Pages with fewer headings get no contents.
constexpr std::size_t kFewHeadings = 3;

struct Scheme {
  const char *selector, *end, *properties;
  const char* Colour::*colour;
};
// The dark one as the live page (daemon/web/page/theme.css); paper is light.
constexpr Scheme kSchemes[] = {
    {":root{color-scheme:light dark;", "}\n",
     "--panel:#f3f5f7;--line:#d3d9df;--text:#1b2127;--dim:#55606b;--good:#12733d;--bad:#b3201a;"
     "--link:#1c61bd;",
     &Colour::light},
    {"@media screen and (prefers-color-scheme:dark){:root{", "}}\n",
     "--panel:#0f151c;--line:#212c38;--text:#d7dee7;--dim:#8793a1;--good:#3ad07c;--bad:#ff6f4d;"
     "--link:#9cc7ff;",
     &Colour::dark}};

/// The colours of the page, and those of figures in their place.
std::string colours() {
  std::string out;
  for (const Scheme& scheme : kSchemes) {
    out += scheme.selector;
    for (const Colour& colour : kColours)
      out += std::string("--") + colour.name + ":" + colour.*scheme.colour + ";";
    out += std::string("--") + kGround.name + ":" + kGround.*scheme.colour + ";";
    out += std::string(scheme.properties) + scheme.end;
  }
  for (const Colour& colour : kColours)
    for (const char* property : {"stroke", "fill"})
      out += std::string("svg [") + property + "='" + colour.light + "']{" + property + ":var(--" +
             colour.name + ")}\n";
  return out;
}

/// A number, alone or with more words behind it, or a place holder.
bool numeric(const std::string& text) {
  if (text.empty() || text == "-" || text == "never") return true;
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return end != text.c_str() && (*end == '\0' || *end == ' ');
}

/// Columns, except the first, with anything but numbers below the head.
std::vector<bool> text_columns(const Rows& rows) {
  std::vector<bool> columns;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    columns.resize(std::max(columns.size(), rows[i].size()));
    for (std::size_t j = 1; j < rows[i].size(); ++j)
      if (!numeric(rows[i][j].text)) columns[j] = true;
  }
  return columns;
}

// A text of more characters gets the room of a paragraph.
constexpr std::size_t kLongText = 60;

std::string classes(const Cell& cell, bool is_text) {
  std::string names = cell.mark == Mark::kMissed   ? "missed"
                      : cell.mark == Mark::kBetter ? "better"
                                                   : "";
  if (is_text) names += names.empty() ? "t" : " t";
  if (is_text && cell.text.size() > kLongText) names += " long";
  return names.empty() ? "" : " class='" + names + "'";
}

std::string anchor(std::size_t heading) { return "part-" + std::to_string(heading + 1); }

}  // namespace

std::string escaped(const std::string& text) {
  constexpr std::string_view kSpecial = "&<>\"'";
  constexpr const char* kEscapes[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  std::string out;
  for (const char c : text) {
    const std::size_t at = kSpecial.find(c);
    if (at == kSpecial.npos)
      out += c;
    else
      out += kEscapes[at];
  }
  return out;
}

void HtmlPage::verdict(bool good, const std::string& text) {
  body_ +=
      std::string("<p class='verdict ") + (good ? "good" : "bad") + "'>" + escaped(text) + "</p>\n";
}

void HtmlPage::facts(const std::vector<std::pair<std::string, Cell>>& list) {
  body_ += "<dl>\n";
  for (const auto& [name, value] : list)
    body_ += "<dt>" + escaped(name) + "</dt><dd" + classes(value, false) + ">" +
             escaped(value.text) + "</dd>\n";
  body_ += "</dl>\n";
}

void HtmlPage::heading(const std::string& text) {
  body_ += "<h2 id='" + anchor(headings_.size()) + "'>" + escaped(text) + "</h2>\n";
  headings_.push_back(text);
}

void HtmlPage::paragraph(const std::string& text) { body_ += "<p>" + escaped(text) + "</p>\n"; }

void HtmlPage::table(const Rows& rows, const std::string& caption) {
  const std::vector<bool> texts = text_columns(rows);
  // A box that scrolls must be reachable by keyboard.
  body_ += "<div class='scroll' tabindex='0' role='group' aria-label='" + escaped(caption) +
           "'><table><caption>" + escaped(caption) + "</caption>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string tag = i == 0 ? "th" : "td";
    body_ += i == 0 ? "<thead><tr>" : "<tr>";
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      const Cell& cell = rows[i][j];
      const bool is_text = j < texts.size() && texts[j];
      // The empty corner above the names of the rows is no header cell.
      const std::string& as = cell.text.empty() ? "td" : tag;
      body_ += "<" + as + (as == "th" ? " scope='col'" : "") + classes(cell, is_text) + ">" +
               escaped(cell.text) + "</" + as + ">";
    }
    body_ += i == 0 ? "</tr></thead>\n" : "</tr>\n";
  }
  body_ += "</table></div>\n";
}

void HtmlPage::figures(const std::vector<std::string>& svgs, const std::string& caption) {
  const std::string text = "<figcaption>" + escaped(caption) + "</figcaption>";
  const bool several = svgs.size() > 1;
  // Above several figures, the caption is common to all of them.
  body_ += several ? "<figure class='wide'>" + text : "<figure>";
  for (const std::string& figure : svgs) body_ += figure;
  body_ += (several ? "" : text) + "</figure>\n";
}

void HtmlPage::folded(const std::string& name, const std::string& text) {
  body_ += "<details><summary>" + escaped(name) + "</summary><pre tabindex='0'>" + escaped(text) +
           "</pre></details>\n";
}

std::string HtmlPage::text() const {
  std::string contents;
  if (headings_.size() >= kFewHeadings) {
    contents = "<nav aria-label='Contents'>";
    for (std::size_t i = 0; i < headings_.size(); ++i)
      contents += "<a href='#" + anchor(i) + "'>" + escaped(headings_[i]) + "</a>";
    contents += "</nav>\n";
  }
  // Contents come after verdict and facts, before the first part.
  const std::size_t first = std::min(body_.find("<h2 "), body_.size());
  return "<!doctype html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
         "content='width=device-width,initial-scale=1'><title>" +
         escaped(title_) + "</title><style>\n" + colours() + kPageStyle +
         "</style></head><body><main>\n<h1>" + escaped(title_) + "</h1>\n" +
         body_.substr(0, first) + contents + body_.substr(first) +
         "</main>\n<script>addEventListener('beforeprint',()=>document.querySelectorAll('details')"
         ".forEach(d=>d.open=true))</script></body></html>\n";
}

}  // namespace tp100::report
