#pragma once
// The wheelbase with which an emulated body really turns, to set beside eq 7 and what is
// identified.

#include <string>
#include <vector>

#include "course/robot_file.h"

namespace tp100::sim {

/// A turn at constant track speeds.
struct BodyTurn {
  std::string name;  ///< of the turn
  double left_mps = 0.0, right_mps = 0.0;
  double wheelbase_m = 0.0;  ///< L of eq 5 with the body's own slip straight on
  double yaw_rate_radps = 0.0;
};

/// Drives the body straight on for its slip, then an arc and on the spot, each to both sides at the
/// speeds of the courses, from its exact poses: no encoder, no camera, no model. L is the mean of
/// both sides. Pure.
std::vector<BodyTurn> measure_turns(const course::Emulated& robot);

}  // namespace tp100::sim
