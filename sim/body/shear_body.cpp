#include "sim/body/shear_body.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "core/arithmetic.h"
#include "core/error.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

using Eigen::Vector2d;

// Shoes along the contact: twice as many would change turns by less than 0.1 %.
constexpr int kShoes = 14;
// Stress leads the sliding path by this many steps. This models the damping of rubber, without
// which a body at rest would oscillate on its shoes for long.
constexpr int kLeadSteps = 5;
// Below this speed the motion resistance fades out, so that it does not move a body at rest.
constexpr double kResistanceFadesMps = 0.005;

Vector2d turned(const Vector2d& v, const Vector2d& forward) {
  return {forward.x() * v.x() - forward.y() * v.y(), forward.y() * v.x() + forward.x() * v.y()};
}

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The velocity of a point at `arm` from the centre of a rotation.
Vector2d rotation_velocity(double rate, const Vector2d& arm) {
  return {-rate * arm.y(), rate * arm.x()};
}

void refuse(const char* what, const course::Place& place) {
  throw UserError("--body shear: the " + std::string(what) + " at (" +
                  text::number_text(place.x_m) + ", " + text::number_text(place.y_m) +
                  ") is really on the floor, and this body drives on level ground only; use "
                  "--body ode, or --setup flat, where it is virtual");
}

}  // namespace

ShearBody::ShearBody(const course::Emulated& values, const Pose& start, bool on_stand,
                     const course::Terrain& terrain, const UnevenFloor& floor)
    : body_(values.body),
      shear_(values.shear),
      on_stand_(on_stand),
      terrain_(terrain),
      floor_(floor),
      inertia_kgm2_(values.body.mass_kg *
                    (values.body.length_m * values.body.length_m +
                     values.body.width_m * values.body.width_m) /
                    12.0),
      pitch_m_(values.body.axle_spacing_m / kShoes),
      yaw_rad_(start.yaw_rad) {
  for (const course::Obstacle& obstacle : terrain.obstacles)
    std::visit([](const auto& of) { refuse(to_string(of.kClass), of.place); }, obstacle);
  const double length_m = 2.0 * (body_.axle_spacing_m + kPi * body_.wheel_radius_m);
  const auto shoes = static_cast<std::size_t>(std::lround(length_m / pitch_m_));
  left_.y_m = body_.gauge_m / 2.0;
  right_.y_m = -body_.gauge_m / 2.0;
  // The worn stretches of the two tracks are half a turn apart.
  right_.wear_m = length_m / 2.0;
  left_.stress.assign(shoes, Vector2d::Zero());
  right_.stress.assign(shoes, Vector2d::Zero());
  contacts_.reserve(kShoes + 4);
  position_m_ =
      Vector2d(start.x_m, start.y_m) + turned({body_.com_forward_m, body_.com_left_m}, forward());
  state_.pose.yaw_rad = yaw_rad_;
  observe(velocity_mps_);
}

Vector2d ShearBody::forward() const { return {std::cos(yaw_rad_), std::sin(yaw_rad_)}; }

double ShearBody::friction_at(const Track& track, std::size_t shoe,
                              const Vector2d& ground_m) const {
  const course::Surface* surface =
      terrain_.surfaces.empty() ? nullptr : terrain_.surface_at(ground_m.x(), ground_m.y());
  double friction = body_.friction * (surface == nullptr ? 1.0 : surface->friction_factor) *
                    floor_.at(ground_m.x(), ground_m.y()).friction_factor;
  if (body_.slick_m > 0.0) {
    const double length_m = pitch_m_ * static_cast<double>(track.stress.size());
    const double along_m = pitch_m_ * static_cast<double>(shoe) + track.wear_m;
    if (along_m - length_m * std::floor(along_m / length_m) < body_.slick_m)
      friction *= body_.slick_factor;
  }
  return friction;
}

