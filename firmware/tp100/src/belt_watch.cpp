#include "belt_watch.h"

#include "number.h"

namespace tp100 {
namespace firmware {
namespace {

const float kStandingM = 0.002f;
// A belt that brakes runs on against its duty for a while: more than this far is wiring.
const float kRunOnM = 0.02f;
const float kRunOnS = 0.2f;

// So far no belt moves between two samples, beyond twice its fastest: counts from nowhere. Nor does
// one that ran on under its duty go back so far. A glitch comes alone, and is over soon.
const float kJumpM = 0.004f;
const int32_t kFewCounts = 8;
const uint16_t kJumpAgainMs = 1000;
const uint16_t kOneJumpMs = 100;

// Distance that the duty means beyond what was counted. A belt that is held takes this part of the
// time that `stall_ms` allows, whatever its duty.
const float kMissingM = 0.04f;
const float kSoonestShare = 0.7f;
const uint16_t kStepMs = 80;
// Duty that a belt may take beyond what it usually does.
const float kMarginDuty = 0.02f;
const float kMarginShare = 0.1f;

// How much duty a belt takes is learnt while it runs freely and evenly and is no creep: quickly
// downwards, upwards only as a battery sags, or a fault would be learnt. More than the most is none
// of it, and is what a run begins with.
const float kLeastGain = 0.7f;
const float kMostGain = 1.4f;
const float kGainDownPerS = 3.0f;
const float kGainUpPerS = 0.005f;
const float kSlowPerS = 4.0f;
const float kSlowest = 0.95f;
const float kFastest = 1.1f;
const float kLeastMps = 0.028f;
const float kFreeDuty = 0.05f;

}  // namespace

BeltWatch::BeltWatch()
    : known_(false),
      last_counts_(0),
      jumped_ms_(0),
      sign_(0),
      start_counts_(0),
      standing_ms_(0),
      first_counts_(0),
      best_counts_(0),
      went_back_(false),
      step_counts_(0),
      step_duty_ms_(0),
      step_ms_(0),
      missing_m_(0.0f),
      gain_(kMostGain),
      slow_duty_(0.0f) {}

void BeltWatch::reset() { *this = BeltWatch(); }

BeltWatch::Verdict BeltWatch::update(int16_t duty, int32_t counts, uint16_t dt_ms, float load_duty,
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
    first_counts_ = counts;
    best_counts_ = counts;
    went_back_ = false;
    standing_ms_ = 0;
    step_counts_ = counts;
    step_duty_ms_ = 0;
    step_ms_ = 0;
    missing_m_ = 0.0f;
    return kGood;
  }
  if (distance(counts, best_counts_) * sign > 0) {
    best_counts_ = counts;
    went_back_ = false;
  }
  // In counts, and only if it may be: a float operation takes an AVR a hundred cycles and more.
  const int32_t back = -distance(counts, best_counts_) * sign;
  if (back > 0) {
    const float furthest_m = kRunOnM + kRunOnS * p.max_track_mps;
    if (static_cast<float>(back) > furthest_m * p.counts_per_metre) return kReversed;
    const float jump = kJumpM * p.counts_per_metre;
    const bool ran = static_cast<float>(distance(best_counts_, first_counts_) * sign) > jump;
    if (ran && !went_back_ && static_cast<float>(back) > jump) {
      went_back_ = true;
      if (again()) return kStalled;
    }
  }

  if (missing(size, sign, counts, dt_ms, load_duty, p)) return kStalled;
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
  return magnitude(static_cast<float>(moved)) > furthest_m * p.counts_per_metre && again();
}

bool BeltWatch::again() {
  if (jumped_ms_ == 0) jumped_ms_ = kJumpAgainMs;
  return jumped_ms_ < kJumpAgainMs - kOneJumpMs;
}

bool BeltWatch::missing(uint16_t size, int8_t sign, int32_t counts, uint16_t dt_ms, float load_duty,
                        const wire::Parameters& p) {
  if (p.stall_duty == 0 || p.feed_forward <= 0.0f) return false;
  step_duty_ms_ += static_cast<uint32_t>(size) * dt_ms;
  step_ms_ = static_cast<uint16_t>(step_ms_ + dt_ms);
  if (step_ms_ < kStepMs) return false;
  const float step_s = static_cast<float>(step_ms_) * 1e-3f;
  const float above = static_cast<float>(step_duty_ms_) * 1e-6f / step_s - p.dead_band;
  const int32_t moved = distance(counts, step_counts_) * sign;
  const float speed_duty =
      moved <= 0 ? 0.0f
                 : p.feed_forward * static_cast<float>(moved) / (p.counts_per_metre * step_s);
  step_counts_ = counts;
  step_duty_ms_ = 0;
  step_ms_ = 0;
  const float unexplained =
      above - (1.0f + kMarginShare) * gain_ * speed_duty - kMarginDuty - load_duty;
  const float most_mps = kMissingM * 1e3f / (kSoonestShare * static_cast<float>(p.stall_ms));
  missing_m_ = larger(0.0f, missing_m_ + smaller(unexplained / p.feed_forward, most_mps) * step_s);
  slow_duty_ += (speed_duty - slow_duty_) * smaller(1.0f, kSlowPerS * step_s);
  if (load_duty < kFreeDuty) learn(above, speed_duty, step_s, p);
  return missing_m_ > kMissingM;
}

void BeltWatch::learn(float above, float speed_duty, float step_s, const wire::Parameters& p) {
  const bool even = speed_duty > kLeastMps * p.feed_forward && speed_duty > kSlowest * slow_duty_ &&
                    speed_duty < kFastest * slow_duty_;
  if (!even) return;
  const float gain = smaller(kMostGain, larger(kLeastGain, above / speed_duty));
  gain_ += gain < gain_ ? (gain - gain_) * smaller(1.0f, kGainDownPerS * step_s)
                        : smaller(gain - gain_, kGainUpPerS * step_s);
}

}  // namespace firmware
}  // namespace tp100
