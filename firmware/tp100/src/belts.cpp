#include "belts.h"

#include "number.h"

namespace tp100 {
namespace firmware {

BeltSpeeds belt_speeds(float speed_mps, float yaw_rate_radps, const wire::Parameters& p) {
  const float arc = yaw_rate_radps * p.wheelbase_m * 0.5f;
  const float left = (speed_mps - arc) / (1.0f - p.slip_left);
  const float right = (speed_mps + arc) / (1.0f - p.slip_right);
  const float turn = clamp((right - left) * 0.5f, p.max_track_mps);
  const float mean = clamp((right + left) * 0.5f, p.max_track_mps - magnitude(turn));
  const BeltSpeeds result = {mean - turn, mean + turn};
  return result;
}

BeltSpeeds approach(const BeltSpeeds& from, const BeltSpeeds& to, float step) {
  const BeltSpeeds result = {from.left + clamp(to.left - from.left, step),
                             from.right + clamp(to.right - from.right, step)};
  return result;
}

}  // namespace firmware
}  // namespace tp100
