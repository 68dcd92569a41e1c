#include "course/terrain_file.h"

#include "core/angle.h"

namespace tp100::course {
namespace {

constexpr std::size_t kMaxPieces = 50;
constexpr text::Range kPlace{-100.0, 100.0};
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

template <class Piece>
std::vector<Piece> read(text::TomlTable& root, const char* name,
                        Piece (*piece_of)(text::TomlTable)) {
  const std::vector<text::TomlTable> tables = root.tables(name);
  if (tables.size() > kMaxPieces) root.fail(name, std::string("more than 50 [[") + name + "]]");
  std::vector<Piece> pieces;
  pieces.reserve(tables.size());
  for (const text::TomlTable& table : tables) pieces.push_back(piece_of(table));
  return pieces;
}

}  // namespace

Terrain terrain_of(text::TomlTable& root) {
  Terrain terrain;
  terrain.ramps = read<Ramp>(root, "ramp", ramp_of);
  terrain.blocks = read<Block>(root, "block", block_of);
  terrain.surfaces = read<Surface>(root, "surface", surface_of);
  return terrain;
}

}  // namespace tp100::course
