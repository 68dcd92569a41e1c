#include "sim/body/belts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace tp100::sim {
namespace {

using Eigen::Vector3d;

constexpr int kStations = 10;
constexpr double kColumnShare = 13.0 / 45.0;  // of the belt's width, from its centre line
// Something put into an obstacle (a shove) is pressed out gently.
constexpr double kDeepestM = 0.005;
// Directions within 45 deg of the belt's side are its flank, edges within 30 deg of it run across.
constexpr double kFlank = 0.707;
constexpr double kAcross = 0.5;

}  // namespace

Belts::Belts(const course::EmulatedBody& values, const course::Terrain& terrain)
    : radius_m_(values.belt_radius_m), side_m_((0.5 - kColumnShare) * values.belt_width_m) {
  for (const double side : {1.0, -1.0}) {
    for (const double column : {1.0, -1.0}) {
      for (int i = 0; i < kStations; ++i) {
        const bool end = i == 0 || i == kStations - 1;
        const double along = static_cast<double>(i) / (kStations - 1) - 0.5;
        stations_.push_back(
            {{along * values.axle_spacing_m - values.com_forward_m,
              side * values.gauge_m / 2.0 + column * kColumnShare * values.belt_width_m -
                  values.com_left_m,
              values.belt_radius_m + (end ? 0.0 : values.mid_lift_m) - values.com_height_m},
             side > 0.0});
      }
      outlines_.push_back(
          {(stations_.end() - kStations)->centre_m, stations_.back().centre_m, side > 0.0});
    }
  }
  reach_m_ = 0.0;
  for (const Station& station : stations_)
    reach_m_ = std::max(reach_m_, station.centre_m.norm() + radius_m_);
  for (const course::Ramp& ramp : terrain.ramps) obstacles_.emplace_back(ramp);
  for (const course::Block& block : terrain.blocks) obstacles_.emplace_back(block);
  contacts_.reserve(4 * stations_.size());
}

const std::vector<BeltContact>& Belts::touch(const Vector3d& position_m,
                                             const Eigen::Matrix3d& rotation) {
  contacts_.clear();
  for (const Station& station : stations_)
    touch_floor(position_m + rotation * station.centre_m, station.left);

  const Vector3d sideways = rotation.col(1);
  for (const Obstacle& obstacle : obstacles_) {
    if (!obstacle.near(position_m.x(), position_m.y(), reach_m_)) continue;
    for (const Station& station : stations_)
      touch_faces(obstacle, position_m + rotation * station.centre_m, sideways, station.left);
    for (const Edge3& edge : obstacle.edges()) {
      const Vector3d direction = (edge.end - edge.begin).normalized();
      if (std::abs(direction.dot(sideways)) > kAcross) {
        for (const Outline& outline : outlines_)
          touch_edge_across(edge, position_m + rotation * outline.rear_m,
                            position_m + rotation * outline.front_m, sideways, outline.left);
      } else {
        for (const Station& station : stations_)
          touch_edge_along(edge, position_m + rotation * station.centre_m, sideways, station.left);
      }
    }
  }
  return contacts_;
}

void Belts::touch_floor(const Vector3d& centre, bool left) {
  const double depth = radius_m_ - centre.z();
  if (depth <= 0.0) return;
  contacts_.push_back({{centre.x(), centre.y(), 0.0}, Vector3d::UnitZ(), depth, left});
}

void Belts::add(const Vector3d& point, const Vector3d& normal, double depth_m, bool left) {
  if (depth_m > 0.0) contacts_.push_back({point, normal, std::min(depth_m, kDeepestM), left});
}

void Belts::touch_faces(const Obstacle& obstacle, const Vector3d& centre, const Vector3d& sideways,
                        bool left) {
  // Of a convex body the nearest face is the one that is farthest in front of the point.
  const Face* nearest = nullptr;
  double distance = 0.0;
  for (const Face& face : obstacle.faces()) {
    const double d = face.distance(centre);
    if (nearest == nullptr || d > distance) {
      nearest = &face;
      distance = d;
    }
  }
  if (distance > radius_m_ || !nearest->over(centre)) return;
  const bool flank = std::abs(nearest->normal.dot(sideways)) > kFlank;
  add(centre - nearest->normal * distance, nearest->normal,
      (flank ? side_m_ : radius_m_) - distance, left);
}

void Belts::touch_edge_along(const Edge3& edge, const Vector3d& centre, const Vector3d& sideways,
                             bool left) {
  const Vector3d span = edge.end - edge.begin;
  const double share = span.dot(centre - edge.begin) / span.squaredNorm();
  if (share < 0.0 || share > 1.0) return;
  const Vector3d point = edge.begin + share * span;
  const double distance = (centre - point).norm();
  if (distance > radius_m_ || distance < 1e-6) return;
  const Vector3d normal = (centre - point) / distance;
  if (!edge.faces(normal)) return;
  const bool flank = std::abs(normal.dot(sideways)) > kFlank;
  add(point, normal, (flank ? side_m_ : radius_m_) - distance, left);
}

void Belts::touch_edge_across(const Edge3& edge, const Vector3d& rear, const Vector3d& front,
                              const Vector3d& sideways, bool left) {
  const Vector3d span = edge.end - edge.begin;
  const double share = (rear - edge.begin).dot(sideways) / span.dot(sideways);
  if (share < 0.0 || share > 1.0) return;
  const Vector3d point = edge.begin + share * span;
  const Vector3d axles = front - rear;
  const double along = std::clamp(axles.dot(point - rear) / axles.squaredNorm(), 0.0, 1.0);
  const Vector3d from = rear + along * axles;
  const double distance = (from - point).norm();
  if (distance > radius_m_ || distance < 1e-6) return;
  const Vector3d normal = (from - point) / distance;
  if (edge.faces(normal)) add(point, normal, radius_m_ - distance, left);
}

}  // namespace tp100::sim