void ShearBody::distribute(const Track& track, double centre_m) {
  contacts_.clear();
  const double half_m = body_.axle_spacing_m / 2.0;
  // Stiffness of the bedding under each shoe: partial while the shoe enters or leaves the contact,
  // and higher under the wheels at both ends than between them, by a parabola.
  double sum = 0.0, first = 0.0, second = 0.0;
  // From just behind the contact to just ahead of it.
  const double begin = std::floor((track.travel_m - half_m) / pitch_m_) - 1.0;
  const auto shoes = static_cast<double>(track.stress.size());
  auto shoe = static_cast<std::size_t>(begin - shoes * std::floor(begin / shoes));
  for (int i = 0; i < kShoes + 4; ++i) {
    const double x_m = (begin + i) * pitch_m_ - track.travel_m;
    const double overlap = std::clamp((half_m - std::abs(x_m)) / pitch_m_ + 0.5, 0.0, 1.0);
    const double place = std::clamp(x_m / half_m, -1.0, 1.0);
    const double bedding =
        overlap * (1.0 + shear_.pressure_unevenness * (3.0 * place * place - 1.0));
    contacts_.push_back({shoe, place * half_m, bedding, overlap});
    sum += bedding;
    first += bedding * place;
    second += bedding * place * place;
    if (++shoe == track.stress.size()) shoe = 0;
  }
  // A rigid body sinks into that bedding along a line, whose slope puts the centre of pressure
  // under the load. Beyond a slope of 1 an end would lift.
  const double centre = centre_m / half_m;
  const double slope = std::clamp((centre * sum - first) / (second - centre * first), -1.0, 1.0);
  double loaded = 0.0;
  for (ShoeContact& at : contacts_) {
    at.share *= 1.0 + slope * at.x_m / half_m;
    loaded += at.share;
  }
  for (ShoeContact& at : contacts_) at.share /= loaded;
}

ShearBody::Reaction ShearBody::shear(Track& track, double track_mps, double load_n) {
  const Vector2d ahead = forward();
  const Vector2d surface = ahead * track_mps;
  Reaction reaction;
  for (const ShoeContact& at : contacts_) {
    Vector2d& stress = track.stress[at.shoe];
    if (at.overlap <= 0.0) {
      stress.setZero();
      continue;
    }
    const Vector2d arm =
        turned({at.x_m - body_.com_forward_m, track.y_m - body_.com_left_m}, ahead);
    const Vector2d sliding = velocity_mps_ + rotation_velocity(rate_radps_, arm) - surface;
    const double speed = sliding.norm();
    Vector2d now = stress;
    if (speed > 0.0) {
      const Vector2d direction = sliding / speed;
      const double kept = std::exp(-speed * kPhysicsStepS / shear_.modulus_m);
      stress = direction + (stress - direction) * kept;
      now = stress;
      for (int i = 0; i < kLeadSteps; ++i) now = direction + (now - direction) * kept;
    }
    const double area_m2 = body_.shoe_width_m * pitch_m_ * at.overlap;
    const double limit_n = shear_.cohesion_pa * area_m2 +
                           load_n * at.share * friction_at(track, at.shoe, position_m_ + arm);
    const Vector2d force = -limit_n * now;
    reaction.force_n += force;
    reaction.moment_nm += cross(arm, force);
  }
  reaction.traction_n = reaction.force_n.dot(ahead);
  // The resistance of the ground that the track compacts acts on the body, not on the track's
  // surface.
  const Vector2d middle = turned({-body_.com_forward_m, track.y_m - body_.com_left_m}, ahead);
  const double along_mps = (velocity_mps_ + rotation_velocity(rate_radps_, middle)).dot(ahead);
  const Vector2d resistance =
      -ahead * (shear_.motion_resistance * load_n * std::tanh(along_mps / kResistanceFadesMps));
  reaction.force_n += resistance;
  reaction.moment_nm += cross(middle, resistance);
  return reaction;
}

