#include "report/html_page.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "text/format.h"

namespace tp100::report {
namespace {

constexpr const char* kStyle =
    "body{font:15px/1.5 system-ui,sans-serif;max-width:1040px;margin:2em auto;padding:0 1em;"
    "color:#222}table{border-collapse:collapse;margin:1em 0;font-variant-numeric:tabular-nums}"
    "th,td{padding:.2em .7em;border-bottom:1px solid #ddd;text-align:right}"
    "th:first-child,td:first-child{text-align:left}caption,figcaption{text-align:left;"
    "color:#555;padding:.3em 0}th{border-bottom:2px solid #888}.missed{color:#b00020;"
    "font-weight:bold}figure{margin:1em 0}figure svg{max-width:100%;height:auto}";

using text::format;

constexpr double kLeft = 58, kRight = 12, kTop = 30, kBottom = 44;
constexpr std::size_t kMaxPointsOfSeries = 1500;
constexpr int kMaxTicks = 7;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void widen() {
    if (low > high) low = 0.0, high = 1.0;
    // A range below a millionth of the values exceeds their printed digits.
    const double least = std::max(std::abs(low), std::abs(high)) * 1e-6;
    const double margin =
        high - low > least ? (high - low) * 0.05 : std::max(std::abs(low) * 0.1, 1e-3);
    low -= margin;
    high += margin;
  }
  void grow_to(double span) {
    const double more = std::max(0.0, span - (high - low)) / 2.0;
    low -= more;
    high += more;
  }
};

double tick_step(double span) {
  const double rough = span / kMaxTicks;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough) return factor * power;
  return 10.0 * power;
}

/// Round values within a range.
std::vector<double> ticks(const Range& range) {
  const double step = tick_step(range.high - range.low);
  const double first = std::ceil(range.low / step);
  const auto count =
      static_cast<std::size_t>(std::max(0.0, std::floor(range.high / step) - first + 1.0));
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = (first + static_cast<double>(i)) * step;
  return values;
}

class Frame {
 public:
  explicit Frame(const Chart& chart)
      : width_(chart.width_px - kLeft - kRight), height_(chart.height_px - kTop - kBottom) {
    for (const ChartSeries& series : chart.series) {
      for (const auto& [x, y] : series.points) {
        x_.add(x);
        y_.add(y);
      }
    }
    x_.widen();
    y_.widen();
    if (!chart.equal_scale) return;
    const double scale = std::max((x_.high - x_.low) / width_, (y_.high - y_.low) / height_);
    x_.grow_to(scale * width_);
    y_.grow_to(scale * height_);
  }
  double x(double value) const { return kLeft + (value - x_.low) / (x_.high - x_.low) * width_; }
  double y(double value) const { return kTop + (y_.high - value) / (y_.high - y_.low) * height_; }

  std::string axes() const {
    std::string out =
        format("<rect x='%.0f' y='%.0f' width='%.0f' height='%.0f' fill='none' stroke='#999'/>",
               kLeft, kTop, width_, height_);
    for (const double v : ticks(x_))
      out += format(
          "<path d='M%.1f %.1fv%.1f' stroke='#e4e4e4'/><text x='%.1f' y='%.1f' "
          "text-anchor='middle'>%g</text>",
          x(v), kTop, height_, x(v), kTop + height_ + 15, v);
    for (const double v : ticks(y_))
      out += format(
          "<path d='M%.1f %.1fh%.1f' stroke='#e4e4e4'/><text x='%.1f' y='%.1f' "
          "text-anchor='end'>%g</text>",
          kLeft, y(v), width_, kLeft - 5, y(v) + 4, v);
    return out;
  }
  double middle_x() const { return kLeft + width_ / 2; }
  double middle_y() const { return kTop + height_ / 2; }

 private:
  double width_, height_;
  Range x_, y_;
};

std::string line(const Frame& frame, const ChartSeries& series) {
  const std::size_t every = series.points.size() / kMaxPointsOfSeries + 1;
  std::string path;
  bool pen_down = false;
  for (std::size_t i = 0; i < series.points.size(); ++i) {
    const bool last = i + 1 == series.points.size();
    if (i % every != 0 && !last) continue;
    const auto [x, y] = series.points[i];
    if (!std::isfinite(x) || !std::isfinite(y)) {
      pen_down = false;
      continue;
    }
    path += format("%c%.1f %.1f", pen_down ? 'L' : 'M', frame.x(x), frame.y(y));
    pen_down = true;
  }
  return format("<path fill='none' stroke='%s' stroke-width='1.6'%s d='", series.colour.c_str(),
                series.dashed ? " stroke-dasharray='5 4'" : "") +
         path + "'/>";
}

std::string dots(const Frame& frame, const ChartSeries& series) {
  std::string out;
  for (const auto& [x, y] : series.points)
    if (std::isfinite(x) && std::isfinite(y))
      out += format("<circle cx='%.1f' cy='%.1f' r='3' fill='%s'/>", frame.x(x), frame.y(y),
                    series.colour.c_str());
  return out;
}

std::string legend(const Chart& chart) {
  std::string out;
  double y = kTop + 14;
  for (const ChartSeries& series : chart.series) {
    if (series.name.empty()) continue;
    out +=
        format("<path d='M%.0f %.0fh16' stroke='%s' stroke-width='2'%s/><text x='%.0f' y='%.0f'>",
               kLeft + 8, y - 4, series.colour.c_str(),
               series.dashed ? " stroke-dasharray='5 4'" : "", kLeft + 28, y);
    out += escaped(series.name) + "</text>";
    y += 15;
  }
  return out;
}

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

std::string svg(const Chart& chart) {
  const Frame frame(chart);
  std::string out = format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %d %d' width='%d' height='%d' "
      "font-family='sans-serif' font-size='11'>",
      chart.width_px, chart.height_px, chart.width_px, chart.height_px);
  out += "<rect width='100%' height='100%' fill='white'/>" + frame.axes();
  for (const ChartSeries& series : chart.series)
    out += series.marks ? dots(frame, series) : line(frame, series);
  out += legend(chart);
  out += format("<text x='%.0f' y='18' text-anchor='middle' font-size='13'>", frame.middle_x()) +
         escaped(chart.title) + "</text>";
  out += format("<text x='%.0f' y='%d' text-anchor='middle'>", frame.middle_x(),
                chart.height_px - 10) +
         escaped(chart.x_label) + "</text>";
  out += format("<text transform='translate(14 %.0f) rotate(-90)' text-anchor='middle'>",
                frame.middle_y()) +
         escaped(chart.y_label) + "</text></svg>\n";
  return out;
}

}  // namespace tp100::report
