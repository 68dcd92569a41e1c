#include "model/turn.h"

#include <algorithm>
#include <cmath>

namespace tp100::model {

double equivalent_wheelbase_m(const WheelbaseGeometry& geometry) {
  const double lateral = geometry.width_m / 2.0 - geometry.gamma * geometry.offset_y_m;
  const double longitudinal = geometry.length_m / 2.0 - geometry.offset_x_m;
  return 2.0 * (lateral * lateral + longitudinal * longitudinal) / lateral;
}

namespace {

// Difference of the tracks' speeds relative to the faster one, where friction begins to saturate
// and where it is saturated.
constexpr double kWideTurn = 0.45, kTightTurn = 0.65;
// The same where wheelbase and turning centre begin to drift, half-way, and where the drift ends.
constexpr double kWideArc = 0.35, kTightArc = 0.6, kSpin = 1.1;
constexpr double kLagS = 0.1;

double between(double value, double low, double high) {
  return std::clamp((value - low) / (high - low), 0.0, 1.0);
}

}  // namespace

TurnShape turn_shape(double left_mps, double right_mps) {
  const double faster = std::max(std::abs(left_mps), std::abs(right_mps));
  if (!(faster > 0.0)) return {};
  const double difference = (right_mps - left_mps) / faster;
  const double turn = std::abs(difference);
  return {std::clamp(difference / kWideTurn, -1.0, 1.0), between(turn, kWideTurn, kTightTurn),
          between(turn, kWideArc, kTightArc), between(turn, kTightArc, kSpin)};
}

TurnShape TurnMonitor::update(double left_mps, double right_mps, double dt_s) {
  const double share = started_ ? 1.0 - std::exp(-dt_s / kLagS) : 1.0;
  started_ = true;
  left_mps_ += (left_mps - left_mps_) * share;
  right_mps_ += (right_mps - right_mps_) * share;
  return turn_shape(left_mps_, right_mps_);
}

}  // namespace tp100::model