void ShearBody::advance(double left_mps, double right_mps) {
  // The centre of pressure follows from the moments about the centre of mass.
  const Vector2d centre = Vector2d(body_.com_forward_m, body_.com_left_m) -
                          acceleration_mps2_ * (body_.com_height_m / kGravityMps2);
  const double weight_n = body_.mass_kg * kGravityMps2;
  const double leaning = std::clamp(2.0 * centre.y() / body_.gauge_m, -1.0, 1.0);
  distribute(left_, centre.x());
  const Reaction left = shear(left_, left_mps, weight_n / 2.0 * (1.0 + leaning));
  distribute(right_, centre.x());
  const Reaction right = shear(right_, right_mps, weight_n / 2.0 * (1.0 - leaning));
  left_.load_n = left.traction_n;
  right_.load_n = right.traction_n;
  const Vector2d acceleration = (left.force_n + right.force_n) / body_.mass_kg;
  const Vector2d ahead = forward();
  acceleration_mps2_ = {acceleration.dot(ahead), cross(ahead, acceleration)};
  velocity_mps_ += acceleration * kPhysicsStepS;
  rate_radps_ += (left.moment_nm + right.moment_nm) / inertia_kgm2_ * kPhysicsStepS;
  position_m_ += velocity_mps_ * kPhysicsStepS;
  yaw_rad_ += rate_radps_ * kPhysicsStepS;
  left_.travel_m += left_mps * kPhysicsStepS;
  right_.travel_m += right_mps * kPhysicsStepS;
}

void ShearBody::step(double left_track_mps, double right_track_mps) {
  if (on_stand_) return;
  const Vector2d before = velocity_mps_;
  advance(left_track_mps, right_track_mps);
  disturbed_ = disturbance_steps_ > 0;
  if (disturbed_) {
    --disturbance_steps_;
    const Vector2d arm = turned({body_.com_forward_m, body_.com_left_m}, forward());
    const Vector2d reference =
        position_m_ - arm + turned({0.0, disturbance_per_step_m_}, forward());
    yaw_rad_ += disturbance_yaw_per_step_;
    position_m_ = reference + turned({body_.com_forward_m, body_.com_left_m}, forward());
  }
  observe(before);
}

void ShearBody::observe(const Vector2d& velocity_before) {
  const Vector2d ahead = forward();
  const Vector2d arm = turned({body_.com_forward_m, body_.com_left_m}, ahead);
  const Vector2d gained = (velocity_mps_ - velocity_before) / kPhysicsStepS;
  state_.specific_force_mps2 = {gained.dot(ahead), cross(ahead, gained), kGravityMps2};
  Vector2d velocity = velocity_mps_;
  double rate = rate_radps_;
  if (disturbed_) {
    velocity += turned({0.0, disturbance_per_step_m_ / kPhysicsStepS}, ahead);
    rate += disturbance_yaw_per_step_ / kPhysicsStepS;
  }
  velocity -= rotation_velocity(rate, arm);
  state_.velocity_mps = {velocity.x(), velocity.y(), 0.0};
  state_.rate_radps = {0.0, 0.0, rate};
  state_.pose.x_m = position_m_.x() - arm.x();
  state_.pose.y_m = position_m_.y() - arm.y();
  state_.pose.yaw_rad = yaw_rad_;
  state_.left_load_n = left_.load_n;
  state_.right_load_n = right_.load_n;
}

void ShearBody::turn_tracks(double left_m, double right_m) {
  left_.wear_m += left_m;
  right_.wear_m += right_m;
}

void ShearBody::disturbance(double sideways_m, double yaw_rad, double duration_s) {
  if (on_stand_) return;
  disturbance_steps_ = std::max(1, static_cast<int>(std::lround(duration_s / kPhysicsStepS)));
  disturbance_per_step_m_ = sideways_m / disturbance_steps_;
  disturbance_yaw_per_step_ = yaw_rad / disturbance_steps_;
}

}  // namespace tp100::sim
