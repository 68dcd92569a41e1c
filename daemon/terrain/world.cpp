#include "terrain/world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/arithmetic.h"

namespace tp100::terrain {
namespace {

constexpr double kParallel = 1e-9;

double interpolate(const Outline::Point& a, const Outline::Point& b, double at_m) {
  const double span = b.along_m - a.along_m;
  if (span <= kParallel) return std::max(a.height_m, b.height_m);
  return a.height_m + (b.height_m - a.height_m) * (at_m - a.along_m) / span;
}

/// Height of a polyline with ascending positions; 0 outside it, the top at a wall.
template <class Points>
double height_of(const Points& points, std::size_t count, double at_m) {
  double height = 0.0;
  for (std::size_t i = 0; i + 1 < count; ++i)
    if (at_m >= points[i].along_m && at_m <= points[i + 1].along_m)
      height = std::max(height, interpolate(points[i], points[i + 1], at_m));
  return height;
}

// Number of positions at which the track's underside is sampled.
constexpr std::size_t kPlaces = 41;

/// A line between two wheels of a track, on which the track rests.
struct SupportLine {
  std::size_t before = 0, after = 0;
  double rise = 0.0;    // from place to place
  double height = 0.0;  // at the centre of mass
};

/// Heights of a wheel's centre at evenly spaced positions, rear end first.
using WheelHeights = std::array<double, kPlaces>;

// Exactly at a position all lines through it are equally high; slightly beside it they differ.
constexpr double kBeside = 1e-9;

constexpr std::array<double, kPlaces> kOneOver = [] {
  std::array<double, kPlaces> share{};
  for (std::size_t i = 1; i < kPlaces; ++i) share[i] = 1.0 / static_cast<double>(i);
  return share;
}();

SupportLine through(const WheelHeights& wheel, std::size_t before, std::size_t after, double com) {
  const double rise = (wheel[after] - wheel[before]) * kOneOver[after - before];
  return {before, after, rise, wheel[before] + rise * (com - static_cast<double>(before))};
}

void raise(SupportLine& line, const SupportLine& other) {
  if (other.height > line.height) line = other;
}

/// The line through one position up to `com` and one beyond it that is highest at `com`, which is
/// given in positions and may lie beyond the ends: it touches the wheels and cuts none.
SupportLine support_line(const WheelHeights& wheel, double com) {
  const double last = std::clamp(std::floor(com), 0.0, static_cast<double>(kPlaces - 2));
  const auto before = static_cast<std::size_t>(last);
  if (com >= last && com <= last + 1.0) com = std::clamp(com, last + kBeside, last + 1.0 - kBeside);
  SupportLine line = through(wheel, 0, before + 1, com);
  for (bool higher = true; higher;) {
    // Best from one end, then from the other: when neither improves it, the line is the highest of
    // all.
    const double until_now = line.height;
    for (std::size_t j = before + 1, i = line.before; j < kPlaces; ++j)
      raise(line, through(wheel, i, j, com));
    for (std::size_t i = 0, j = line.after; i <= before; ++i)
      raise(line, through(wheel, i, j, com));
    higher = line.height > until_now;
  }
  return line;
}

// The tilt moves the centre of mass and shortens the track, which in turn changes the tilt.
constexpr int kRounds = 12;
constexpr double kSettledRad = 1e-5;
// Tilts that converge at least this fast are extrapolated to their limit (Aitken's delta squared),
// which is then no farther than the last change.
constexpr double kClosesIn = 0.5;
// Greater tilts occur only beside walls that no track climbs.
constexpr double kSteepestRad = 1.2;
// More pieces than this never lie under one robot.
constexpr std::size_t kMaxProfiles = 8;

using Points = decltype(Outline::points);

Points points_of(const course::Ramp& ramp) {
  const double half = ramp.length_m() / 2.0;
  return {{{-half, 0.0},
           {-half + ramp.up_length_m(), ramp.height_m},
           {half - ramp.down_length_m(), ramp.height_m},
           {half, 0.0}}};
}

Points points_of(const course::Block& block) {
  const double half = block.depth_m / 2.0;
  return {{{-half, 0.0}, {-half, block.height_m}, {half, block.height_m}, {half, 0.0}}};
}

}  // namespace

std::vector<Outline> outlines_of(const course::Terrain& terrain) {
  std::vector<Outline> outlines;
  const auto add = [&](const auto& of) {
    outlines.push_back({of.kClass, of.place, points_of(of), of.width_m / 2.0});
  };
  for (const course::Obstacle& obstacle : terrain.obstacles) std::visit(add, obstacle);
  return outlines;
}

Profile::Profile(const Outline& outline, double x_m, double y_m, double cos_yaw, double sin_yaw) {
  const double c = std::cos(outline.place.heading_rad);
  const double s = std::sin(outline.place.heading_rad);
  const double dx = x_m - outline.place.x_m;
  const double dy = y_m - outline.place.y_m;
  const double u = c * dx + s * dy;
  const double v = c * dy - s * dx;
  const double du = c * cos_yaw + s * sin_yaw;
  const double dv = c * sin_yaw - s * cos_yaw;

  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  const auto clip = [&](double at, double step, double low, double high) {
    if (std::abs(step) < kParallel) {
      if (at < low || at > high) to = from;
      return;
    }
    const double a = (low - at) / step;
    const double b = (high - at) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  };
  clip(u, du, outline.points.front().along_m, outline.points.back().along_m);
  clip(v, dv, -outline.half_width_m, outline.half_width_m);
  if (!(to > from)) return;

  // Rounding may put an end at a wall outside the outline.
  const auto height = [&](double at) {
    return height_of(
        outline.points, 4,
        std::clamp(u + at * du, outline.points.front().along_m, outline.points.back().along_m));
  };
  add(from, height(from));
  if (std::abs(du) >= kParallel) {
    for (std::size_t i = 1; i <= 2; ++i) {
      const Outline::Point& point = outline.points[du > 0.0 ? i : 3 - i];
      const double at = (point.along_m - u) / du;
      if (at > from && at < to) add(at, point.height_m);
    }
  }
  add(to, height(to));
  join();
}

// A track queries many positions: values independent of the position are computed once.
void Profile::join() {
  for (std::size_t i = 0; i + 1 < count_; ++i) {
    const Point& a = points_[i];
    const double span = points_[i + 1].along_m - a.along_m;
    const double rise = points_[i + 1].height_m - a.height_m;
    if (span <= kParallel) continue;
    const double length = std::sqrt(span * span + rise * rise);
    edges_[edge_count_++] = {a.along_m,   a.along_m + span, a.height_m,
                             rise / span, rise / length,    span / length};
  }
}

double Profile::height_m(double at_m) const { return height_of(points_, count_, at_m); }

void Profile::lift(const Places& places, ObstacleClass what, std::span<double> wheel,
                   std::span<ObstacleClass> ground) const {
  const double radius = places.radius_m;
  const double last = static_cast<double>(wheel.size()) - 1.0;
  // Each corner and each edge lies below only a few neighbouring positions.
  const auto each = [&](double from_m, double to_m, const auto& height_at) {
    const double from = std::max(std::ceil((from_m - places.first_m) / places.step_m), 0.0);
    const double to = std::min(std::floor((to_m - places.first_m) / places.step_m), last);
    if (!(from <= to)) return;
    for (auto i = static_cast<std::size_t>(from); i <= static_cast<std::size_t>(to); ++i) {
      const double height = height_at(places.first_m + static_cast<double>(i) * places.step_m);
      if (height <= wheel[i]) continue;
      wheel[i] = height;
      ground[i] = what;
    }
  };
  for (std::size_t i = 0; i < count_; ++i) {
    const Point& point = points_[i];
    each(point.along_m - radius, point.along_m + radius, [&](double at_m) {
      const double away = at_m - point.along_m;
      return point.height_m + std::sqrt(std::max(radius * radius - away * away, 0.0));
    });
  }
  for (std::size_t i = 0; i < edge_count_; ++i) {
    const Edge& edge = edges_[i];
    const double ahead = radius * edge.sin_rise;
    each(edge.begin_m - ahead, edge.end_m - ahead, [&](double at_m) {
      return edge.height_m + edge.slope * (at_m + ahead - edge.begin_m) + radius * edge.cos_rise;
    });
  }
}

World::World(const course::Terrain& terrain, const course::ShapeValues& shape)
    : terrain_(terrain), shape_(shape), pieces_(outlines_of(terrain)) {}

bool World::near(const Outline& outline, double x_m, double y_m) const {
  const double reach = outline.radius_m() + shape_.axle_spacing_m + shape_.wheel_radius_m;
  const double dx = x_m - outline.place.x_m;
  const double dy = y_m - outline.place.y_m;
  return dx * dx + dy * dy < reach * reach;
}

World::Support World::support(double x_m, double y_m, double cos_yaw, double sin_yaw,
                              double slope_rad) const {
  const double radius = shape_.wheel_radius_m;
  struct Under {
    Profile profile;
    ObstacleClass ground;
  };
  std::array<std::optional<Under>, kMaxProfiles> under;
  std::size_t count = 0;
  for (const Outline& piece : pieces_) {
    if (count == kMaxProfiles || !near(piece, x_m, y_m)) continue;
    const Profile profile(piece, x_m, y_m, cos_yaw, sin_yaw);
    if (!profile.empty()) under[count++].emplace(Under{profile, piece.obstacle});
  }
  Support result{0.0, 0.0, ObstacleClass::kNone};
  if (count == 0) return result;
  result.slope_rad = std::clamp(slope_rad, -kSteepestRad, kSteepestRad);

  double tried_rad = result.slope_rad, tried_before_rad = 0.0;
  WheelHeights wheel{};
  std::array<ObstacleClass, kPlaces> ground{};
  for (int round = 0; round < kRounds; ++round) {
    tried_rad = std::clamp(tried_rad, -kSteepestRad, kSteepestRad);
    const double c = std::cos(tried_rad);
    const double s = std::sin(tried_rad);
    const double middle = -radius * s;
    const double half = shape_.axle_spacing_m / 2.0 * c;
    const double step = 2.0 * half / (kPlaces - 1);
    wheel.fill(radius);
    ground.fill(ObstacleClass::kNone);
    for (std::size_t n = 0; n < count; ++n)
      under[n]->profile.lift({middle - half, step, radius}, under[n]->ground, wheel, ground);
    // Positions are those of the wheels' centres; the track touches the ground radius * s further
    // on.
    const double com = shape_.com_forward_m * c - shape_.com_height_m * s + half;
    const SupportLine line = support_line(wheel, com / step);
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
    // Only every other round: a value after an extrapolation belongs to no sequence.
    if (round % 2 == 1 && std::abs(change) < kClosesIn * std::abs(change_before))
      tried_rad += change * change / (change_before - change);
  }
  return result;
}

ContactPose World::at(const Pose& pose) const {
  ContactPose contact_pose;
  if (!std::isfinite(pose.x_m + pose.y_m + pose.yaw_rad + pose.pitch_rad)) return contact_pose;
  contact_pose.surface = terrain_.surface_at(pose.x_m, pose.y_m);
  if (std::none_of(pieces_.begin(), pieces_.end(),
                   [&](const Outline& piece) { return near(piece, pose.x_m, pose.y_m); }))
    return contact_pose;
  const double c = std::cos(pose.yaw_rad);
  const double s = std::sin(pose.yaw_rad);
  const double half = shape_.gauge_m / 2.0;
  const Support left = support(pose.x_m - half * s, pose.y_m + half * c, c, s, -pose.pitch_rad);
  const Support right = support(pose.x_m + half * s, pose.y_m - half * c, c, s, -pose.pitch_rad);
  contact_pose.height_m = (left.height_m + right.height_m) / 2.0;
  contact_pose.slope_rad = (left.slope_rad + right.slope_rad) / 2.0;
  contact_pose.pitch_rad = -contact_pose.slope_rad;
  contact_pose.roll_rad = std::atan2(left.height_m - right.height_m, shape_.gauge_m);
  contact_pose.obstacle = std::max(left.obstacle, right.obstacle);
  return contact_pose;
}

double World::height_m(double x_m, double y_m) const {
  double height = 0.0;
  for (const Outline& piece : pieces_) {
    if (!near(piece, x_m, y_m)) continue;
    const course::Place& place = piece.place;
    const Profile profile(piece, x_m, y_m, std::cos(place.heading_rad),
                          std::sin(place.heading_rad));
    if (!profile.empty()) height = std::max(height, profile.height_m(0.0));
  }
  return height;
}

std::optional<BlockAhead> World::next_block(const Pose& pose, double within_m) const {
  std::optional<BlockAhead> next;
  const double rear = -shape_.axle_spacing_m / 2.0 - shape_.wheel_radius_m;
  const double c = std::cos(pose.yaw_rad);
  const double s = std::sin(pose.yaw_rad);
  for (const Outline& piece : pieces_) {
    if (piece.obstacle != ObstacleClass::kBlock) continue;
    const Profile profile(piece, pose.x_m, pose.y_m, c, s);
    if (profile.empty() || profile.end_m() < rear || profile.begin_m() > within_m) continue;
    if (!next || profile.begin_m() < next->distance_m) next = {&piece, profile.begin_m()};
  }
  return next;
}

}  // namespace tp100::terrain
