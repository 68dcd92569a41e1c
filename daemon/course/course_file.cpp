#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/arithmetic.h"
#include "core/error.h"
#include "course/course.h"
#include "course/path.h"
#include "text/toml_document.h"

namespace tp100::course {
namespace {

constexpr std::size_t kMaxSegments = 1000;
constexpr std::size_t kMaxDisturbances = 100;
constexpr text::Range kPlace{-100.0, 100.0};
constexpr text::Range kAngle{-3600.0, 3600.0};

constexpr std::size_t kMaxPieces = 50;
constexpr std::size_t kMaxCorners = 100;
constexpr text::Range kHeading{-3600.0, 3600.0};
constexpr text::Range kHeight{0.001, 0.5};
constexpr text::Range kSize{0.01, 20.0};
constexpr text::Range kSlope{1.0, 60.0};

Place place_of(text::TomlTable& table) {
  const auto [x_m, y_m] = table.required_numbers({"x_m", "y_m"}, kPlace);
  return {x_m, y_m, table.number("heading_deg", 0.0, kHeading) * kRadPerDeg};
}

Ramp ramp_of(text::TomlTable table) {
  Ramp ramp{};
  ramp.place = place_of(table);
  ramp.height_m = table.required_number("height_m", kHeight);
  ramp.up_rad = table.required_number("up_deg", kSlope) * kRadPerDeg;
  ramp.top_m = table.required_number("top_m", {0.0, 20.0});
  ramp.down_rad = table.required_number("down_deg", kSlope) * kRadPerDeg;
  ramp.width_m = table.required_number("width_m", kSize);
  return ramp;
}

Block block_of(text::TomlTable table) {
  Block block{};
  block.place = place_of(table);
  block.height_m = table.required_number("height_m", kHeight);
  block.depth_m = table.required_number("depth_m", kSize);
  block.width_m = table.required_number("width_m", kSize);
  return block;
}

Surface surface_of(text::TomlTable table) {
  Surface surface{};
  surface.name = table.text("name", "");
  if (surface.name.empty()) table.fail("name", "a [[surface]] needs a 'name'");
  surface.place = place_of(table);
  surface.length_m = table.required_number("length_m", kSize);
  surface.width_m = table.required_number("width_m", kSize);
  surface.friction_factor = table.number("friction_factor", 1.0, {0.05, 3.0});
  surface.slip_offset = table.number("slip_offset", 0.0, {-0.3, 0.5});
  return surface;
}

template <class Pieces, class Piece>
void read(text::TomlTable& root, const char* name, Piece (*piece_of)(text::TomlTable),
          Pieces& pieces) {
  const std::vector<text::TomlTable> tables = root.tables(name);
  if (tables.size() > kMaxPieces) root.fail(name, std::string("more than 50 [[") + name + "]]");
  for (const text::TomlTable& table : tables) pieces.push_back(piece_of(table));
}

Terrain terrain_of(text::TomlTable& root) {
  Terrain terrain;
  read(root, to_string(Ramp::kClass), ramp_of, terrain.obstacles);
  read(root, to_string(Block::kClass), block_of, terrain.obstacles);
  read(root, "surface", surface_of, terrain.surfaces);
  return terrain;
}

Pose start_of(text::TomlTable table) {
  Pose start;
  start.x_m = table.number("x_m", 0.0, kPlace);
  start.y_m = table.number("y_m", 0.0, kPlace);
  start.yaw_rad = table.number("yaw_deg", 0.0, kAngle) * kRadPerDeg;
  return start;
}

Polygon polygon_of(text::TomlTable table) {
  Polygon polygon;
  for (const auto& [x_m, y_m] : table.pairs("corners_m", kPlace)) polygon.push_back({x_m, y_m});
  if (polygon.size() < 3) table.fail("corners_m", "'corners_m' needs at least three corners");
  if (polygon.size() > kMaxCorners) table.fail("corners_m", "more than 100 corners");
  if (crosses_itself(polygon)) table.fail("corners_m", "the edges of 'corners_m' cross or touch");
  return polygon;
}

/// A rectangle, or a polygon with its bounds.
Fence boundary_of(text::TomlTable table) {
  if (table.has("corners_m")) {
    Fence fence{kPlace.max, kPlace.min, kPlace.max, kPlace.min, polygon_of(table)};
    for (const Vertex& corner : fence.corners) {
      fence.min_x_m = std::min(fence.min_x_m, corner.x_m);
      fence.max_x_m = std::max(fence.max_x_m, corner.x_m);
      fence.min_y_m = std::min(fence.min_y_m, corner.y_m);
      fence.max_y_m = std::max(fence.max_y_m, corner.y_m);
    }
    return fence;
  }
  const auto [min_x_m, max_x_m, min_y_m, max_y_m] =
      table.required_numbers({"min_x_m", "max_x_m", "min_y_m", "max_y_m"}, kPlace);
  Fence fence{min_x_m, max_x_m, min_y_m, max_y_m};
  if (fence.min_x_m >= fence.max_x_m) table.fail("max_x_m", "'max_x_m' must exceed 'min_x_m'");
  if (fence.min_y_m >= fence.max_y_m) table.fail("max_y_m", "'max_y_m' must exceed 'min_y_m'");
  return fence;
}

Fence fence_of(text::TomlTable& root) {
  Fence fence = boundary_of(root.table("fence"));
  read(root, "keep_out", polygon_of, fence.keep_out);
  return fence;
}

Disturbance disturbance_of(text::TomlTable table) {
  Disturbance disturbance{};
  disturbance.at_m = table.required_number("at_m", {0.0, 1e5});
  disturbance.sideways_m = table.number("sideways_m", 0.0, {-0.3, 0.3});
  disturbance.yaw_rad = table.number("yaw_deg", 0.0, {-90.0, 90.0}) * kRadPerDeg;
  disturbance.duration_s = table.number("duration_s", 0.3, {0.05, 5.0});
  return disturbance;
}

/// Throws UserError if pieces that can be read, each for itself, do not fit together.
void require_sound(const text::TomlTable& root, const std::vector<text::TomlTable>& disturbances,
                   const Course& course) {
  const Path path(course);
  double after_m = 0.0;
  for (std::size_t i = 0; i < disturbances.size(); ++i) {
    const double at_m = course.disturbances[i].at_m;
    if (at_m > path.length_m())
      disturbances[i].fail("at_m", "'at_m' is " + text::number_text(at_m) +
                                       ", but the path is only " +
                                       text::number_text(path.length_m()) + " m long");
    if (at_m < after_m)
      disturbances[i].fail("at_m", "disturbances must be listed in the order of 'at_m'");
    after_m = at_m;
  }
  root.finish();
  if (const auto outside = first_point_outside(path, course.fence))
    root.fail("fence",
              text::format("the path leaves the fence at (%.3f, %.3f) m, %.3f m from its start",
                           outside->x_m, outside->y_m, outside->s_m));
}

}  // namespace

Draft parse_draft(const std::string& text, const std::string& file) {
  const text::TomlDocument document(text, file);
  text::TomlTable root = document.root();
  Draft draft;
  Course& course = draft.course;
  course.name = std::filesystem::path(file).stem().string();
  course.description = root.text("description", "");
  course.speed_mps = root.number("speed_mps", course.speed_mps, {0.01, 0.3});
  course.identifies = root.boolean("identifies", course.identifies);
  course.start = start_of(root.table("start"));

  const std::vector<text::TomlTable> segments = root.tables("segment");
  const std::vector<text::TomlTable> disturbances = root.tables("disturbance");
  course.terrain = terrain_of(root);
  course.fence = fence_of(root);
  // A mistyped table name is reported before the missing table.
  if (segments.empty()) {
    root.finish();
    root.fail("segment", "a course needs at least one [[segment]]");
  }
  if (segments.size() > kMaxSegments) root.fail("segment", "more than 1000 segments");
  if (disturbances.size() > kMaxDisturbances)
    root.fail("disturbance", "more than 100 disturbances");
  double length_m = 0.0;
  for (const text::TomlTable& segment : segments) {
    course.path.push_back(read_segment(segment));
    length_m += length_of(course.path.back());
    if (length_m > kLongestPathM + 1e-6)  // sums are rounded
      segment.fail(
          segment.has("length_m") ? "length_m" : "angle_deg",
          text::format("the path is %.1f m long at the end of this segment, at most %.0f m "
                       "are accepted; split the course",
                       length_m, kLongestPathM));
  }

  for (const text::TomlTable& disturbance : disturbances)
    course.disturbances.push_back(disturbance_of(disturbance));
  try {
    require_sound(root, disturbances, course);
  } catch (const UserError& error) {
    draft.error = error.what();
  }
  return draft;
}

Course parse_course(const std::string& text, const std::string& file) {
  Draft draft = parse_draft(text, file);
  if (!draft.error.empty()) throw UserError(draft.error);
  return std::move(draft.course);
}

}  // namespace tp100::course
