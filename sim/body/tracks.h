#pragma once
// Contacts of the tracks with floor and obstacles.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "course/robot_file.h"
#include "course/terrain.h"

namespace tp100::sim {

/// A flat convex face, world frame.
struct Face {
  Eigen::Vector3d normal;                ///< outwards, unit length
  std::vector<Eigen::Vector3d> corners;  ///< in order
  std::vector<Eigen::Vector3d> inwards;  ///< in the face, across the side that starts at a corner

  /// Height above the plane. [m]
  double distance(const Eigen::Vector3d& point) const { return normal.dot(point - corners[0]); }
  /// True if a point, projected into the plane, lies between the sides.
  bool over(const Eigen::Vector3d& point) const;
};

/// A convex edge, world frame.
struct Edge3 {
  Eigen::Vector3d begin, end;
  Eigen::Vector3d into_one, into_other;  ///< across the edge into either face, unit length

  /// True if `normal` points away from the edge, between the normals of its two faces.
  bool faces(const Eigen::Vector3d& normal) const;
};

/// An obstacle on the floor: a convex piece with flat faces and the edges between them.
class Obstacle {
 public:
  /// `profile`: (along, up) from floor to floor, along the heading.
  Obstacle(const course::Place& place, const std::vector<Eigen::Vector2d>& profile, double width_m);

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<Edge3>& edges() const { return edges_; }
  /// True if something within `reach_m` of a position on the floor can touch it.
  bool near(double x_m, double y_m, double reach_m) const;

 private:
  course::Place place_;
  double radius_m_ = 0.0;
  std::vector<Face> faces_;
  std::vector<Edge3> edges_;
};

/// One point where a track presses into the ground, world frame.
struct TrackContact {
  Eigen::Vector3d point_m;  ///< on the ground
  Eigen::Vector3d normal;   ///< out of the ground
  double depth_m;           ///< penetration depth of the track
  double stations;          ///< number of stations that it represents in stiffness and creep
  bool left;                ///< which track
};

/// Each track as two columns of ten stations. A station is the lowest point of a ball of the
/// track's outer radius; the eight middle ones lie `mid_lift_m` higher, which decides how much load
/// they carry. Faces are touched by the stations; an edge across the driving direction is touched
/// by the track's exact outline (two half circles and two straights: a stadium) in each column,
/// because such an edge would sink in between balls. The solver's time grows with the number of
/// contacts. Therefore, if the load is even (no `mid_lift_m`), all stations touch the floor and no
/// obstacle is near, the sixteen middle stations of a track are merged into four with the same mean
/// distance from the middle and mean square. With an uneven load that would shift the turning
/// centre too far.
class TrackContacts {
 public:
  TrackContacts(const course::EmulatedBody& values, const course::Terrain& terrain);

  /// Contacts for a body whose centre of mass is at `position_m` with `rotation` (body to world).
  /// The result is valid until the next call.
  const std::vector<TrackContact>& touch(const Eigen::Vector3d& position_m,
                                         const Eigen::Matrix3d& rotation);

 private:
  struct Station {
    Eigen::Vector3d centre_m;  // of the ball, body frame
    double stands_for;
    bool left;
  };
  struct Outline {
    Eigen::Vector3d rear_m, front_m;  // axle centres, body frame
    bool left;
  };
  void touch_floor(const Station& station, const Eigen::Vector3d& centre);
  void touch_faces(const Obstacle& obstacle, const Eigen::Vector3d& centre,
                   const Eigen::Vector3d& sideways, bool left);
  void touch_edge_along(const Edge3& edge, const Eigen::Vector3d& centre,
                        const Eigen::Vector3d& sideways, bool left);
  void touch_edge_across(const Edge3& edge, const Eigen::Vector3d& rear,
                         const Eigen::Vector3d& front, const Eigen::Vector3d& sideways, bool left);
  void add(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double depth_m, bool left);

  double radius_m_;
  double side_m_;   // from a column to the track's nearer flank
  double reach_m_;  // largest distance of a track's point from the centre of mass
  std::vector<Station> stations_, merged_stations_;
  std::vector<Outline> outlines_;
  std::vector<Obstacle> obstacles_;
  std::vector<TrackContact> contacts_;
};

}  // namespace tp100::sim
