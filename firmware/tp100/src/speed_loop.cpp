#include "speed_loop.h"

#include "number.h"

namespace tp100 {
namespace firmware {
namespace {

// Below this a belt is meant to stand: one count in 180 ms.
const float kStandstillMps = 0.0005f;
const float kStandingS = 0.1f;
// A belt that was held up does not make up for more than this.
const float kLongestLagM = 0.02f;
// The dead band is stepped over linearly below this speed, or noise around zero would rattle the
// gears.
const float kDeadBandRampMps = 0.005f;

}  // namespace

SpeedLoop::SpeedLoop()
    : counts_(),
      dt_s_(),
      next_(0),
      measured_(0),
      last_counts_(0),
      moved_m_(0.0f),
      speed_mps_(0.0f),
      lag_m_(0.0f),
      standing_s_(0.0f) {}

void SpeedLoop::measure(int32_t counts, float dt_s, const wire::Parameters& p) {
  if (measured_ == 0) {
    last_counts_ = counts;
    next_ = 0;
  }
  const int32_t moved = distance(counts, last_counts_);
  last_counts_ = counts;
  counts_[next_] = moved;
  dt_s_[next_] = dt_s;
  next_ = static_cast<uint8_t>((next_ + 1) % kWindow);
  if (measured_ < kWindow) ++measured_;
  int32_t sum = 0;
  float time_s = 0.0f;
  for (uint8_t i = 0; i < measured_; ++i) {
    sum += counts_[i];
    time_s += dt_s_[i];
  }
  const float metres_per_count = 1.0f / p.counts_per_metre;
  moved_m_ = static_cast<float>(moved) * metres_per_count;
  speed_mps_ = time_s > 0.0f ? static_cast<float>(sum) * metres_per_count / time_s : 0.0f;
}

float SpeedLoop::update(float target_mps, float dt_s, const wire::Parameters& p) {
  if (magnitude(target_mps) < kStandstillMps) {
    target_mps = 0.0f;
    if (standing_s_ < kStandingS) standing_s_ += dt_s;
  } else {
    standing_s_ = 0.0f;
  }
  if (standing_s_ >= kStandingS && speed_mps_ == 0.0f) {
    lag_m_ = 0.0f;
    return 0.0f;
  }
  const float lag_before = lag_m_;
  lag_m_ = clamp(lag_m_ + target_mps * dt_s - moved_m_, kLongestLagM);
  const float edge = clamp(target_mps / kDeadBandRampMps, 1.0f);
  const float rest =
      p.feed_forward * target_mps + p.dead_band * edge + p.speed_kp * (target_mps - speed_mps_);
  const float duty = rest + clamp(p.speed_ki * lag_m_, 1.0f);
  // Anti-windup: a saturated motor cannot work the lag off, so it must not grow.
  const bool winds_up =
      (duty > 1.0f && lag_m_ > lag_before) || (duty < -1.0f && lag_m_ < lag_before);
  if (winds_up) lag_m_ = lag_before;
  return clamp(duty, 1.0f);
}

}  // namespace firmware
}  // namespace tp100
