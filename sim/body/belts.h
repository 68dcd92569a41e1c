#pragma once
// Where the belts touch the ground.

#include <Eigen/Core>
#include <vector>

#include "course/robot.h"

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
/// they carry.
class Belts {
 public:
  explicit Belts(const course::EmulatedBody& values);

  /// Contacts with the plane z = 0 for a body whose centre of mass is at `position_m` with
  /// `rotation` (body to world). The result is valid until the next call.
  const std::vector<BeltContact>& touch(const Eigen::Vector3d& position_m,
                                        const Eigen::Matrix3d& rotation);

 private:
  struct Station {
    Eigen::Vector3d centre_m;  // of the ball, body frame
    bool left;
  };
  double radius_m_;
  std::vector<Station> stations_;
  std::vector<BeltContact> contacts_;
};

}  // namespace tp100::sim
