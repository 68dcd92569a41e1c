#include "speed_loop.h"

#include "shared/number.h"

namespace tp100 {
namespace firmware {
namespace {

using shared::clamp;
using shared::limited;

// Targets below this are a standstill: one count in 180 ms.
const float kStandstillMps = 0.0005f;
const float kStandingS = 0.1f;
// A track that was held makes up for at most this lag afterwards.
const float kLongestLagM = 0.02f;
// The dead band is compensated linearly below this speed, or noise around zero would rattle the
// gears.
const float kDeadBandRampPerMps = 200.0f;

}  // namespace

SpeedGains::SpeedGains(const wire::Parameters& p)
    : per_target(p.feed_forward + p.speed_kp),
      per_speed(p.speed_kp),
      per_lag(p.speed_ki),
      dead_band(p.dead_band),
      ramp(kDeadBandRampPerMps * p.dead_band) {}

float SpeedLoop::update(float target_mps, float dt_s, const SpeedGains& gains) {
  if (limited(target_mps, kStandstillMps)) {
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
  const float dead_band = clamp(target_mps * gains.ramp, gains.dead_band);
  const float duty = gains.per_target * target_mps - gains.per_speed * speed_mps_ + dead_band +
                     clamp(gains.per_lag * lag_m_, 1.0f);
  if (limited(duty, 1.0f)) return duty;
  // Anti-windup: a saturated motor cannot reduce the lag, so the lag must not grow.
  if (duty > 0.0f ? lag_m_ > lag_before : lag_m_ < lag_before) lag_m_ = lag_before;
  return clamp(duty, 1.0f);
}

}  // namespace firmware
}  // namespace tp100
