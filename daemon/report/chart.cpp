#include "report/chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/statistics.h"
#include "report/html_page.h"
#include "text/format.h"

namespace tp100::report {
namespace {

using text::format;

constexpr double kLeft = 58, kRight = 12, kTop = 30, kBottom = 44;
constexpr double kLegendRow = 17, kLegendKey = 28, kLegendGap = 14, kLetter = 6.6;
constexpr double kBoxRow = 24, kBoxHalf = 7;
constexpr std::size_t kMaxPointsOfSeries = 1500;
constexpr int kMaxTicks = 7;
constexpr std::size_t kMaxLabel = 22;

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
    // The printed digits cannot show a range below a millionth of the values.
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

/// The plot's rectangle and the scales of its axes.
class PlotArea {
 public:
  PlotArea(double left, double top, double width, double height, Range x, Range y)
      : left_(left), top_(top), width_(width), height_(height), x_(x), y_(y) {}

  double x(double value) const { return left_ + (value - x_.low) / (x_.high - x_.low) * width_; }
  double y(double value) const { return top_ + (y_.high - value) / (y_.high - y_.low) * height_; }

  std::string box() const {
    return format("<rect x='%.0f' y='%.0f' width='%.0f' height='%.0f' fill='none' stroke='#999'/>",
                  left_, top_, width_, height_);
  }
  std::string x_axis() const {
    std::string out;
    for (const double v : ticks(x_))
      out += format(
          "<path d='M%.1f %.1fv%.1f' stroke='#e4e4e4'/><text x='%.1f' y='%.1f' "
          "text-anchor='middle'>%g</text>",
          x(v), top_, height_, x(v), top_ + height_ + 15, v);
    return out;
  }
  std::string y_axis() const {
    std::string out;
    for (const double v : ticks(y_))
      out += format(
          "<path d='M%.1f %.1fh%.1f' stroke='#e4e4e4'/><text x='%.1f' y='%.1f' "
          "text-anchor='end'>%g</text>",
          left_, y(v), width_, left_ - 5, y(v) + 4, v);
    return out;
  }
  double middle_x() const { return left_ + width_ / 2; }
  double middle_y() const { return top_ + height_ / 2; }

 private:
  double left_, top_, width_, height_;
  Range x_, y_;
};

PlotArea plot_area_of(const Chart& chart, double top) {
  const double width = chart.width_px - kLeft - kRight;
  const double height = chart.height_px - kTop - kBottom;
  Range x, y;
  for (const ChartSeries& series : chart.series) {
    for (const auto& [at, value] : series.points) {
      x.add(at);
      y.add(value);
    }
  }
  x.widen();
  y.widen();
  if (chart.equal_scale) {
    const double scale = std::max((x.high - x.low) / width, (y.high - y.low) / height);
    x.grow_to(scale * width);
    y.grow_to(scale * height);
  }
  return {kLeft, top, width, height, x, y};
}

/// Colour, width and dashes of a series.
std::string stroke(const ChartSeries& series) {
  return format("stroke='%s' stroke-width='%s'%s", series.colour.c_str(),
                series.broad ? "5' stroke-opacity='.45" : "1.6",
                series.dashed ? " stroke-dasharray='5 4'" : "");
}

std::string line(const PlotArea& area, const ChartSeries& series) {
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
    path += format("%c%.1f %.1f", pen_down ? 'L' : 'M', area.x(x), area.y(y));
    pen_down = true;
  }
  return "<path fill='none' " + stroke(series) + " d='" + path + "'/>";
}

std::string dot(double x, double y, double radius, const std::string& colour) {
  return format("<circle cx='%.1f' cy='%.1f' r='%g' fill='%s'/>", x, y, radius, colour.c_str());
}

std::string dots(const PlotArea& area, const ChartSeries& series) {
  std::string out;
  for (const auto& [x, y] : series.points)
    if (std::isfinite(x) && std::isfinite(y)) out += dot(area.x(x), area.y(y), 3, series.colour);
  return out;
}

/// Names of the series between title and plot; `height` is increased by its rows.
std::string legend(const Chart& chart, double& height) {
  std::string out;
  double x = kLeft, y = kTop - kLegendRow + 4;
  for (const ChartSeries& series : chart.series) {
    if (series.name.empty()) continue;
    const double width = kLegendKey + kLetter * static_cast<double>(series.name.size());
    if (out.empty() || x + width > chart.width_px) {
      x = kLeft;
      y += kLegendRow;
      height += kLegendRow;
    }
    out += series.marks
               ? dot(x + 10, y - 4, 3, series.colour)
               : format("<path d='M%.0f %.0fh20' fill='none' ", x, y - 4) + stroke(series) + "/>";
    out += format("<text x='%.0f' y='%.0f'>", x + 24, y) + escaped(series.name) + "</text>";
    x += width + kLegendGap;
  }
  return out;
}

std::string opening(int width_px, double height_px, const std::string& title) {
  return format(
             "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %d %.0f' width='%d' "
             "height='%.0f' font-family='sans-serif' font-size='12' role='img' aria-label='",
             width_px, height_px, width_px, height_px) +
         escaped(title) + "'><rect width='100%' height='100%' fill='white'/>" +
         format("<text x='%.0f' y='18' text-anchor='middle' font-size='14'>", width_px / 2.0) +
         escaped(title) + "</text>";
}

std::string shortened(const std::string& label) {
  return label.size() <= kMaxLabel ? label : label.substr(0, kMaxLabel - 3) + "...";
}

std::string box(const PlotArea& area, double y, std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return {};
  const auto at = [&](double share) { return percentile(values, share); };
  const double low = at(0.05), high = at(0.95);
  std::string out =
      format("<path fill='none' stroke='%s' d='M%.1f %.1fv%.0fm0 %.0fH%.1fm0 %.0fv%.0f'/>",
             kValueColour, area.x(low), y - 4, 8.0, -4.0, area.x(high), -4.0, 8.0);
  const double left = area.x(at(0.25)), right = area.x(at(0.75)), middle = area.x(at(0.5));
  out += format(
      "<rect x='%.1f' y='%.1f' width='%.1f' height='%.0f' fill='white' stroke='%s'/>"
      "<path stroke='%s' stroke-width='3' d='M%.1f %.1fv%.0f'/>",
      left, y - kBoxHalf, right - left, 2 * kBoxHalf, kValueColour, kValueColour, middle,
      y - kBoxHalf, 2 * kBoxHalf);
  std::vector<double> beyond = values;
  std::erase_if(beyond, [&](double value) { return value >= low && value <= high; });
  std::sort(beyond.begin(), beyond.end());
  // Of thousands of values only as many as the image can show.
  const std::size_t every = beyond.size() / 100 + 1;
  for (std::size_t i = 0; i < beyond.size(); ++i)
    if (i % every == 0 || i + 1 == beyond.size()) out += dot(area.x(beyond[i]), y, 2, kValueColour);
  return out;
}

}  // namespace

