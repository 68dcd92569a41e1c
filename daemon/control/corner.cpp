#include "control/corner.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"

namespace tp100::control {

void PivotProfile::begin(const course::PathSegment& segment, double max_radps) {
  max_radps_ = max_radps;
  yaw_rad_ = segment.begin.yaw_rad;
  end_rad_ = segment.end.yaw_rad;
  rate_radps_ = 0.0;
  arrived_ = false;
}

void PivotProfile::update(const Parameters& parameters, double dt_s) {
  const double left = end_rad_ - yaw_rad_;
  const double sign = left < 0.0 ? -1.0 : 1.0;
  const double braking = std::sqrt(2.0 * parameters.pivot_acceleration_radps2 * std::abs(left));
  const double rate =
      std::min({parameters.pivot_rate_radps, max_radps_, braking,
                std::abs(rate_radps_) + parameters.pivot_acceleration_radps2 * dt_s});
  yaw_rad_ += sign * std::min(rate * dt_s, std::abs(left));
  arrived_ = std::abs(end_rad_ - yaw_rad_) < 1e-4;
  if (arrived_) yaw_rad_ = end_rad_;
  rate_radps_ = arrived_ ? 0.0 : sign * rate;
}

namespace {

// The reference point may leave the path by this much to keep the turn short.
constexpr double kOffM = 0.005;
// Lines that continue nearly straight, or lead nearly straight back, form no corner.
constexpr double kBluntestRad = 15.0 * kRadPerDeg, kSharpestRad = 165.0 * kRadPerDeg;
// Search grid: radii as fractions of the turning centre's distance, arcs as fractions of the turn.
constexpr int kRadii = 60, kArcs = 16, kSamples = 48;
constexpr double kWidest = 6.0;
// Gain of the gentle pull towards the path in a corner.
constexpr double kPullPs = 6.0;
constexpr double kMaxPullMps = 0.04;

}  // namespace

Corner::Corner(const course::PathSegment& turn, double x_icr_m, double room_m)
    : corner_(turn.begin) {
  const double angle = turn.end.yaw_rad - turn.begin.yaw_rad;
  angle_rad_ = std::abs(angle);
  side_ = angle < 0.0 ? -1.0 : 1.0;
  const double x = std::abs(x_icr_m);
  const double chord = 2.0 * x * std::sin(angle_rad_ / 2.0);
  if (angle_rad_ < kBluntestRad || angle_rad_ > kSharpestRad || chord <= kOffM) return;

  Corner best = *this, tried = *this;
  tried.x_icr_m_ = x_icr_m;
  double least_m = chord;
  for (int i = 1; i <= kRadii; ++i) {
    tried.radius_m_ = x * kWidest * i / kRadii;
    for (int j = 1; j <= kArcs; ++j) {
      tried.arc_rad_ = angle_rad_ * j / kArcs;
      const double aside = tried.radius_m_ * (1.0 - std::cos(tried.arc_rad_));
      tried.spot_m_ = aside / std::sin(angle_rad_);
      tried.arc_end_m_ = tried.radius_m_ * std::sin(tried.arc_rad_) - aside / std::tan(angle_rad_);
      // The reference point neither begins nor ends beyond the corner.
      if (tried.spot_m_ < x || tried.arc_end_m_ + tried.spot_m_ > room_m) continue;
      const double worst_m = std::max(tried.worst_of_turn_m(), kOffM);
      if (worst_m >= least_m) continue;
      least_m = worst_m;
      best = tried;
    }
  }
  *this = best;
}

double Corner::stop_before_m() const {
  return x_icr_m_ < 0.0 ? spot_m_ + x_icr_m_ : arc_end_m_ + x_icr_m_;
}

bool Corner::on_arc(double turned_rad) const {
  return (x_icr_m_ < 0.0 ? angle_rad_ - turned_rad : turned_rad) < arc_rad_;
}

/// In the frame of the first line at the corner, y towards the second one.
Corner::Spot Corner::reference(double turned_rad) const {
  const double from_line = x_icr_m_ < 0.0 ? angle_rad_ - turned_rad : turned_rad;
  const double along_arc = std::min(from_line, arc_rad_);
  const double left_m = arc_end_m_ - radius_m_ * std::sin(along_arc);
  const double aside_m = radius_m_ * (1.0 - std::cos(along_arc));
  Spot centre{-left_m, aside_m};
  if (x_icr_m_ < 0.0) {
    const double c = std::cos(angle_rad_), s = std::sin(angle_rad_);
    centre = {left_m * c - aside_m * s, left_m * s + aside_m * c};
  }
  return {centre.x_m - x_icr_m_ * std::cos(turned_rad),
          centre.y_m - x_icr_m_ * std::sin(turned_rad)};
}

double Corner::distance_m(const Spot& spot) const {
  const double to_corner = magnitude(spot.x_m, spot.y_m);
  const double c = std::cos(angle_rad_), s = std::sin(angle_rad_);
  const double to_first = spot.x_m < 0.0 ? std::abs(spot.y_m) : to_corner;
  const double to_second =
      c * spot.x_m + s * spot.y_m > 0.0 ? std::abs(-s * spot.x_m + c * spot.y_m) : to_corner;
  return std::min(to_first, to_second);
}

double Corner::worst_of_turn_m() const {
  double worst = 0.0;
  for (int i = 0; i <= kSamples; ++i)
    worst = std::max(worst, distance_m(reference(angle_rad_ * i / kSamples)));
  return worst;
}

double Corner::speed_mps(const Pose& pose, double rate_radps) const {
  if (angle_rad_ == 0.0) return 0.0;  // not a turn between two lines
  const double turned = side_ * wrap_angle(pose.yaw_rad - corner_.yaw_rad);
  const double c = std::cos(corner_.yaw_rad), s = std::sin(corner_.yaw_rad);
  const double dx = pose.x_m - corner_.x_m, dy = pose.y_m - corner_.y_m;
  const Spot should = reference(turned);
  // Only the distance to the next line counts: the position along it is corrected by driving on.
  const double nx = -std::sin(angle_rad_), ny = std::cos(angle_rad_);
  const double aside =
      nx * (should.x_m - (c * dx + s * dy)) + ny * (should.y_m - side_ * (c * dy - s * dx));
  const double across = nx * std::cos(turned) + ny * std::sin(turned);
  const double arc_mps = on_arc(turned) ? radius_m_ * std::abs(rate_radps) : 0.0;
  return arc_mps + std::clamp(kPullPs * aside * across, -kMaxPullMps, kMaxPullMps);
}

}  // namespace tp100::control
