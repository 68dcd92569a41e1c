#pragma once
// Where the belts touch floor and obstacles.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "course/robot.h"
#include "sim/body/obstacle.h"

namespace tp100::sim {

/// One point where a belt presses into the ground, world frame.
struct BeltContact {
  Eigen::Vector3d point_m;  ///< on the ground
  Eigen::Vector3d normal;   ///< out of the ground
  double depth_m;           ///< how far the belt is pressed in
  bool left;                ///< which belt
};

/// Both belts as two columns of ten stations each. A station is the lowest point of a ball of the
/// belt's outer radius; the eight middle ones lie `mid_lift_m` higher, which decides how much load
/// they carry. Faces are touched by the stations; an edge across the driving direction is touched
/// by the belt's exact outline (two half circles and two straights: a stadium) in each column,
/// because balls would let it sink in between them.
class Belts {
 public:
  Belts(const course::EmulatedBody& values, const course::Terrain& terrain);

  /// Contacts for a body whose centre of mass is at `position_m` with `rotation` (body to world).
  /// The result is valid until the next call.
  const std::vector<BeltContact>& touch(const Eigen::Vector3d& position_m,
                                        const Eigen::Matrix3d& rotation);

 private:
  struct Station {
    Eigen::Vector3d centre_m;  // of the ball, body frame
    bool left;
  };
  struct Outline {
    Eigen::Vector3d rear_m, front_m;  // axle centres, body frame
    bool left;
  };
  void touch_floor(const Eigen::Vector3d& centre, bool left);
  void touch_faces(const Obstacle& obstacle, const Eigen::Vector3d& centre,
                   const Eigen::Vector3d& sideways, bool left);
  void touch_edge_along(const Edge3& edge, const Eigen::Vector3d& centre,
                        const Eigen::Vector3d& sideways, bool left);
  void touch_edge_across(const Edge3& edge, const Eigen::Vector3d& rear,
                         const Eigen::Vector3d& front, const Eigen::Vector3d& sideways, bool left);
  void add(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double depth_m, bool left);

  double radius_m_;
  double side_m_;   // from an outer column to the belt's flank
  double reach_m_;  // of the whole body around its centre of mass
  std::vector<Station> stations_;
  std::vector<Outline> outlines_;
  std::vector<Obstacle> obstacles_;
  std::vector<BeltContact> contacts_;
};

}  // namespace tp100::sim
