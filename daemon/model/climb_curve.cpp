#include "model/climb_curve.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/arithmetic.h"
#include "core/error.h"

namespace tp100::model {

namespace {

constexpr int kHalvings = 60;

// Height of the step over whose edge the centre of mass passes at this angle.
double height_at_tip(const ClimbGeometry& g, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  return g.wheel_radius_m * (1.0 - c) + g.com_forward_m * s - g.com_height_m * s * s / c;
}

// height_at_tip rises up to here and falls beyond; beyond it the edge has also left the flat track.
double steepest_tip(const ClimbGeometry& g) {
  double low = 0.0, high = std::atan2(g.com_forward_m, g.com_height_m);
  const auto rising = [&g](double angle) {
    const double s = std::sin(angle), c = std::cos(angle);
    return g.wheel_radius_m * s + g.com_forward_m * c > g.com_height_m * s * (1.0 + 1.0 / (c * c));
  };
  if (rising(high)) return high;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2.0;
    (rising(middle) ? low : high) = middle;
  }
  return low;
}

void require_length(double value, const char* what) {
  if (std::isfinite(value) && value > 0.0) return;
  throw UserError(std::string("step climb: ") + what + " must be a positive length in metres");
}

std::string millimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f mm", metres * 1e3);
  return text;
}

}  // namespace

double climb_limit_m(const ClimbGeometry& geometry) {
  return height_at_tip(geometry, steepest_tip(geometry));
}

std::optional<double> tip_angle_rad(const ClimbGeometry& geometry, double height_m) {
  double low = 0.0, high = steepest_tip(geometry);
  if (!(height_m <= height_at_tip(geometry, high))) return std::nullopt;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2.0;
    (height_at_tip(geometry, middle) < height_m ? low : high) = middle;
  }
  return (low + high) / 2.0;
}

double gyration_squared_m2(const ClimbGeometry& geometry) {
  return (geometry.body_length_m * geometry.body_length_m +
          geometry.body_height_m * geometry.body_height_m) /
         12.0;
}

void check_climb(const ClimbGeometry& g, const BlockShape& block) {
  require_length(g.axle_spacing_m, "axle spacing");
  require_length(g.wheel_radius_m, "track radius");
  require_length(g.com_forward_m, "centre of mass ahead of the rear axle");
  require_length(g.axle_spacing_m - g.com_forward_m, "centre of mass behind the front axle");
  require_length(g.com_height_m, "centre of mass height");
  require_length(g.body_length_m, "body length");
  require_length(g.body_height_m, "body height");
  require_length(block.height_m, "block height");
  if (!(block.depth_m > 0.0)) throw UserError("step climb: block depth must be positive");
  const double limit = climb_limit_m(g);
  if (block.height_m > limit) {
    throw UserError("step climb: this robot cannot climb " + millimetres(block.height_m) +
                    "; its limit is " + millimetres(limit) +
                    ": lower the block or the robot's centre of mass");
  }
  const double nose = magnitude(g.axle_spacing_m - g.com_forward_m, g.wheel_radius_m);
  if (block.height_m - g.wheel_radius_m >= nose) {
    throw UserError("step climb: behind a block of " + millimetres(block.height_m) +
                    " this robot falls on its nose; below " + millimetres(nose + g.wheel_radius_m) +
                    " it comes down");
  }
}

namespace {

constexpr int kNewtonSteps = 12;

}  // namespace

ClimbCurve::ClimbCurve(const ClimbGeometry& geometry, const BlockShape& block)
    : geometry_(geometry), block_(block) {
  check_climb(geometry, block);
  const double spacing = geometry.axle_spacing_m, radius = geometry.wheel_radius_m;
  const double over = block.height_m - radius;
  const bool has_riser = over > 0.0;
  first_elevation_ = has_riser ? 0.0 : std::asin(-over / radius);
  const double riser_angle = has_riser ? std::asin(over / spacing) : 0.0;
  const double wrapped = has_riser ? riser_angle : first_elevation_;
  if (has_riser) marks_.riser_end = over + radius * riser_angle;
  marks_.wrap_end = marks_.riser_end + radius * (kPi / 2.0 - wrapped);
  const double tip = tip_angle_rad(geometry, block.height_m).value_or(0.0);
  const double all_flat = marks_.wrap_end + spacing;
  marks_.flat_begin = all_flat - geometry.com_forward_m;
  marks_.flat_end = marks_.flat_begin + block.depth_m;
  marks_.cross_end = marks_.flat_begin + geometry.com_height_m * std::tan(tip);

  ClimbGeometry turned = geometry;
  turned.com_forward_m = spacing - geometry.com_forward_m;
  marks_.nose_begin = marks_.flat_end;
  if (const auto back = tip_angle_rad(turned, block.height_m)) {
    marks_.nose_begin -= geometry.com_height_m * std::tan(*back);
  }
  marks_.nose_end = all_flat + block.depth_m;
  last_elevation_ = kPi / 2.0 - edge_angle(spacing);
  const Roll begin{edge_angle(spacing), last_elevation_};
  marks_.slide_end = marks_.nose_end + slide_travel({0.0, first_elevation_}) - slide_travel(begin);
}

// Angle of a body with one axle at ground level and an edge under the track's flat, `flat_m` from
// that axle.
double ClimbCurve::edge_angle(double flat_m) const {
  const double radius = geometry_.wheel_radius_m;
  const double sine = (block_.height_m - radius) / magnitude(flat_m, radius);
  return std::asin(std::min(sine, 1.0)) + std::atan2(radius, flat_m);
}

// Angle of a body with one axle at ground level and the other seen from the edge at `elevation`.
double ClimbCurve::angle_at_elevation(double elevation) const {
  const double radius = geometry_.wheel_radius_m;
  return std::asin((block_.height_m - radius + radius * std::sin(elevation)) /
                   geometry_.axle_spacing_m);
}

