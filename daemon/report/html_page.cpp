#include "report/html_page.h"

namespace tp100::report {
namespace {

constexpr const char* kStyle =
    "body{font:15px/1.5 system-ui,sans-serif;max-width:1040px;margin:2em auto;padding:0 1em;"
    "color:#222}table{border-collapse:collapse;margin:1em 0;font-variant-numeric:tabular-nums}"
    "th,td{padding:.2em .7em;border-bottom:1px solid #ddd;text-align:right}"
    "th:first-child,td:first-child{text-align:left}caption,figcaption{text-align:left;"
    "color:#555;padding:.3em 0}th{border-bottom:2px solid #888}.missed{color:#b00020;"
    "font-weight:bold}figure{margin:1em 0}figure svg{max-width:100%;height:auto}";

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

void HtmlPage::heading(const std::string& text) { body_ += "<h2>" + escaped(text) + "</h2>\n"; }
void HtmlPage::paragraph(const std::string& text) { body_ += "<p>" + escaped(text) + "</p>\n"; }

void HtmlPage::table(const Rows& rows, const std::string& caption) {
  body_ += "<table><caption>" + escaped(caption) + "</caption>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string tag = i == 0 ? "th" : "td";
    body_ += "<tr>";
    for (const Cell& cell : rows[i])
      body_ += "<" + tag + (cell.missed ? " class='missed'>" : ">") + escaped(cell.text) + "</" +
               tag + ">";
    body_ += "</tr>\n";
  }
  body_ += "</table>\n";
}

void HtmlPage::figures(const std::vector<std::string>& svgs, const std::string& caption) {
  body_ += "<figure>";
  for (const std::string& figure : svgs) body_ += figure;
  body_ += "<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

void HtmlPage::folded(const std::string& name, const std::string& text) {
  body_ += "<details><summary>" + escaped(name) + "</summary><pre>" + escaped(text) +
           "</pre></details>\n";
}

std::string HtmlPage::text() const {
  return "<!doctype html>\n<html lang='en'><head><meta charset='utf-8'><title>" + escaped(title_) +
         "</title><style>" + kStyle + "</style></head><body>\n<h1>" + escaped(title_) + "</h1>\n" +
         body_ + "</body></html>\n";
}

}  // namespace tp100::report
