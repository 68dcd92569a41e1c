#include "core/pose.h"

#include <cmath>

#include "core/angle.h"

namespace tp100 {

Pose Transform2d::of(const Pose& pose) const {
  Pose out = pose;
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  // Without a rotation, nothing is rounded.
  out.x_m = (turn_rad == 0.0 ? pose.x_m : c * pose.x_m - s * pose.y_m) + x_m;
  out.y_m = (turn_rad == 0.0 ? pose.y_m : s * pose.x_m + c * pose.y_m) + y_m;
  out.yaw_rad = pose.yaw_rad + turn_rad;
  return out;
}

Transform2d Transform2d::between(const Pose& from, const Pose& to) {
  Transform2d transform;
  transform.turn_rad = wrap_angle(to.yaw_rad - from.yaw_rad);
  const Pose turned = transform.of(from);
  transform.x_m = to.x_m - turned.x_m;
  transform.y_m = to.y_m - turned.y_m;
  return transform;
}

}  // namespace tp100
