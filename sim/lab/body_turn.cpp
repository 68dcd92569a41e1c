#include "sim/lab/body_turn.h"

#include <memory>

#include "sim/lab/body_slope.h"

namespace tp100::sim {
namespace {

constexpr double kSettleS = 1.0;
constexpr double kMeasuredS = 4.0;

MeanMotion driven(const course::Emulated& robot, const TrackSpeeds& tracks) {
  const std::unique_ptr<Body> body = make_body(robot, {}, false);
  return mean_motion(*body, tracks, kSettleS, kMeasuredS);
}

}  // namespace

std::vector<BodyTurn> measure_turns(const course::Emulated& robot) {
  constexpr double kStraightMps = 0.10;
  const MeanMotion straight = driven(robot, {kStraightMps, kStraightMps});
  const double half_mps = straight.yaw_rate_radps * robot.body.gauge_m / 2.0;
  const double left_kept = (straight.forward_mps - half_mps) / kStraightMps;
  const double right_kept = (straight.forward_mps + half_mps) / kStraightMps;
  std::vector<BodyTurn> turns = {{.name = "in an arc", .left_mps = 0.07, .right_mps = 0.13},
                                 {.name = "on the spot", .left_mps = -0.08, .right_mps = 0.08}};
  for (BodyTurn& turn : turns) {
    turn.yaw_rate_radps = driven(robot, {turn.left_mps, turn.right_mps}).yaw_rate_radps;
    const double other_radps = driven(robot, {turn.right_mps, turn.left_mps}).yaw_rate_radps;
    const double to_left_m =
        (right_kept * turn.right_mps - left_kept * turn.left_mps) / turn.yaw_rate_radps;
    const double to_right_m =
        (right_kept * turn.left_mps - left_kept * turn.right_mps) / other_radps;
    turn.wheelbase_m = (to_left_m + to_right_m) / 2.0;
  }
  return turns;
}

}  // namespace tp100::sim
