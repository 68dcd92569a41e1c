#include "sim/robot/pusher.h"

#include <cmath>

namespace tp100::sim {

const course::Shove* Pusher::update(EmulatedRobot& robot) {
  if (next_ >= shoves_.size()) return nullptr;
  const Pose& pose = robot.truth().pose;
  // What the push itself adds is not part of the way.
  if (started_ && !robot.shoving()) driven_m_ += std::hypot(pose.x_m - x_m_, pose.y_m - y_m_);
  started_ = true;
  x_m_ = pose.x_m;
  y_m_ = pose.y_m;
  if (driven_m_ < shoves_[next_].at_m || robot.shoving()) return nullptr;
  const course::Shove& shove = shoves_[next_++];
  robot.shove(shove.sideways_m, shove.yaw_rad, shove.duration_s);
  return &shove;
}

}  // namespace tp100::sim
