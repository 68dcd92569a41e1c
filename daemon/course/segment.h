#pragma once
// The kinds of segments that a path consists of: their values, and what a course does with a
// segment without its place on the floor (course/path.h has the geometry).

#include <array>
#include <cstdint>
#include <string>
#include <variant>

#include "core/enum_names.h"

namespace tp100::text {
class TomlTable;
}

namespace tp100::course {

/// Smaller segments are invalid.
inline constexpr double kSmallestLengthM = 0.001, kSmallestTurnDeg = 0.1;

/// Straight segment. [m]
struct Line {
  double length_m;
};
/// Circular segment; a positive angle turns left.
struct Arc {
  double radius_m;
  double angle_rad;
};
/// Turn on the spot; a positive angle turns left.
struct Pivot {
  double angle_rad;
};
using Segment = std::variant<Line, Arc, Pivot>;

enum class SegmentKind : std::uint8_t { kLine, kArc, kPivot };
/// Names as in course files and messages.
inline constexpr std::array<EnumName<SegmentKind>, 3> kSegmentKindNames = {{
    {SegmentKind::kLine, "line"},
    {SegmentKind::kArc, "arc"},
    {SegmentKind::kPivot, "pivot"},
}};

/// Reads one [[segment]] of a course file. Throws UserError.
Segment read_segment(text::TomlTable table);
/// The same segment as a [[segment]]; its numbers read back unchanged.
std::string segment_text(const Segment& segment);

/// Along the path; a pivot has none. [m]
double length_of(const Segment& segment);
/// Left becomes right.
void mirror(Segment& segment);

}  // namespace tp100::course