Lean ClimbCurve::approach(double travel_m) const {
  Lean lean;
  const double front = travel_m - geometry_.wheel_radius_m * std::cos(first_elevation_);
  lean.rear_axle = {front - geometry_.axle_spacing_m, geometry_.wheel_radius_m};
  return lean;
}

Lean ClimbCurve::riser(double travel_m) const {
  const double spacing = geometry_.axle_spacing_m, radius = geometry_.wheel_radius_m;
  Lean lean;
  // From below on a concave curve, Newton steps never overshoot.
  double angle = travel_m / (spacing + radius);
  for (int i = 0; i < kNewtonSteps; ++i) {
    angle -= (spacing * std::sin(angle) + radius * angle - travel_m) /
             (spacing * std::cos(angle) + radius);
  }
  lean.angle_rad = angle;
  lean.rear_axle = {-radius - spacing * std::cos(angle), radius};
  return lean;
}

Lean ClimbCurve::wrap(double travel_m) const {
  const double spacing = geometry_.axle_spacing_m, radius = geometry_.wheel_radius_m;
  const double over = block_.height_m - radius;
  const double wrapped = kPi / 2.0 - (marks_.wrap_end - travel_m) / radius;
  const double along = spacing + radius * std::cos(wrapped), up = radius * std::sin(wrapped);
  Lean lean;
  lean.angle_rad = std::asin(over / magnitude(along, up)) + std::atan2(up, along);
  const double elevation = wrapped - lean.angle_rad;
  lean.rear_axle = {-radius * std::cos(elevation) - spacing * std::cos(lean.angle_rad), radius};
  return lean;
}

Lean ClimbCurve::about_edge(double edge_x, double flat_m, double angle_rad) const {
  const double s = std::sin(angle_rad), c = std::cos(angle_rad);
  const double radius = geometry_.wheel_radius_m;
  Lean lean;
  lean.angle_rad = angle_rad;
  lean.rear_axle = {edge_x - flat_m * c - radius * s, block_.height_m - flat_m * s + radius * c};
  return lean;
}

Lean ClimbCurve::about_near_edge(double travel_m, double angle_rad) const {
  return about_edge(0.0, geometry_.com_forward_m - past_near_edge_m(travel_m), angle_rad);
}

Lean ClimbCurve::about_far_edge(double travel_m, double angle_rad) const {
  return about_edge(block_.depth_m, geometry_.com_forward_m - past_far_edge_m(travel_m), angle_rad);
}

Lean ClimbCurve::cross(double travel_m) const {
  const double flat = geometry_.com_forward_m - past_near_edge_m(travel_m);
  Lean lean = about_edge(0.0, flat, edge_angle(flat));
  const double s = std::sin(lean.angle_rad), c = std::cos(lean.angle_rad);
  lean.rate_radpm = s / (flat * c + geometry_.wheel_radius_m * s);
  return lean;
}

double ClimbCurve::cross_bend(double travel_m) const {
  const double radius = geometry_.wheel_radius_m;
  const double flat = geometry_.com_forward_m - past_near_edge_m(travel_m);
  const double angle = edge_angle(flat), s = std::sin(angle), c = std::cos(angle);
  const double lever = flat * c + radius * s, rate = s / lever;
  const double lever_change = -c + rate * (radius * c - flat * s);
  return (c * rate - rate * lever_change) / lever;
}

Lean ClimbCurve::nose(double travel_m) const {
  const double behind = geometry_.com_forward_m - past_far_edge_m(travel_m);
  const double ahead = geometry_.axle_spacing_m - behind;
  const double down = edge_angle(ahead);
  Lean lean = about_edge(block_.depth_m, behind, -down);
  const double s = std::sin(down), c = std::cos(down);
  lean.rate_radpm = s / (ahead * c + geometry_.wheel_radius_m * s);
  return lean;
}

// Travel of a front contact that holds, up to a constant, while the rear comes off the edge.
double ClimbCurve::slide_travel(const Roll& roll) const {
  return geometry_.axle_spacing_m * std::cos(roll.angle) +
         geometry_.wheel_radius_m * (std::cos(roll.elevation) - roll.angle);
}

// Rear end around the edge, then down the far face (elevation 0); travel grows on both.
ClimbCurve::Roll ClimbCurve::roll_at(double travel_m) const {
  const double wanted = travel_m - marks_.slide_end + slide_travel({0.0, first_elevation_});
  const double face_angle = angle_at_elevation(first_elevation_);
  const bool on_face = wanted > slide_travel({face_angle, first_elevation_});
  const auto roll = [&](double value) {
    return on_face ? Roll{value, first_elevation_} : Roll{angle_at_elevation(value), value};
  };
  double low = on_face ? 0.0 : first_elevation_;
  double high = on_face ? face_angle : last_elevation_;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2.0;
    (slide_travel(roll(middle)) > wanted ? low : high) = middle;
  }
  return roll((low + high) / 2.0);
}

Lean ClimbCurve::slide(double travel_m) const {
  const double spacing = geometry_.axle_spacing_m, radius = geometry_.wheel_radius_m;
  const Roll roll = roll_at(travel_m);
  Lean lean;
  lean.angle_rad = -roll.angle;
  lean.rear_axle = {block_.depth_m + radius * std::cos(roll.elevation),
                    radius + spacing * std::sin(roll.angle)};
  return lean;
}

Lean ClimbCurve::down(double travel_m) const {
  Lean lean;
  lean.rear_axle = {block_.depth_m + geometry_.wheel_radius_m * std::cos(first_elevation_) +
                        travel_m - marks_.slide_end,
                    geometry_.wheel_radius_m};
  return lean;
}

}  // namespace tp100::model
