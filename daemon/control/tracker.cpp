#include "control/tracker.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"

namespace tp100::control {
namespace {

using Kind = course::Piece::Kind;

constexpr double kRestMps = 0.005;
constexpr double kRestRadps = 0.05;
// A yaw loop that cannot close the last fraction of a degree must not hold up the run for ever.
constexpr double kPatienceS = 2.0;
// A large heading error slows the robot down, but never to a stop.
constexpr double kSlowestShare = 0.25;

}  // namespace

Tracker::Tracker(const Parameters& parameters, const course::Path& path, double speed_mps,
                 double slip_angle_rad)
    : parameters_(parameters), path_(path), speed_mps_(speed_mps), slip_angle_rad_(slip_angle_rad) {
  for (const course::Piece& piece : path_.pieces()) {
    if (piece.kind == Kind::kPivot) {
      nominal_duration_s_ +=
          std::abs(piece.end.yaw_rad - piece.begin.yaw_rad) / parameters_.pivot_rate_radps +
          parameters_.pivot_rate_radps / parameters_.pivot_acceleration_radps2 +
          2.0 * parameters_.settle_s;
    } else {
      nominal_duration_s_ += piece.length_m / speed_mps_;
    }
  }
  nominal_duration_s_ += speed_mps_ / parameters_.acceleration_mps2 + parameters_.settle_s;
  restart();
}

void Tracker::restart() {
  index_ = 0;
  offset_m_ = 0.0;
  commanded_mps_ = 0.0;
  settled_s_ = 0.0;
  waited_s_ = 0.0;
  stopping_ = false;
  pivot_rate_radps_ = 0.0;
  target_ = Target{};
  pivot_yaw_rad_ = path_.pieces().front().begin.yaw_rad;
}

const course::Piece& Tracker::piece() const { return path_.pieces()[index_]; }

void Tracker::next_piece() {
  if (index_ + 1 == path_.pieces().size()) {
    target_.done = true;
    return;
  }
  ++index_;
  offset_m_ = 0.0;
  settled_s_ = 0.0;
  waited_s_ = 0.0;
  stopping_ = false;
  pivot_yaw_rad_ = piece().begin.yaw_rad;
  pivot_rate_radps_ = 0.0;
}

double Tracker::left_to_stop(double offset_m) const {
  double left = piece().length_m - offset_m;
  for (std::size_t i = index_ + 1;
       i < path_.pieces().size() && path_.pieces()[i].kind != Kind::kPivot; ++i) {
    left += path_.pieces()[i].length_m;
  }
  return left;
}

bool Tracker::settled(const Twist& twist, bool in_tolerance, double dt_s) {
  const bool at_rest =
      std::abs(twist.vx_mps) < kRestMps && std::abs(twist.yaw_rate_radps) < kRestRadps;
  settled_s_ = at_rest && in_tolerance ? settled_s_ + dt_s : 0.0;
  waited_s_ += dt_s;
  return settled_s_ >= parameters_.settle_s || (at_rest && waited_s_ >= kPatienceS);
}

void Tracker::stand(double yaw_rad) {
  commanded_mps_ = 0.0;
  target_.speed_mps = 0.0;
  target_.yaw_rate_radps = 0.0;
  target_.desired_yaw_rad = yaw_rad;
}

const Target& Tracker::update(const Pose& pose, const Twist& twist, double dt_s) {
  if (target_.done) {
    stand(pose.yaw_rad);
    return target_;
  }
  if (piece().kind == Kind::kPivot) {
    turn(pose, twist, dt_s);
  } else {
    follow(pose, twist, dt_s);
  }
  target_.heading_error_rad = wrap_angle(target_.desired_yaw_rad - pose.yaw_rad);
  return target_;
}

void Tracker::follow(const Pose& pose, const Twist& twist, double dt_s) {
  offset_m_ = std::max(offset_m_, path_.project(index_, pose.x_m, pose.y_m));
  while (offset_m_ >= piece().length_m && index_ + 1 < path_.pieces().size() &&
         path_.pieces()[index_ + 1].kind != Kind::kPivot) {
    next_piece();
    offset_m_ = path_.project(index_, pose.x_m, pose.y_m);
  }

  const course::PathPoint here = path_.at(index_, offset_m_);
  const double c = std::cos(here.yaw_rad);
  const double s = std::sin(here.yaw_rad);
  target_.cross_track_m = -s * (pose.x_m - here.x_m) + c * (pose.y_m - here.y_m);
  target_.progress_m = here.s_m;

  const double left_m = left_to_stop(offset_m_);
  stopping_ = stopping_ || left_m <= parameters_.stop_tolerance_m;
  if (stopping_) {
    stand(pose.yaw_rad);
    if (settled(twist, true, dt_s)) next_piece();
    return;
  }

  // The tangent ahead may lie on the next piece.
  const double ahead_m = twist.vx_mps * parameters_.preview_s;
  const course::PathPoint ahead = left_m > ahead_m && offset_m_ + ahead_m > piece().length_m
                                      ? path_.at(index_ + 1, offset_m_ + ahead_m - piece().length_m)
                                      : path_.at(index_, offset_m_ + ahead_m);
  const double approach =
      std::clamp(std::atan(parameters_.cross_track_gain_1pm * target_.cross_track_m),
                 -parameters_.max_approach_rad, parameters_.max_approach_rad);
  const double crab = ahead.curvature_1pm == 0.0 ? slip_angle_rad_ : 0.0;
  target_.desired_yaw_rad = ahead.yaw_rad - approach - crab;

  const double error = std::abs(wrap_angle(target_.desired_yaw_rad - pose.yaw_rad));
  double speed =
      std::min(speed_mps_, std::sqrt(2.0 * parameters_.acceleration_mps2 * std::max(left_m, 0.0)));
  speed *= std::max(kSlowestShare, 1.0 - error);
  speed = std::max(speed, std::min(parameters_.min_speed_mps, speed_mps_));
  commanded_mps_ = std::min(speed, commanded_mps_ + parameters_.acceleration_mps2 * dt_s);
  target_.speed_mps = commanded_mps_;
  target_.yaw_rate_radps = ahead.curvature_1pm * commanded_mps_;
}

void Tracker::turn(const Pose& pose, const Twist& twist, double dt_s) {
  commanded_mps_ = 0.0;
  target_.speed_mps = 0.0;
  target_.cross_track_m = 0.0;
  target_.progress_m = piece().begin.s_m;

  // A trapezoid in yaw: never faster than what still stops at the end.
  const double left = piece().end.yaw_rad - pivot_yaw_rad_;
  const double sign = left < 0.0 ? -1.0 : 1.0;
  const double braking = std::sqrt(2.0 * parameters_.pivot_acceleration_radps2 * std::abs(left));
  const double rate =
      std::min({parameters_.pivot_rate_radps, braking,
                std::abs(pivot_rate_radps_) + parameters_.pivot_acceleration_radps2 * dt_s});
  const double turned = std::min(rate * dt_s, std::abs(left));
  pivot_yaw_rad_ += sign * turned;
  const bool arrived = std::abs(piece().end.yaw_rad - pivot_yaw_rad_) < 1e-4;
  if (arrived) pivot_yaw_rad_ = piece().end.yaw_rad;
  pivot_rate_radps_ = arrived ? 0.0 : sign * rate;
  target_.desired_yaw_rad = pivot_yaw_rad_;
  target_.yaw_rate_radps = pivot_rate_radps_;

  const double error = std::abs(wrap_angle(pivot_yaw_rad_ - pose.yaw_rad));
  if (arrived && settled(twist, error < parameters_.pivot_tolerance_rad, dt_s)) next_piece();
}

}  // namespace tp100::control