std::string svg(const Chart& chart) {
  double legend_height = 0.0;
  const std::string names = legend(chart, legend_height);
  const double height_px = chart.height_px + legend_height;
  const PlotArea area = plot_area_of(chart, kTop + legend_height);
  std::string out =
      opening(chart.width_px, height_px, chart.title) + area.box() + area.x_axis() + area.y_axis();
  for (const ChartSeries& series : chart.series)
    out += series.marks ? dots(area, series) : line(area, series);
  out += names +
         format("<text x='%.0f' y='%.0f' text-anchor='middle'>", area.middle_x(), height_px - 10) +
         escaped(chart.x_label) + "</text>";
  out += format("<text transform='translate(14 %.0f) rotate(-90)' text-anchor='middle'>",
                area.middle_y()) +
         escaped(chart.y_label) + "</text></svg>\n";
  return out;
}

std::string box_plot(const BoxChart& chart) {
  Range x;
  std::size_t longest = 0;
  std::vector<std::string> labels;
  for (const Box& row : chart.boxes) {
    for (const double value : row.values) x.add(value);
    labels.push_back(shortened(row.label) + format(" (%zu)", row.values.size()));
    longest = std::max(longest, labels.back().size());
  }
  x.widen();
  const double left = 12 + kLetter * static_cast<double>(longest);
  const double height = kBoxRow * static_cast<double>(chart.boxes.size());
  const double height_px = kTop + height + kBottom;
  const PlotArea area(left, kTop, chart.width_px - left - kRight, height, x, {0.0, 1.0});
  std::string out = opening(chart.width_px, height_px, chart.title) + area.box() + area.x_axis();
  for (std::size_t i = 0; i < chart.boxes.size(); ++i) {
    const double y = kTop + kBoxRow * (static_cast<double>(i) + 0.5);
    out += format("<text x='%.0f' y='%.1f' text-anchor='end'>", left - 6, y + 4) +
           escaped(labels[i]) + "</text>" + box(area, y, chart.boxes[i].values);
  }
  return out +
         format("<text x='%.0f' y='%.0f' text-anchor='middle'>", area.middle_x(), height_px - 10) +
         escaped(chart.x_label) + "</text></svg>\n";
}

}  // namespace tp100::report
