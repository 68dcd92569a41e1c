#pragma once
// Turns of an emulated body at constant track speeds, measured from its exact motion: without
// encoder, camera or model.

#include <string>
#include <vector>

#include "course/robot_file.h"

namespace tp100::sim {

/// A turn at constant track speeds.
struct BodyTurn {
  std::string name;  ///< of the turn
  double left_mps = 0.0, right_mps = 0.0;
  double wheelbase_m = 0.0;  ///< L of eq 5 with the body's own slip straight ahead
  double yaw_rate_radps = 0.0;
};

/// Measures the wheelbase with which the body really turns, for comparison with eq 7 and with the
/// identified one. Drives it straight ahead for its slip, then an arc and on the spot, each to both
/// sides at the speeds of the courses. L is the mean of both sides. Pure.
std::vector<BodyTurn> measure_turns(const course::Emulated& robot);

}  // namespace tp100::sim
