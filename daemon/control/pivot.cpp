#include "control/pivot.h"

#include <algorithm>
#include <cmath>

namespace tp100::control {
namespace {

// A robot in a corner is drawn to where it should be, gently.
constexpr double kDrawnPs = 2.0;
constexpr double kDrawnMps = 0.02;

}  // namespace

void Pivot::begin(const course::Piece& piece) {
  yaw_rad_ = piece.begin.yaw_rad;
  end_rad_ = piece.end.yaw_rad;
  rate_radps_ = 0.0;
  arrived_ = false;
}

void Pivot::update(const Parameters& parameters, double dt_s) {
  const double left = end_rad_ - yaw_rad_;
  const double sign = left < 0.0 ? -1.0 : 1.0;
  const double braking = std::sqrt(2.0 * parameters.pivot_acceleration_radps2 * std::abs(left));
  const double rate =
      std::min({parameters.pivot_rate_radps, braking,
                std::abs(rate_radps_) + parameters.pivot_acceleration_radps2 * dt_s});
  yaw_rad_ += sign * std::min(rate * dt_s, std::abs(left));
  arrived_ = std::abs(end_rad_ - yaw_rad_) < 1e-4;
  if (arrived_) yaw_rad_ = end_rad_;
  rate_radps_ = arrived_ ? 0.0 : sign * rate;
}

RoundedCorner::RoundedCorner(const course::Piece& turn, double x_icr_m)
    : corner_(turn.begin), x_icr_m_(x_icr_m) {
  const double angle = turn.end.yaw_rad - turn.begin.yaw_rad;
  side_ = angle < 0.0 ? -1.0 : 1.0;
  // Beyond a right angle the lines run back beside each other: the arc may not begin earlier.
  const double half = std::tan(std::min(std::abs(angle), kPi - 0.01) / 2.0);
  tangent_m_ = std::abs(x_icr_m) * std::min(half, 1.0);
  radius_m_ = half > 0.0 ? tangent_m_ / half : 0.0;
  stop_before_m_ = std::max(tangent_m_ + x_icr_m, 0.0);
}

double RoundedCorner::speed_mps(const Pose& pose, double yaw_rad, double rate_radps) const {
  if (side_ == 0.0) return 0.0;
  // Where on the arc the reference point should be, in the frame of the first line at the corner.
  const double turned = side_ * (yaw_rad - corner_.yaw_rad);
  const double ahead = -tangent_m_ + radius_m_ * std::sin(turned) - x_icr_m_ * std::cos(turned);
  const double aside = side_ * (radius_m_ * (1.0 - std::cos(turned)) - x_icr_m_ * std::sin(turned));
  const double c = std::cos(corner_.yaw_rad), s = std::sin(corner_.yaw_rad);
  const double to_x = corner_.x_m + c * ahead - s * aside - pose.x_m;
  const double to_y = corner_.y_m + s * ahead + c * aside - pose.y_m;
  const double along = std::cos(pose.yaw_rad) * to_x + std::sin(pose.yaw_rad) * to_y;
  return radius_m_ * std::abs(rate_radps) + std::clamp(kDrawnPs * along, -kDrawnMps, kDrawnMps);
}

}  // namespace tp100::control
