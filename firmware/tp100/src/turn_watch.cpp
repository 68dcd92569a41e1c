#include "turn_watch.h"

#include "number.h"

namespace tp100 {
namespace firmware {
namespace {

// Float operations take an AVR long: eight samples are one step.
const uint8_t kSamples = 8;
const float kMostRad = 0.35f;
const float kMostSlowRad = 0.175f;
const float kSlowRadps = 0.175f;
// Of a robot that is not identified yet nobody knows how much of a turn its belts make.
const float kOfTurn = 0.8f;
const float kOfWay = 0.1f;

// Duty that a full turn takes, and a slope or bump against how the robot stood when it began. Loads
// come at once and go slowly.
const float kTurnDuty = 0.3f;
const float kTurnFallPerS = 0.3f;
const float kFullTurning = 0.4f;  // speed of a track by the turn alone, in parts of the mean speed
const float kSlowestRad = 0.003f;
const float kMostSlopeDuty = 0.4f;
const float kSlopeFallPerS = 0.15f;
const float kDutyPerRad = 3.0f;
const float kLevelRad = 0.02f;
const float kNewSlope = 0.5f;

float drained(float balance, float by) {
  if (balance > by) return balance - by;
  if (balance < -by) return balance + by;
  return 0.0f;
}

}  // namespace

void TurnWatch::reset() {
  all_rad_ = 0.0f;
  slow_rad_ = 0.0f;
  slope_rad_ = 0.0f;
  level_known_ = false;
  level_rad_ = 0.0f;
  slope_duty_ = 0.0f;
  turn_duty_ = 0.0f;
  accel_x_ = 0;
  samples_ = 0;
}

TurnWatch::Verdict TurnWatch::update(const TurnMark& now, int16_t accel_x, float bias_radps,
                                     const wire::Parameters& p) {
  if (samples_ == 0) {
    then_ = now;
  } else {
    accel_x_ += accel_x;
  }
  if (samples_++ < kSamples) return kGood;
  samples_ = 1;
  const float gyro_rad = turned(then_, now, true, bias_radps, p);
  const float difference = gyro_rad - turned(then_, now, false, 0.0f, p);
  const int32_t left = distance(now.left_counts, then_.left_counts);
  const int32_t right = distance(now.right_counts, then_.right_counts);
  const int32_t both = (left < 0 ? -left : left) + (right < 0 ? -right : right);
  const float elapsed_s = static_cast<float>(distance(now.device_us, then_.device_us)) * 1e-6f;
  then_ = now;
  const float driven_rad = 0.5f * static_cast<float>(both) / (p.counts_per_metre * p.wheelbase_m);
  weigh(magnitude(gyro_rad), driven_rad, elapsed_s);
  const float slip_rad = kOfTurn * magnitude(gyro_rad) + kOfWay * driven_rad;
  all_rad_ = drained(all_rad_ + difference, slip_rad);
  slow_rad_ = drained(slow_rad_ + clamp(difference, kSlowRadps * elapsed_s), slip_rad);
  if (magnitude(all_rad_) <= kMostRad && magnitude(slow_rad_) <= kMostSlowRad) return kGood;
  // Forward, a robot that turns further left than its belts has a right belt that counts short.
  const float left_turn = magnitude(all_rad_) > kMostRad ? all_rad_ : slow_rad_;
  return (left_turn > 0.0f) == (left + right >= 0) ? kRightShort : kLeftShort;
}

void TurnWatch::weigh(float turn_rad, float driven_rad, float elapsed_s) {
  const float turning = 0.5f * turn_rad / larger(driven_rad, kSlowestRad);
  turn_duty_ = larger(kTurnDuty * smaller(1.0f, turning / kFullTurning),
                      turn_duty_ - kTurnFallPerS * elapsed_s);
  const float pitch_rad = static_cast<float>(accel_x_) * (1.0f / (wire::kAccelLsbPerG * kSamples));
  accel_x_ = 0;
  if (!level_known_) level_rad_ = pitch_rad;
  level_known_ = true;
  slope_rad_ += (pitch_rad - level_rad_ - slope_rad_) * kNewSlope;
  const float slope_duty =
      smaller(kMostSlopeDuty, kDutyPerRad * (magnitude(slope_rad_) - kLevelRad));
  slope_duty_ = larger(larger(0.0f, slope_duty), slope_duty_ - kSlopeFallPerS * elapsed_s);
}

}  // namespace firmware
}  // namespace tp100
