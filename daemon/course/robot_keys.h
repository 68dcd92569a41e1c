#pragma once
// The keys of a robot file as a list, for those who show them.

#include <vector>

#include "course/robot.h"
#include "text/key.h"

namespace tp100::course {

/// Those that the daemon uses (model, shape, drive), named "robot.model.slip_left".
std::vector<text::KeyText> robot_keys(const Robot& robot);

}  // namespace tp100::course
