#include "model/climb_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/error.h"

namespace tp100::model {
namespace {

constexpr int kHalvings = 60;

// Height of the step over whose edge the centre of mass passes at this angle.
double height_at_tip(const ClimbGeometry& g, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  return g.belt_radius_m * (1.0 - c) + g.com_forward_m * s - g.com_height_m * s * s / c;
}

// height_at_tip rises to here and falls beyond; beyond it the edge has also left the flat belt.
double steepest_tip(const ClimbGeometry& g) {
  double low = 0.0, high = std::atan2(g.com_forward_m, g.com_height_m);
  const auto rising = [&g](double angle) {
    const double s = std::sin(angle), c = std::cos(angle);
    return g.belt_radius_m * s + g.com_forward_m * c > g.com_height_m * s * (1.0 + 1.0 / (c * c));
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
  throw SetupError(std::string("step climb: ") + what + " must be a positive length in metres");
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

void check_climb(const ClimbGeometry& g, const Block& block) {
  require_length(g.axle_spacing_m, "axle spacing");
  require_length(g.belt_radius_m, "belt radius");
  require_length(g.com_forward_m, "centre of mass ahead of the rear axle");
  require_length(g.axle_spacing_m - g.com_forward_m, "centre of mass behind the front axle");
  require_length(g.com_height_m, "centre of mass height");
  require_length(g.body_length_m, "body length");
  require_length(g.body_height_m, "body height");
  require_length(block.height_m, "block height");
  if (!(block.depth_m > 0.0)) throw SetupError("step climb: block depth must be positive");
  const double limit = climb_limit_m(g);
  if (block.height_m > limit) {
    throw SetupError("step climb: this robot cannot climb " + millimetres(block.height_m) +
                     "; its limit is " + millimetres(limit) +
                     ": lower the block or the robot's centre of mass");
  }
  const double nose = std::hypot(g.axle_spacing_m - g.com_forward_m, g.belt_radius_m);
  if (block.height_m - g.belt_radius_m >= nose) {
    throw SetupError("step climb: behind a block of " + millimetres(block.height_m) +
                     " this robot falls on its nose; below " + millimetres(nose + g.belt_radius_m) +
                     " it comes down");
  }
}

}  // namespace tp100::model
