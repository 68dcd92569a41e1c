#include "terrain/world.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "terrain/carrying_line.h"

namespace tp100::terrain {
namespace {

// The tilt moves the centre of mass and shortens the belt, which change the tilt.
constexpr int kRounds = 12;
constexpr double kSettledRad = 1e-5;
// Tilts that close in at least so fast are followed to where they lead (Aitken's delta squared),
// which is then no farther than the last change.
constexpr double kClosesIn = 0.5;
// Beside walls that no belt climbs.
constexpr double kSteepestRad = 1.2;
// More pieces than this never lie under one robot.
constexpr std::size_t kMostSlices = 8;

}  // namespace

World::World(const course::Terrain& terrain, const course::ShapeValues& shape)
    : terrain_(terrain), shape_(shape) {
  for (const course::Ramp& ramp : terrain_.ramps)
    pieces_.push_back({outline_of(ramp), Obstacle::kRamp});
  for (const course::Block& block : terrain_.blocks)
    pieces_.push_back({outline_of(block), Obstacle::kBlock});
}

bool World::near(const Outline& outline, double x_m, double y_m) const {
  const double reach = outline.radius_m + shape_.axle_spacing_m + shape_.belt_radius_m;
  const double dx = x_m - outline.place.x_m;
  const double dy = y_m - outline.place.y_m;
  return dx * dx + dy * dy < reach * reach;
}

World::Rest World::rest(double x_m, double y_m, double cos_yaw, double sin_yaw,
                        double slope_rad) const {
  const double radius = shape_.belt_radius_m;
  struct Under {
    Slice slice;
    Obstacle ground;
  };
  std::array<std::optional<Under>, kMostSlices> under;
  std::size_t count = 0;
  for (const Piece& piece : pieces_) {
    if (count == kMostSlices || !near(piece.outline, x_m, y_m)) continue;
    const Slice slice(piece.outline, x_m, y_m, cos_yaw, sin_yaw);
    if (!slice.empty()) under[count++].emplace(Under{slice, piece.obstacle});
  }
  Rest result{0.0, 0.0, Obstacle::kNone};
  if (count == 0) return result;
  result.slope_rad = std::clamp(slope_rad, -kSteepestRad, kSteepestRad);

  double tried_rad = result.slope_rad, tried_before_rad = 0.0;
  WheelHeights wheel{};
  std::array<Obstacle, CarryingLine::kPlaces> ground{};
  for (int round = 0; round < kRounds; ++round) {
    tried_rad = std::clamp(tried_rad, -kSteepestRad, kSteepestRad);
    const double c = std::cos(tried_rad);
    const double s = std::sin(tried_rad);
    const double middle = -radius * s;
    const double half = shape_.axle_spacing_m / 2.0 * c;
    const double step = 2.0 * half / (CarryingLine::kPlaces - 1);
    wheel.fill(radius);
    ground.fill(Obstacle::kNone);
    for (std::size_t n = 0; n < count; ++n)
      under[n]->slice.lift({middle - half, step, radius}, under[n]->ground, wheel, ground);
    // Places are those of the wheels' centres; the belt touches the ground radius * s further on.
    const double com = shape_.com_forward_m * c - shape_.com_height_m * s + half;
    const CarryingLine line = carrying_line(wheel, com / step);
    const double slope = line.rise / step;
    result.obstacle = std::max(ground[line.before], ground[line.after]);
    const double tilt = std::clamp(std::atan(slope), -kSteepestRad, kSteepestRad);
    result.slope_rad = tilt;
    result.height_m = line.height + slope * (half - com) - radius * std::cos(tilt);
    const double change = tilt - tried_rad;
    if (std::abs(change) < kSettledRad) break;
    const double change_before = tried_rad - tried_before_rad;
    tried_before_rad = tried_rad;
    tried_rad = tilt;
    // Every other round: the one after a leap belongs to no sequence.
    if (round % 2 == 1 && std::abs(change) < kClosesIn * std::abs(change_before))
      tried_rad += change * change / (change_before - change);
  }
  return result;
}

Footing World::at(const Pose& pose) const {
  Footing footing;
  if (!std::isfinite(pose.x_m + pose.y_m + pose.yaw_rad + pose.pitch_rad)) return footing;
  footing.surface = terrain_.surface_at(pose.x_m, pose.y_m);
  if (std::none_of(pieces_.begin(), pieces_.end(),
                   [&](const Piece& piece) { return near(piece.outline, pose.x_m, pose.y_m); }))
    return footing;
  const double c = std::cos(pose.yaw_rad);
  const double s = std::sin(pose.yaw_rad);
  const double half = shape_.gauge_m / 2.0;
  const Rest left = rest(pose.x_m - half * s, pose.y_m + half * c, c, s, -pose.pitch_rad);
  const Rest right = rest(pose.x_m + half * s, pose.y_m - half * c, c, s, -pose.pitch_rad);
  footing.height_m = (left.height_m + right.height_m) / 2.0;
  footing.slope_rad = (left.slope_rad + right.slope_rad) / 2.0;
  footing.pitch_rad = -footing.slope_rad;
  footing.roll_rad = std::atan2(left.height_m - right.height_m, shape_.gauge_m);
  footing.obstacle = std::max(left.obstacle, right.obstacle);
  return footing;
}

double World::height_m(double x_m, double y_m) const {
  double height = 0.0;
  for (const Piece& piece : pieces_) {
    const course::Place& place = piece.outline.place;
    const Slice slice(piece.outline, x_m, y_m, std::cos(place.heading_rad),
                      std::sin(place.heading_rad));
    if (!slice.empty()) height = std::max(height, slice.height_m(0.0));
  }
  return height;
}

std::optional<BlockAhead> World::next_block(const Pose& pose, double within_m) const {
  std::optional<BlockAhead> next;
  const double rear = -shape_.axle_spacing_m / 2.0 - shape_.belt_radius_m;
  const double c = std::cos(pose.yaw_rad);
  const double s = std::sin(pose.yaw_rad);
  for (std::size_t i = 0; i < terrain_.blocks.size(); ++i) {
    const Slice slice(pieces_[terrain_.ramps.size() + i].outline, pose.x_m, pose.y_m, c, s);
    if (slice.empty() || slice.end_m() < rear || slice.begin_m() > within_m) continue;
    if (!next || slice.begin_m() < next->distance_m)
      next = {&terrain_.blocks[i], slice.begin_m(), slice.end_m() - slice.begin_m()};
  }
  return next;
}

}  // namespace tp100::terrain
