#include "belt_watch.h"

#include "number.h"

namespace tp100 {
namespace firmware {
namespace {

const float kStandingM = 0.002f;
// A belt that brakes runs on against its duty for a while: more than this far is wiring.
const float kRunOnM = 0.02f;
const float kRunOnS = 0.2f;

// So far no belt moves between two samples, beyond twice its fastest: counts from nowhere. A glitch
// comes alone, and is over soon.
const float kJumpM = 0.004f;
const int32_t kFewCounts = 8;
const uint16_t kJumpAgainMs = 1000;
const uint16_t kOneJumpMs = 100;

// A duty means a speed, but for a file that is off by a fifth and all the load that belts can take
// from the floor.
const float kMissingM = 0.05f;
const float kSpeedShare = 1.2f;
const float kLoadDuty = 0.3f;
// A belt that stands is found in this part of the time that `stall_ms` allows.
const float kSoonestMs = 0.8f;
const uint16_t kStepMs = 40;

}  // namespace

BeltWatch::BeltWatch()
    : known_(false),
      last_counts_(0),
      jumped_ms_(0),
      sign_(0),
      start_counts_(0),
      standing_ms_(0),
      best_counts_(0),
      step_counts_(0),
      step_duty_ms_(0),
      step_ms_(0),
      missing_m_(0.0f) {}

BeltWatch::Verdict BeltWatch::update(int16_t duty, int32_t counts, uint16_t dt_ms,
                                     const wire::Parameters& p) {
  if (jumps_again(counts, dt_ms, p)) return kStalled;
  const uint16_t size = static_cast<uint16_t>(duty < 0 ? -duty : duty);
  const int8_t sign = duty > 0 ? 1 : duty < 0 ? -1 : 0;
  if (sign == 0 || static_cast<float>(size) < p.dead_band * static_cast<float>(wire::kFullDuty)) {
    sign_ = 0;
    return kGood;
  }
  if (sign != sign_) {
    sign_ = sign;
    start_counts_ = counts;
    best_counts_ = counts;
    standing_ms_ = 0;
    step_counts_ = counts;
    step_duty_ms_ = 0;
    step_ms_ = 0;
    missing_m_ = 0.0f;
    return kGood;
  }
  if (distance(counts, best_counts_) * sign > 0) best_counts_ = counts;
  // In counts, and only if it may be: a float operation takes an AVR a hundred cycles and more.
  const int32_t back = -distance(counts, best_counts_) * sign;
  if (back > 0) {
    const float furthest_m = kRunOnM + kRunOnS * p.max_track_mps;
    if (static_cast<float>(back) > furthest_m * p.counts_per_metre) return kReversed;
  }

  if (missing(size, sign, counts, dt_ms, p)) return kStalled;
  const bool pushes = p.stall_duty > 0 && size >= p.stall_duty;
  const float moved = static_cast<float>(distance(counts, start_counts_));
  if (!pushes || magnitude(moved) > kStandingM * p.counts_per_metre) {
    start_counts_ = counts;
    standing_ms_ = 0;
    return kGood;
  }
  standing_ms_ = static_cast<uint16_t>(standing_ms_ + dt_ms);
  return standing_ms_ >= p.stall_ms ? kStalled : kGood;
}

bool BeltWatch::jumps_again(int32_t counts, uint16_t dt_ms, const wire::Parameters& p) {
  const int32_t moved = known_ ? distance(counts, last_counts_) : 0;
  known_ = true;
  last_counts_ = counts;
  jumped_ms_ = jumped_ms_ > dt_ms ? static_cast<uint16_t>(jumped_ms_ - dt_ms) : 0;
  if (moved > -kFewCounts && moved < kFewCounts) return false;
  const float furthest_m = kJumpM + 2e-3f * p.max_track_mps * static_cast<float>(dt_ms);
  if (magnitude(static_cast<float>(moved)) <= furthest_m * p.counts_per_metre) return false;
  if (jumped_ms_ == 0) jumped_ms_ = kJumpAgainMs;
  return jumped_ms_ < kJumpAgainMs - kOneJumpMs;
}

bool BeltWatch::missing(uint16_t size, int8_t sign, int32_t counts, uint16_t dt_ms,
                        const wire::Parameters& p) {
  if (p.stall_duty == 0 || p.feed_forward <= 0.0f) return false;
  step_duty_ms_ += static_cast<uint32_t>(size) * dt_ms;
  step_ms_ = static_cast<uint16_t>(step_ms_ + dt_ms);
  if (step_ms_ < kStepMs) return false;
  const float step_ms = static_cast<float>(step_ms_);
  const float duty_ms = static_cast<float>(step_duty_ms_) * 1e-3f;
  const float moved_m =
      static_cast<float>(distance(counts, step_counts_) * sign) / p.counts_per_metre;
  step_counts_ = counts;
  step_duty_ms_ = 0;
  step_ms_ = 0;
  const float meant_m = (duty_ms - (p.dead_band + kLoadDuty) * step_ms) * 1e-3f / p.feed_forward;
  const float most_m = kMissingM / (kSoonestMs * static_cast<float>(p.stall_ms)) * step_ms;
  missing_m_ = larger(0.0f, missing_m_ + smaller(meant_m - kSpeedShare * moved_m, most_m));
  return missing_m_ > kMissingM;
}

}  // namespace firmware
}  // namespace tp100
