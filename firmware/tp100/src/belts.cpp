#include "belts.h"

#include "number.h"

namespace tp100 {
namespace firmware {

BeltSpeeds belt_speeds(float speed_mps, float yaw_rate_radps, const wire::Parameters& p) {
  const float left_grip = 1.0f - p.slip_left;
  const float right_grip = 1.0f - p.slip_right;
  const float left_limit = p.max_track_mps * left_grip;
  const float right_limit = p.max_track_mps * right_grip;
  const float arc = clamp(yaw_rate_radps * p.wheelbase_m * 0.5f, (left_limit + right_limit) * 0.5f);
  // Ground speeds at which each belt stays within its limit while the turn is kept.
  const float slowest = larger(arc - left_limit, -arc - right_limit);
  const float fastest = smaller(arc + left_limit, -arc + right_limit);
  const float speed = larger(slowest, smaller(fastest, speed_mps));
  // Numbers are within the limit already; what is none must ask for a standstill.
  const BeltSpeeds result = {clamp((speed - arc) / left_grip, p.max_track_mps),
                             clamp((speed + arc) / right_grip, p.max_track_mps)};
  return result;
}

BeltSpeeds approach(const BeltSpeeds& from, const BeltSpeeds& to, float step) {
  const BeltSpeeds result = {from.left + clamp(to.left - from.left, step),
                             from.right + clamp(to.right - from.right, step)};
  return result;
}

}  // namespace firmware
}  // namespace tp100
