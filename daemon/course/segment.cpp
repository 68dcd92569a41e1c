#include "course/segment.h"

#include <cmath>

#include "core/arithmetic.h"
#include "text/format.h"
#include "text/toml_document.h"

namespace tp100::course {
namespace {

constexpr text::Range kLength{kSmallestLengthM, 100.0};
constexpr text::Range kRadius{0.01, 100.0};
constexpr text::Range kTurn{-3600.0, 3600.0};

double turn_rad(text::TomlTable& table) {
  const double angle_deg = table.required_number("angle_deg", kTurn);
  if (std::abs(angle_deg) < kSmallestTurnDeg)
    table.fail("angle_deg", "'angle_deg' is " + text::number_text(angle_deg) +
                                ", smallest turn is " + text::number_text(kSmallestTurnDeg) +
                                " deg to either side");
  return angle_deg * kRadPerDeg;
}

struct Values {
  std::string operator()(const Line& line) const {
    return text::format("length_m = %.17g\n", line.length_m);
  }
  std::string operator()(const Arc& arc) const {
    return text::format("radius_m = %.17g\n", arc.radius_m) + (*this)(Pivot{arc.angle_rad});
  }
  std::string operator()(const Pivot& pivot) const {
    return text::format("angle_deg = %.17g\n", pivot.angle_rad * kDegPerRad);
  }
};

struct Mirror {
  void operator()(Line& /*line*/) const {}
  void operator()(Arc& arc) const { arc.angle_rad = -arc.angle_rad; }
  void operator()(Pivot& pivot) const { pivot.angle_rad = -pivot.angle_rad; }
};

}  // namespace

Segment read_segment(text::TomlTable table) {
  const std::string type = table.required_choice("type", {"line", "arc", "pivot"});
  if (type == "line") return Line{table.required_number("length_m", kLength)};
  if (type == "pivot") return Pivot{turn_rad(table)};
  const double radius_m = table.required_number("radius_m", kRadius);
  return Arc{radius_m, turn_rad(table)};
}

std::string segment_text(const Segment& segment) {
  return std::string("\n[[segment]]\ntype = \"") + kSegmentKindNames.at(segment.index()).name +
         "\"\n" + std::visit(Values{}, segment);
}

double length_of(const Segment& segment) {
  if (const auto* line = std::get_if<Line>(&segment)) return line->length_m;
  const auto* arc = std::get_if<Arc>(&segment);
  return arc == nullptr ? 0.0 : arc->radius_m * std::abs(arc->angle_rad);
}

void mirror(Segment& segment) { std::visit(Mirror{}, segment); }

}  // namespace tp100::course
