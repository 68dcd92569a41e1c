#pragma once
// The one who pushes the robot: a course's shoves, at their places along the way.

#include <cstddef>
#include <vector>

#include "course/course.h"
#include "sim/robot/emulated_robot.h"

namespace tp100::sim {

/// Watches how far the robot has really driven and pushes it where the course says.
class Pusher {
 public:
  explicit Pusher(std::vector<course::Shove> shoves) : shoves_(std::move(shoves)) {}

  /// Call after each physics step. Returns the shove that begins now, or null.
  const course::Shove* update(EmulatedRobot& robot);

 private:
  std::vector<course::Shove> shoves_;
  std::size_t next_ = 0;
  bool started_ = false;
  double x_m_ = 0.0, y_m_ = 0.0;
  double driven_m_ = 0.0;
};

}  // namespace tp100::sim
