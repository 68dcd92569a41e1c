#include "model/turn.h"

#include <algorithm>
#include <cmath>

namespace tp100::model {
namespace {

// Difference of the belts' speeds in parts of the faster one, up to which a turn is wide.
constexpr double kWideTurn = 0.45;
constexpr double kLagS = 0.1;

}  // namespace

double tightness(double left_mps, double right_mps) {
  const double faster = std::max(std::abs(left_mps), std::abs(right_mps));
  const double difference = std::abs(right_mps - left_mps);
  if (difference <= kWideTurn * faster) return 0.0;
  return std::min(1.0, (difference / faster - kWideTurn) / (1.0 - kWideTurn));
}

double Tightness::update(double left_mps, double right_mps, double dt_s) {
  const double share = started_ ? 1.0 - std::exp(-dt_s / kLagS) : 1.0;
  started_ = true;
  left_mps_ += (left_mps - left_mps_) * share;
  right_mps_ += (right_mps - right_mps_) * share;
  return tightness(left_mps_, right_mps_);
}

}  // namespace tp100::model
