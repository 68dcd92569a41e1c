#include "sim/body/obstacle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tp100::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// An edge on which the belt lies flat is still felt.
constexpr double kConeTolerance = 0.02;

std::vector<Vector2d> profile_of(const course::Ramp& ramp) {
  const double half = ramp.length_m() / 2.0;
  std::vector<Vector2d> profile = {{-half, 0.0}, {-half + ramp.up_length_m(), ramp.height_m}};
  if (ramp.top_m > 0.0) profile.push_back({half - ramp.down_length_m(), ramp.height_m});
  profile.push_back({half, 0.0});
  return profile;
}

std::vector<Vector2d> profile_of(const course::Block& block) {
  const double half = block.depth_m / 2.0;
  return {{-half, 0.0}, {-half, block.height_m}, {half, block.height_m}, {half, 0.0}};
}

Face face_of(std::vector<Vector3d> corners, const Vector3d& normal) {
  Face face{normal, std::move(corners), {}};
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& corner : face.corners) middle += corner;
  middle /= static_cast<double>(face.corners.size());
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const Vector3d side = face.corners[(i + 1) % face.corners.size()] - face.corners[i];
    Vector3d inwards = normal.cross(side).normalized();
    if (inwards.dot(middle - face.corners[i]) < 0.0) inwards = -inwards;
    face.inwards.push_back(inwards);
  }
  return face;
}

}  // namespace

bool Face::over(const Vector3d& point) const {
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (inwards[i].dot(point - corners[i]) < 0.0) return false;
  return true;
}

bool Edge3::faces(const Vector3d& normal) const {
  return normal.dot(into_one) <= kConeTolerance && normal.dot(into_other) <= kConeTolerance;
}

Obstacle::Obstacle(const course::Ramp& ramp)
    : Obstacle(ramp.place, profile_of(ramp), ramp.width_m) {}

Obstacle::Obstacle(const course::Block& block)
    : Obstacle(block.place, profile_of(block), block.width_m) {}

Obstacle::Obstacle(const course::Place& place, const std::vector<Vector2d>& profile, double width_m)
    : place_(place) {
  const Vector3d ahead(std::cos(place.heading_rad), std::sin(place.heading_rad), 0.0);
  const Vector3d left(-ahead.y(), ahead.x(), 0.0);
  const auto at = [&](const Vector2d& point, double side) -> Vector3d {
    return Vector3d(place.x_m, place.y_m, 0.0) + ahead * point.x() + left * side * width_m / 2.0 +
           Vector3d::UnitZ() * point.y();
  };
  std::vector<Vector3d> normals, along;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const Vector2d step = (profile[i + 1] - profile[i]).normalized();
    along.emplace_back(ahead * step.x() + Vector3d::UnitZ() * step.y());
    normals.emplace_back(Vector3d::UnitZ() * step.x() - ahead * step.y());
  }
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    faces_.push_back(face_of({at(profile[i], 1.0), at(profile[i + 1], 1.0),
                              at(profile[i + 1], -1.0), at(profile[i], -1.0)},
                             normals[i]));
    for (const double side : {1.0, -1.0})
      edges_.push_back({at(profile[i], side), at(profile[i + 1], side), left * -side, -normals[i]});
    if (i > 0)
      edges_.push_back({at(profile[i], 1.0), at(profile[i], -1.0), -along[i - 1], along[i]});
  }
  for (const double side : {1.0, -1.0}) {
    std::vector<Vector3d> corners;
    corners.reserve(profile.size());
    for (const Vector2d& point : profile) corners.push_back(at(point, side));
    faces_.push_back(face_of(std::move(corners), left * side));
  }
  radius_m_ = std::hypot(profile.back().x(), width_m / 2.0);
}

bool Obstacle::near(double x_m, double y_m, double reach_m) const {
  const double reach = radius_m_ + reach_m;
  const double dx = x_m - place_.x_m;
  const double dy = y_m - place_.y_m;
  return dx * dx + dy * dy < reach * reach;
}

}  // namespace tp100::sim
