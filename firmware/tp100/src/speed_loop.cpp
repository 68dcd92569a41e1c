#include "speed_loop.h"

#include "number.h"

namespace tp100 {
namespace firmware {
namespace {

// Targets below this are a standstill: one count in 180 ms.
const float kStandstillMps = 0.0005f;
const float kStandingS = 0.1f;
// A track that was held makes up for at most this lag afterwards.
const float kLongestLagM = 0.02f;
// The dead band is compensated linearly below this speed, or noise around zero would rattle the
// gears.
const float kDeadBandRampPerMps = 200.0f;

}  // namespace

void SpeedLoop::measure(int32_t counts, uint16_t dt_us, const wire::Parameters& p) {
  if (measured_ == 0) {
    last_counts_ = counts;
    next_ = 0;
    sum_counts_ = 0;
    sum_us_ = 0;
  }
  const int32_t moved = distance(counts, last_counts_);
  last_counts_ = counts;
  // Integer sums neither drift nor take the time of eight float additions.
  if (measured_ == kWindow) {
    sum_counts_ -= counts_[next_];
    sum_us_ -= dt_us_[next_];
  } else {
    ++measured_;
  }
  sum_counts_ += moved;
  sum_us_ += dt_us;
  counts_[next_] = moved;
  dt_us_[next_] = dt_us;
  next_ = static_cast<uint8_t>((next_ + 1) % kWindow);
  if (p.counts_per_metre != counts_per_metre_) {
    counts_per_metre_ = p.counts_per_metre;
    metres_per_count_ = 1.0f / counts_per_metre_;
    mps_per_count_us_ = metres_per_count_ * 1e6f;
  }
  moved_m_ = static_cast<float>(moved) * metres_per_count_;
  speed_mps_ = sum_us_ > 0 ? static_cast<float>(sum_counts_) * mps_per_count_us_ /
                                 static_cast<float>(sum_us_)
                           : 0.0f;
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
  const float edge = clamp(target_mps * kDeadBandRampPerMps, 1.0f);
  const float rest =
      p.feed_forward * target_mps + p.dead_band * edge + p.speed_kp * (target_mps - speed_mps_);
  const float duty = rest + clamp(p.speed_ki * lag_m_, 1.0f);
  // Anti-windup: a saturated motor cannot reduce the lag, so the lag must not grow.
  const bool winds_up =
      (duty > 1.0f && lag_m_ > lag_before) || (duty < -1.0f && lag_m_ < lag_before);
  if (winds_up) lag_m_ = lag_before;
  return clamp(duty, 1.0f);
}

}  // namespace firmware
}  // namespace tp100
