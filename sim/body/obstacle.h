#pragma once
// A ramp or a block as the physical world sees it: flat faces and the edges between them.

#include <Eigen/Core>
#include <vector>

#include "course/terrain.h"

namespace tp100::sim {

/// A flat convex face, world frame.
struct Face {
  Eigen::Vector3d normal;                ///< outwards, unit length
  std::vector<Eigen::Vector3d> corners;  ///< in order
  std::vector<Eigen::Vector3d> inwards;  ///< in the face, across the side that starts at a corner

  /// Above the plane. [m]
  double distance(const Eigen::Vector3d& point) const { return normal.dot(point - corners[0]); }
  /// Whether a point, moved into the plane, lies between the sides.
  bool over(const Eigen::Vector3d& point) const;
};

/// A convex edge, world frame.
struct Edge3 {
  Eigen::Vector3d begin, end;
  Eigen::Vector3d into_one, into_other;  ///< across the edge into either face, unit length

  /// Whether `normal` points away from the edge between the normals of its two faces.
  bool faces(const Eigen::Vector3d& normal) const;
};

/// One convex piece on the floor.
class Obstacle {
 public:
  explicit Obstacle(const course::Ramp& ramp);
  explicit Obstacle(const course::Block& block);

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<Edge3>& edges() const { return edges_; }
  /// Whether something within `reach_m` of a place on the floor can touch it.
  bool near(double x_m, double y_m, double reach_m) const;

 private:
  /// `profile`: (along, up) from floor to floor, along the heading.
  Obstacle(const course::Place& place, const std::vector<Eigen::Vector2d>& profile, double width_m);

  course::Place place_;
  double radius_m_ = 0.0;
  std::vector<Face> faces_;
  std::vector<Edge3> edges_;
};

}  // namespace tp100::sim
