#include "belt_watch.h"

#include "number.h"

namespace tp100 {
namespace firmware {
namespace {

const float kStandingM = 0.002f;
// A belt that brakes runs on against its duty for a while: more than this far is wiring.
const float kRunOnM = 0.02f;
const float kRunOnS = 0.2f;

}  // namespace

BeltWatch::BeltWatch() : sign_(0), start_counts_(0), standing_ms_(0), best_counts_(0) {}

BeltWatch::Verdict BeltWatch::update(int16_t duty, int32_t counts, uint16_t dt_ms,
                                     const wire::Parameters& p) {
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
    return kGood;
  }
  if (distance(counts, best_counts_) * sign > 0) best_counts_ = counts;
  // In counts, and only if it may be: a float operation takes an AVR a hundred cycles and more.
  const int32_t back = -distance(counts, best_counts_) * sign;
  if (back > 0) {
    const float furthest_m = kRunOnM + kRunOnS * p.max_track_mps;
    if (static_cast<float>(back) > furthest_m * p.counts_per_metre) return kReversed;
  }

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

}  // namespace firmware
}  // namespace tp100
