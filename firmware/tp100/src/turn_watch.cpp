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

float drained(float balance, float by) {
  if (balance > by) return balance - by;
  if (balance < -by) return balance + by;
  return 0.0f;
}

}  // namespace

void TurnWatch::reset() {
  all_rad_ = 0.0f;
  slow_rad_ = 0.0f;
  samples_ = 0;
}

TurnWatch::Verdict TurnWatch::update(const TurnMark& now, float bias_radps,
                                     const wire::Parameters& p) {
  if (samples_ == 0) then_ = now;
  if (samples_++ < kSamples) return kGood;
  samples_ = 1;
  const float gyro_rad = turned(then_, now, true, bias_radps, p);
  const float difference = gyro_rad - turned(then_, now, false, 0.0f, p);
  const int32_t left = distance(now.left_counts, then_.left_counts);
  const int32_t right = distance(now.right_counts, then_.right_counts);
  const int32_t both = (left < 0 ? -left : left) + (right < 0 ? -right : right);
  const float elapsed_s = static_cast<float>(distance(now.device_us, then_.device_us)) * 1e-6f;
  then_ = now;
  const float slip_rad = kOfTurn * magnitude(gyro_rad) + kOfWay * 0.5f * static_cast<float>(both) /
                                                             (p.counts_per_metre * p.wheelbase_m);
  all_rad_ = drained(all_rad_ + difference, slip_rad);
  slow_rad_ = drained(slow_rad_ + clamp(difference, kSlowRadps * elapsed_s), slip_rad);
  if (magnitude(all_rad_) <= kMostRad && magnitude(slow_rad_) <= kMostSlowRad) return kGood;
  // Forward, a robot that turns further left than its belts has a right belt that counts short.
  const float left_turn = magnitude(all_rad_) > kMostRad ? all_rad_ : slow_rad_;
  return (left_turn > 0.0f) == (left + right >= 0) ? kRightShort : kLeftShort;
}

}  // namespace firmware
}  // namespace tp100
