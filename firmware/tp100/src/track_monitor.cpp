#include "track_monitor.h"

#include "number.h"

namespace tp100 {
namespace firmware {
namespace {

const float kStandingM = 0.002f;
// A braking track runs on against its duty for a while; beyond this distance the wiring is wrong.
const float kRunOnM = 0.02f;
const float kRunOnS = 0.2f;

// Between two samples, no track moves this far beyond what twice its top speed allows, nor does a
// track that has followed its duty go back this far: such counts are a glitch. Only a single short
// glitch is tolerated; another one between kOneJumpMs and kJumpAgainMs later is a fault.
const float kJumpM = 0.004f;
const int32_t kFewCounts = 8;
const uint16_t kJumpAgainMs = 1000;
const uint16_t kOneJumpMs = 100;

// Limit of the distance that the duty implies beyond what was counted. A blocked track takes at
// least this share of `stall_ms` to reach it, however high its duty.
const float kMissingM = 0.04f;
const float kSoonestShare = 0.7f;
const uint16_t kStepMs = 80;
// Duty that a track may take beyond its usual one.
const float kMarginDuty = 0.02f;
const float kMarginShare = 0.1f;

// The gain (duty that a track takes) is learned while the track runs freely, evenly and not too
// slowly: quickly downwards, but upwards only as fast as a battery sags, or a fault would be
// learned.
const float kMinGain = 0.7f;
const float kGainDownPerS = 3.0f;
const float kGainUpPerS = 0.005f;
// At a higher speed, friction takes a smaller share of the duty: the gain holds only up to this
// multiple of the speed at which it was learned.
const float kBeyond = 1.25f;
const float kSlowPerS = 4.0f;
const float kSlowest = 0.95f;
const float kFastest = 1.1f;
const float kMinMps = 0.028f;

// Float operations are slow on an AVR: eight samples make one step.
const uint8_t kSamples = 8;
const float kMaxRad = 0.35f;
const float kMaxSlowRad = 0.175f;
const float kSlowRadps = 0.175f;
const float kDistanceShare = 0.1f;
// On a slope or an obstacle one track may slip while the other grips.
const float kObstacleShare = 0.8f;

// Difference of the tracks' speeds relative to the faster one, where the wheelbase begins to
// change, where it is that of tight arcs, and where it is that of the spot.
const float kWideArc = 0.35f;
const float kTightArc = 0.65f;
const float kSpin = 1.3f;
// Counts of few samples are coarse: they are low-pass filtered with a time constant of 0.1 s.
const float kSpeedShare = 0.33f;

// Extra duty for a turn, and for a slope or bump relative to the robot's attitude at the start.
// Loads rise at once and decay slowly.
const float kTurnDuty = 0.3f;
const float kTurnFallPerS = 0.3f;
// Track speed due to the turn alone, as a fraction of the mean speed, from which on a turn takes
// half and all of its duty: the resistance against turning falls slowly with the radius.
const float kHalfTurning = 0.12f;
const float kFullTurning = 0.4f;
const float kSlowestRad = 0.003f;
const float kMaxSlopeDuty = 0.4f;
const float kSlopeFallPerS = 0.15f;
const float kDutyPerRad = 3.0f;
const float kLevelRad = 0.02f;
const float kNewSlope = 0.5f;

float drained(float balance, float by) {
  if (balance > by) return balance - by;
  if (balance < -by) return balance + by;
  return 0.0f;
}

// Interpolates from `a` to `b` while `value` goes from `low` to `high`.
float between(float value, float low, float high, float a, float b) {
  const float share = (value - low) / (high - low);
  return a + (b - a) * larger(0.0f, smaller(1.0f, share));
}

// Equivalent wheelbase for tracks whose ground sides move at these speeds, in any unit.
float wheelbase_m(float left, float right, const wire::Parameters& p) {
  const float faster = larger(magnitude(left), magnitude(right));
  const float turn = faster > 0.0f ? magnitude(right - left) / faster : 0.0f;
  if (turn <= kTightArc)
    return between(turn, kWideArc, kTightArc, p.wheelbase_m, p.wheelbase_tight_m);
  return between(turn, kTightArc, kSpin, p.wheelbase_tight_m, p.wheelbase_spin_m);
}

}  // namespace

// Not in the class: copies of it in its callers would take 200 bytes of flash.
TrackMonitor::TrackMonitor() = default;

void TrackMonitor::reset() { *this = TrackMonitor(); }

TrackMonitor::Verdict TrackMonitor::update(int16_t duty, int32_t counts, uint16_t dt_ms,
                                           float load_duty, bool free, const wire::Parameters& p) {
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
  // Compared in counts, and only when needed: a float operation takes an AVR a hundred cycles.
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
    // A slope or turn may move a track slowly against its duty while the speed loop brakes it.
    const float explained = (p.dead_band + load_duty) * static_cast<float>(wire::kFullDuty);
    if (load_duty > 0.0f && static_cast<float>(size) < explained) best_counts_ = counts;
  }

