#include "sim/body/tracks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/arithmetic.h"

namespace tp100::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Tolerance, so that an edge on which the track lies flat still makes contact.
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

constexpr int kStations = 10;
// The stations at 7, 5, 3 and 1 ninths of half the distance between the axles are merged into two
// with the same mean distance from the middle and the same mean square: (4 +- sqrt(5)) / 9.
constexpr double kOuter = (3.0 + 2.0 * std::numbers::phi) / 9.0;
constexpr double kInner = (5.0 - 2.0 * std::numbers::phi) / 9.0;
constexpr double kColumnShare = 13.0 / 45.0;  // of the track's width, from its centre line
// A track that a disturbance moved into an obstacle is pressed out gently.
constexpr double kDeepestM = 0.005;
// Directions within 45 deg of the track's side are its flank, edges within 30 deg of it run across.
constexpr double kFlank = 0.707;
constexpr double kAcross = 0.5;

}  // namespace

bool Face::over(const Vector3d& point) const {
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (inwards[i].dot(point - corners[i]) < 0.0) return false;
  return true;
}

bool Edge3::faces(const Vector3d& normal) const {
  return normal.dot(into_one) <= kConeTolerance && normal.dot(into_other) <= kConeTolerance;
}

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
  radius_m_ = magnitude(profile.back().x(), width_m / 2.0);
}

bool Obstacle::near(double x_m, double y_m, double reach_m) const {
  const double reach = radius_m_ + reach_m;
  const double dx = x_m - place_.x_m;
  const double dy = y_m - place_.y_m;
  return dx * dx + dy * dy < reach * reach;
}

TrackContacts::TrackContacts(const course::EmulatedBody& values, const course::Terrain& terrain)
    : radius_m_(values.wheel_radius_m), side_m_((0.5 - kColumnShare) * values.shoe_width_m) {
  // `along`: from -1 at the rear axle to 1 at the front axle; `side`, `column`: 1 left, -1 right.
  const auto make = [&](double side, double column, double along, double stands_for) -> Station {
    const bool end = std::abs(along) == 1.0;
    return {{along * values.axle_spacing_m / 2.0 - values.com_forward_m,
             side * values.gauge_m / 2.0 + column * kColumnShare * values.shoe_width_m -
                 values.com_left_m,
             values.wheel_radius_m + (end ? 0.0 : values.mid_lift_m) - values.com_height_m},
            stands_for,
            side > 0.0};
  };
  for (const double side : {1.0, -1.0}) {
    for (const double column : {1.0, -1.0}) {
      for (int i = 0; i < kStations; ++i)
        stations_.push_back(make(side, column, 2.0 * i / (kStations - 1) - 1.0, 1.0));
      outlines_.push_back(
          {(stations_.end() - kStations)->centre_m, stations_.back().centre_m, side > 0.0});
      if (values.mid_lift_m > 0.0) continue;
      for (const double end : {-1.0, 1.0}) {
        merged_stations_.push_back(make(side, column, end, 1.0));
        // Mirrored, so that neither side is preferred.
        merged_stations_.push_back(
            make(side, column, end * (column == side ? kOuter : kInner), 4.0));
      }
    }
  }
  reach_m_ = 0.0;
  for (const Station& station : stations_)
    reach_m_ = std::max(reach_m_, station.centre_m.norm() + radius_m_);
  const auto add = [this](const auto& of) {
    obstacles_.emplace_back(of.place, profile_of(of), of.width_m);
  };
  for (const course::Obstacle& obstacle : terrain.obstacles) std::visit(add, obstacle);
  contacts_.reserve(4 * stations_.size());
}

const std::vector<TrackContact>& TrackContacts::touch(const Vector3d& position_m,
                                                      const Eigen::Matrix3d& rotation) {
  const auto touch_floor_with = [&](const std::vector<Station>& stations) {
    contacts_.clear();
    for (const Station& station : stations)
      touch_floor(station, position_m + rotation * station.centre_m);
  };
  touch_floor_with(stations_);
  const auto near = [&](const Obstacle& obstacle) {
    return obstacle.near(position_m.x(), position_m.y(), reach_m_);
  };
  if (!merged_stations_.empty() && contacts_.size() == stations_.size() &&
      std::ranges::none_of(obstacles_, near))
    touch_floor_with(merged_stations_);

  const Vector3d sideways = rotation.col(1);
  for (const Obstacle& obstacle : obstacles_) {
    if (!near(obstacle)) continue;
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

void TrackContacts::touch_floor(const Station& station, const Vector3d& centre) {
  const double depth = radius_m_ - centre.z();
  if (depth <= 0.0) return;
  contacts_.push_back(
      {{centre.x(), centre.y(), 0.0}, Vector3d::UnitZ(), depth, station.stands_for, station.left});
}

void TrackContacts::add(const Vector3d& point, const Vector3d& normal, double depth_m, bool left) {
  if (depth_m > 0.0) contacts_.push_back({point, normal, std::min(depth_m, kDeepestM), 1.0, left});
}

void TrackContacts::touch_faces(const Obstacle& obstacle, const Vector3d& centre,
                                const Vector3d& sideways, bool left) {
  // The nearest face of a convex body is the one with the largest signed distance.
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

void TrackContacts::touch_edge_along(const Edge3& edge, const Vector3d& centre,
                                     const Vector3d& sideways, bool left) {
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

void TrackContacts::touch_edge_across(const Edge3& edge, const Vector3d& rear,
                                      const Vector3d& front, const Vector3d& sideways, bool left) {
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
