#pragma once
// Driving a body with constant track speeds.

#include <cmath>

#include "sim/body/body.h"

namespace tp100::sim {

inline const BodyState& drive(Body& body, double left_mps, double right_mps, double duration_s) {
  const auto steps = static_cast<int>(std::lround(duration_s / kPhysicsStepS));
  for (int i = 0; i < steps; ++i) body.step(left_mps, right_mps);
  return body.state();
}

}  // namespace tp100::sim