  if (missing(size, sign, counts, dt_ms, load_duty, free, p)) return kStalled;
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

bool TrackMonitor::jumps_again(int32_t counts, uint16_t dt_ms, const wire::Parameters& p) {
  const int32_t moved = known_ ? distance(counts, last_counts_) : 0;
  known_ = true;
  last_counts_ = counts;
  jumped_ms_ = jumped_ms_ > dt_ms ? static_cast<uint16_t>(jumped_ms_ - dt_ms) : 0;
  if (moved > -kFewCounts && moved < kFewCounts) return false;
  const float furthest_m = kJumpM + 2e-3f * p.max_track_mps * static_cast<float>(dt_ms);
  return magnitude(static_cast<float>(moved)) > furthest_m * p.counts_per_metre && again();
}

bool TrackMonitor::again() {
  if (jumped_ms_ == 0) jumped_ms_ = kJumpAgainMs;
  return jumped_ms_ < kJumpAgainMs - kOneJumpMs;
}

bool TrackMonitor::missing(uint16_t size, int8_t sign, int32_t counts, uint16_t dt_ms,
                           float load_duty, bool free, const wire::Parameters& p) {
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
  const float beyond = larger(0.0f, speed_duty - kBeyond * learned_duty_);
  const float usual = gain_ * (speed_duty - beyond) + kMaxGain * beyond;
  const float unexplained = above - (1.0f + kMarginShare) * usual - kMarginDuty - load_duty;
  const float most_mps = kMissingM * 1e3f / (kSoonestShare * static_cast<float>(p.stall_ms));
  missing_m_ = larger(0.0f, missing_m_ + smaller(unexplained / p.feed_forward, most_mps) * step_s);
  slow_duty_ += (speed_duty - slow_duty_) * smaller(1.0f, kSlowPerS * step_s);
  if (free) learn(above, speed_duty, load_duty, step_s, p);
  return missing_m_ > kMissingM;
}

void TrackMonitor::learn(float above, float speed_duty, float load_duty, float step_s,
                         const wire::Parameters& p) {
  const bool even = speed_duty > kMinMps * p.feed_forward && speed_duty > kSlowest * slow_duty_ &&
                    speed_duty < kFastest * slow_duty_;
  if (!even) return;
  // A small load may act on this track or on the other, so that a sample yields only a range: a
  // gain within it is kept.
  const float least = smaller(kMaxGain, larger(kMinGain, (above - load_duty) / speed_duty));
  const float most = smaller(kMaxGain, larger(kMinGain, (above + load_duty) / speed_duty));
  const float gain = most < gain_ ? most : larger(least, gain_);
  const float towards = smaller(1.0f, kGainDownPerS * step_s);
  if (gain < gain_) {
    gain_ += (gain - gain_) * towards;
    learned_duty_ += (speed_duty - learned_duty_) * towards;
  } else if (speed_duty > kBeyond * learned_duty_) {
    const float before = learned_duty_;
    learned_duty_ += (speed_duty - learned_duty_) * towards;
    gain_ = gain + (gain_ - gain) * before / learned_duty_;
  } else {
    gain_ += smaller(gain - gain_, kGainUpPerS * step_s);
  }
}

void TurnMonitor::reset() { *this = TurnMonitor(); }

TurnMonitor::Verdict TurnMonitor::update(const TurnMark& now, int16_t accel_x, float bias_radps,
                                         const wire::Parameters& p) {
  if (samples_ == 0) {
    then_ = now;
  } else {
    accel_x_ += accel_x;
  }
  if (samples_++ < kSamples) return kGood;
  samples_ = 1;
  const float gyro_rad = turned(then_, now, true, bias_radps, p);
  const int32_t left = distance(now.left_counts, then_.left_counts);
  const int32_t right = distance(now.right_counts, then_.right_counts);
  const float left_ground = static_cast<float>(left) * (1.0f - p.slip_left);
  const float right_ground = static_cast<float>(right) * (1.0f - p.slip_right);
  left_ += (left_ground - left_) * kSpeedShare;
  right_ += (right_ground - right_) * kSpeedShare;
  const float difference = gyro_rad - (right_ground - left_ground) /
                                          (p.counts_per_metre * wheelbase_m(left_, right_, p));
  const int32_t both = (left < 0 ? -left : left) + (right < 0 ? -right : right);
  const float elapsed_s = static_cast<float>(distance(now.device_us, then_.device_us)) * 1e-6f;
  then_ = now;
  const float driven_rad = 0.5f * static_cast<float>(both) / (p.counts_per_metre * p.wheelbase_m);
  weigh(magnitude(gyro_rad), driven_rad, elapsed_s);
  const float share =
      slope_duty_ > 0.0f ? larger(p.turn_slip_share, kObstacleShare) : p.turn_slip_share;
  const float slip_rad = share * magnitude(gyro_rad) + kDistanceShare * driven_rad;
  all_rad_ = drained(all_rad_ + difference, slip_rad);
  slow_rad_ = drained(slow_rad_ + clamp(difference, kSlowRadps * elapsed_s), slip_rad);
  if (magnitude(all_rad_) <= kMaxRad && magnitude(slow_rad_) <= kMaxSlowRad) return kGood;
  // In a turn on the spot, the track that counts less is the faulty one.
  if ((left_ > 0.0f) != (right_ > 0.0f))
    return magnitude(left_) < magnitude(right_) ? kLeftShort : kRightShort;
  // Driving forward, a robot that turns further left than its tracks indicate has a right track
  // that counts too little.
  const float left_turn = magnitude(all_rad_) > kMaxRad ? all_rad_ : slow_rad_;
  return (left_turn > 0.0f) == (left_ > 0.0f) ? kRightShort : kLeftShort;
}

void TurnMonitor::weigh(float turn_rad, float driven_rad, float elapsed_s) {
  const float turning = 0.5f * turn_rad / larger(driven_rad, kSlowestRad);
  const float share = turning < kHalfTurning
                          ? between(turning, 0.0f, kHalfTurning, 0.0f, 0.5f)
                          : between(turning, kHalfTurning, kFullTurning, 0.5f, 1.0f);
  turn_duty_ = larger(kTurnDuty * share, turn_duty_ - kTurnFallPerS * elapsed_s);
  const float pitch_rad = static_cast<float>(accel_x_) * (1.0f / (wire::kAccelLsbPerG * kSamples));
  accel_x_ = 0;
  if (!level_known_) level_rad_ = pitch_rad;
  level_known_ = true;
  slope_rad_ += (pitch_rad - level_rad_ - slope_rad_) * kNewSlope;
  const float slope_duty =
      smaller(kMaxSlopeDuty, kDutyPerRad * (magnitude(slope_rad_) - kLevelRad));
  slope_duty_ = larger(larger(0.0f, slope_duty), slope_duty_ - kSlopeFallPerS * elapsed_s);
}

}  // namespace firmware
}  // namespace tp100
