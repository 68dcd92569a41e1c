#include "track_monitor.h"

#include "shared/skid_steer.h"

namespace tp100 {
namespace firmware {
namespace {

using shared::between;
using shared::larger;
using shared::magnitude;
using shared::smaller;
using shared::wrapped_difference;

typedef shared::RobotLimits<float> Limits;

const float kStandingM = 0.002f;
// A braking track runs on against its duty for a while; beyond this distance the wiring is wrong.
const float kRunOnM = 0.02f;
const float kRunOnS = 0.2f;

// Between two samples, no track moves this far beyond what its top speed allows, nor does a
// track that has followed its duty go back this far: such counts are a glitch.
const float kJumpM = 0.004f;
const int32_t kFewCounts = 8;

const uint8_t kStepSamples = 16;

const uint8_t kTurnSamples = 8;
constexpr float kTurnStepS = 1e-6f * kTurnSamples * wire::kSamplePeriodUs;
const float kGravityMps2 = 9.80665f;
// A glitch moves counts further.
const int32_t kMostSpeedingUp = 20000;

// Difference of the tracks' speeds relative to the faster one, where the wheelbase begins to
// change, where it is that of tight arcs, and where it is that of the spot.
const float kWideArc = 0.35f;
const float kTightArc = 0.65f;
const float kSpin = 1.3f;
// Counts of few samples are coarse: they are low-pass filtered with a time constant of 0.1 s.
const float kSpeedShare = 0.33f;

const float kSlowestRad = 0.003f;

constexpr float kFullDuty = static_cast<float>(wire::kFullDuty);

// Extra duty for a slope or bump relative to the robot's attitude at rest, in thousandths. It rises
// at once and decays slowly. Slopes are sums of accel_x over a step: an angle is its gravity.
constexpr int32_t slope_x(float rad) {
  return static_cast<int32_t>(rad * wire::kAccelLsbPerG * kTurnSamples);
}
const int32_t kLevelX = slope_x(0.02f);
const int32_t kSlopeFall = static_cast<int32_t>(0.15f * kTurnStepS * kFullDuty);
const int32_t kMaxSlopeLoad = static_cast<int32_t>(shared::obstacle_duty<float>() * kFullDuty);
const int32_t kLoadPerRad = static_cast<int32_t>(Limits::duty_per_slope_rad() * kFullDuty);

int32_t whole(float value) { return static_cast<int32_t>(value); }
int32_t size_of(int32_t value) { return value < 0 ? -value : value; }

// Equivalent wheelbase for tracks whose ground sides move at these speeds, in any unit.
float wheelbase_m(float left, float right, const wire::Parameters& p) {
  const float faster = larger(magnitude(left), magnitude(right));
  const float turn = magnitude(right - left);
  if (turn <= kWideArc * faster) return p.wheelbase_m;
  if (turn <= kTightArc * faster)
    return between(turn / faster, kWideArc, kTightArc, p.wheelbase_m, p.wheelbase_tight_m);
  return between(turn / faster, kTightArc, kSpin, p.wheelbase_tight_m, p.wheelbase_spin_m);
}

}  // namespace

MonitorValues::MonitorValues(const wire::Parameters& p)
    : metres_per_count(1.0f / p.counts_per_metre),
      turn_per_count(metres_per_count / p.wheelbase_m),
      dead_band(static_cast<int16_t>(whole(p.dead_band * kFullDuty))),
      run_on_counts(whole((kRunOnM + kRunOnS * p.max_track_mps) * p.counts_per_metre)),
      jump_counts(whole(kJumpM * p.counts_per_metre)),
      counts_per_ms_q8(
          whole(256.0f * Limits::jump_speeds() * 1e-3f * p.max_track_mps * p.counts_per_metre)),
      standing_counts(whole(kStandingM * p.counts_per_metre)),
      accel_x_per_count(whole(kTurnSamples * wire::kAccelLsbPerG * metres_per_count /
                              (kGravityMps2 * kTurnStepS * kTurnStepS))) {}

void DutySteps::restart() {
  monitor_.restart();
  left_ = first_;
  known_ = false;
  from_counts_ = 0;
  duty_ms_ = 0;
  ms_ = 0;
}

bool DutySteps::update(int16_t duty, int32_t counts, uint8_t dt_ms, int16_t load, bool free,
                       const MonitorValues& values, const wire::Parameters& p) {
  if (!known_) from_counts_ = counts;
  known_ = true;
  duty_ms_ += static_cast<int32_t>(duty) * dt_ms;
  ms_ = static_cast<uint16_t>(ms_ + dt_ms);
  if (--left_ > 0) return false;
  const float per_s = 1e3f / static_cast<float>(ms_);
  const float step_s = 1e-3f * static_cast<float>(ms_);
  const float mean_duty = static_cast<float>(duty_ms_) * 1e-6f * per_s;
  const float mps = static_cast<float>(wrapped_difference(counts, from_counts_)) *
                    values.metres_per_count * per_s;
  left_ = kStepSamples;
  from_counts_ = counts;
  duty_ms_ = 0;
  ms_ = 0;
  if (p.stall_duty == 0) return false;
  const float load_duty = static_cast<float>(load) * 1e-3f;
  return monitor_.update(mean_duty, mps, load_duty, free, step_s, p.dead_band, p.feed_forward,
                         Limits::soonest_share() * 1e-3f * static_cast<float>(p.stall_ms));
}

TrackMonitor::TrackMonitor(uint8_t first) : steps_(first) { restart(); }

void TrackMonitor::restart() {
  steps_.restart();
  known_ = false;
  last_counts_ = 0;
  jumps_ = shared::JumpMemory<uint16_t, 1>();
  sign_ = 0;
  start_counts_ = 0;
  standing_ms_ = 0;
  first_counts_ = 0;
  best_counts_ = 0;
  went_back_ = false;
}

TrackMonitor::Verdict TrackMonitor::update(int16_t duty, int32_t counts, uint8_t dt_ms,
                                           int16_t load, bool free, const MonitorValues& values,
                                           const wire::Parameters& p) {
  const bool missing = steps_.update(duty, counts, dt_ms, load, free, values, p);
  if (jumps_again(counts, dt_ms, values) || missing) return kStalled;
  const int16_t size = duty < 0 ? static_cast<int16_t>(-duty) : duty;
  const int8_t sign = duty > 0 ? 1 : duty < 0 ? -1 : 0;
  if (sign == 0 || size < values.dead_band) {
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
    return kGood;
  }
  const int32_t forth = sign > 0 ? wrapped_difference(counts, best_counts_)
                                 : wrapped_difference(best_counts_, counts);
  if (forth > 0) {
    best_counts_ = counts;
    went_back_ = false;
  } else if (forth < 0) {
    if (-forth > values.run_on_counts) return kReversed;
    if (goes_back_again(size, counts, -forth, load, values)) return kStalled;
  }
  const int32_t moved = wrapped_difference(counts, start_counts_);
  const bool pushes = p.stall_duty > 0 && static_cast<uint16_t>(size) >= p.stall_duty;
  if (!pushes || size_of(moved) > values.standing_counts) {
    start_counts_ = counts;
    standing_ms_ = 0;
    return kGood;
  }
  standing_ms_ = static_cast<uint16_t>(standing_ms_ + dt_ms);
  return standing_ms_ >= p.stall_ms ? kStalled : kGood;
}

bool TrackMonitor::goes_back_again(int16_t size, int32_t counts, int32_t back, int16_t load,
                                   const MonitorValues& values) {
  const int32_t driven = wrapped_difference(best_counts_, first_counts_);
  const bool ran = (sign_ > 0 ? driven : -driven) > values.jump_counts;
  if (ran && !went_back_ && back > values.jump_counts) {
    went_back_ = true;
    if (jumps_.again()) return true;
  }
  // A slope or turn may move a track slowly against its duty while the speed loop brakes it.
  if (load > 0 && size < values.dead_band + load) best_counts_ = counts;
  return false;
}

bool TrackMonitor::jumps_again(int32_t counts, uint8_t dt_ms, const MonitorValues& values) {
  const int32_t moved = known_ ? wrapped_difference(counts, last_counts_) : 0;
  known_ = true;
  last_counts_ = counts;
  jumps_.pass(dt_ms);
  if (moved > -kFewCounts && moved < kFewCounts) return false;
  const int32_t furthest = values.jump_counts + (values.counts_per_ms_q8 * dt_ms >> 8);
  return size_of(moved) > furthest && jumps_.again();
}

TurnMonitor::TurnMonitor() : then_(), level_q4_(0), level_known_(false) { restart(); }

void TurnMonitor::restart() {
  balance_.restart();
  turn_duty_ = shared::TurnDuty<float, Limits>();
  slope_x_ = 0;
  slope_load_ = 0;
  load_ = 0;
  left_ = 0.0f;
  right_ = 0.0f;
  accel_x_ = 0;
  both_counts_ = 0;
  samples_ = 0;
}

bool TurnMonitor::free() const {
  return load_ < static_cast<int16_t>(Limits::free_duty() * kFullDuty);
}

void TurnMonitor::rest(int16_t accel_x) {
  if (!level_known_) level_q4_ = static_cast<int32_t>(accel_x) * 16;
  level_known_ = true;
  level_q4_ += accel_x - level_q4_ / 16;
}

TurnMonitor::Verdict TurnMonitor::update(const TurnMark& now, int16_t accel_x, float bias_radps,
                                         const MonitorValues& values, const wire::Parameters& p) {
  if (!level_known_) rest(accel_x);
  if (samples_ == 0) {
    then_ = now;
  } else {
    accel_x_ += accel_x;
  }
  if (samples_++ < kTurnSamples) return kGood;
  samples_ = 1;
  const float gyro_rad = turned(then_, now, true, bias_radps, p);
  const int32_t left = wrapped_difference(now.left_counts, then_.left_counts);
  const int32_t right = wrapped_difference(now.right_counts, then_.right_counts);
  const shared::TrackPair<float> ground = shared::over_ground(
      static_cast<float>(left), static_cast<float>(right), p.slip_left, p.slip_right);
  left_ += (ground.left - left_) * kSpeedShare;
  right_ += (ground.right - right_) * kSpeedShare;
  const float track_rad =
      shared::turn_of(ground, wheelbase_m(left_, right_, p)) * values.metres_per_count;
  const int32_t both = size_of(left) + size_of(right);
  const float elapsed_s =
      static_cast<float>(wrapped_difference(now.device_us, then_.device_us)) * 1e-6f;
  then_ = now;
  const float driven_rad = 0.5f * static_cast<float>(both) * values.turn_per_count;
  const int32_t speeding_up = (left + right - both_counts_) / 2;
  both_counts_ = left + right;
  weigh(magnitude(gyro_rad), driven_rad, elapsed_s,
        smaller(kMostSpeedingUp, larger(-kMostSpeedingUp, speeding_up)) * values.accel_x_per_count);
  const float slip_rad =
      shared::slip_of_turn<float, Limits>(p.turn_slip_share, slope_load_ > 0, gyro_rad, driven_rad);
  if (!balance_.update(gyro_rad, track_rad, slip_rad, elapsed_s)) return kGood;
  // In a turn on the spot, the track that counts less is the faulty one.
  if ((left_ > 0.0f) != (right_ > 0.0f))
    return magnitude(left_) < magnitude(right_) ? kLeftShort : kRightShort;
  // Driving forward, a robot that turns further left than its tracks indicate has a right track
  // that counts too little.
  return balance_.leftward() == (left_ > 0.0f) ? kRightShort : kLeftShort;
}

void TurnMonitor::weigh(float turn_rad, float driven_rad, float elapsed_s, int32_t speeding_up_x) {
  const float turn_duty =
      turn_duty_.update(0.5f * turn_rad / larger(driven_rad, kSlowestRad), elapsed_s);
  int32_t now_x = accel_x_ - level_q4_ * kTurnSamples / 16;
  accel_x_ = 0;
  // A robot that speeds up on the level is on no slope.
  if ((now_x > 0) == (speeding_up_x > 0)) now_x = shared::drained(now_x, size_of(speeding_up_x));
  slope_x_ += (now_x - slope_x_) / 2;
  const int32_t slope_load =
      smaller(kMaxSlopeLoad, (size_of(slope_x_) - kLevelX) * kLoadPerRad / slope_x(1.0f));
  const int32_t fallen_load = larger(slope_load_ - kSlopeFall, INT32_C(0));
  slope_load_ = static_cast<int16_t>(larger(slope_load, fallen_load));
  load_ = static_cast<int16_t>(slope_load_ + whole(turn_duty * kFullDuty));
}

}  // namespace firmware
}  // namespace tp100
