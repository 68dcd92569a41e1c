#pragma once
// The robot as URDF, from its file.

#include <string>

#include "course/robot_file.h"

namespace tp100::ros2 {

// Frames and joints of the robot, in URDF and messages. base_link is the reference point of all
// poses: the centre of the tracks' footprint, on the ground.
inline constexpr const char* kBaseLink = "base_link";
inline constexpr const char* kImuLink = "imu_link";
inline constexpr const char* kLeftJoint = "left_sprocket_joint";
inline constexpr const char* kRightJoint = "right_sprocket_joint";

/// Body, both tracks and their sprockets, with the shape's sizes; collision boxes, no masses: the
/// daemon knows none. Both sprockets turn about y, forward positive.
std::string robot_description(const course::Robot& robot);

}  // namespace tp100::ros2
