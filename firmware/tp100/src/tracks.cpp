#include "tracks.h"

#include "shared/number.h"

namespace tp100 {
namespace firmware {
namespace {

using shared::wrapped_difference;

// The monitors' float work is spread over the samples: steps of 16 samples end in these, and the
// turn monitor, which judges every eighth, begins in the last.
const uint8_t kLeftFirst = 16;
const uint8_t kRightFirst = 13;
const uint8_t kMeanFirst = 10;
const uint8_t kTurnPhase = 7;
const uint8_t kTurnPhases = 8;

}  // namespace

Tracks::Tracks(Hal& hal, FailSafe& fail_safe, const wire::Parameters& parameters)
    : hal_(hal),
      fail_safe_(fail_safe),
      parameters_(parameters),
      left_(kLeftFirst),
      right_(kRightFirst),
      mean_steps_(kMeanFirst) {}

void Tracks::restart() {
  values_ = MonitorValues(parameters_);
  gains_ = SpeedGains(parameters_);
  skid_steer_ = shared::SkidSteer<float>(parameters_.wheelbase_m, parameters_.slip_left,
                                         parameters_.slip_right, parameters_.max_track_mps);
}

void Tracks::begin() {
  stop();
  target_ = TrackSpeeds();
  left_.monitor.restart();
  right_.monitor.restart();
  mean_steps_.restart();
  turn_monitor_.restart();
  phase_ = 0;
}

void Tracks::stop() {
  fail_safe_.disable();
  left_.loop.clear();
  right_.loop.clear();
  left_.duty = 0;
  right_.duty = 0;
}

uint32_t Tracks::read() {
  const CriticalSection section(hal_);
  int32_t left = 0;
  int32_t right = 0;
  const uint32_t now_us = hal_.micros();
  hal_.counts(left, right);
  if (has(wire::kSwapTracks)) {
    const int32_t other = left;
    left = right;
    right = other;
  }
  left_.counts = has(wire::kInvertLeftEncoder) ? wrapped_difference(INT32_C(0), left) : left;
  right_.counts = has(wire::kInvertRightEncoder) ? wrapped_difference(INT32_C(0), right) : right;
  return now_us;
}

void Tracks::measure(const TurnHistory& history) {
  const TrackMotion motion = history.motion(values_.metres_per_count);
  left_.loop.measure(motion.left_m, motion.speeds.left);
  right_.loop.measure(motion.right_m, motion.speeds.right);
}

Tracks::Verdicts Tracks::check(uint8_t dt_ms) {
  phase_ = static_cast<uint8_t>((phase_ + 1) % kTurnPhases);
  const int16_t load = turn_monitor_.load();
  const bool free = turn_monitor_.free();
  Verdicts found;
  found.left =
      left_.monitor.update(left_.duty, left_.counts, dt_ms, load, free, values_, parameters_);
  found.right =
      right_.monitor.update(right_.duty, right_.counts, dt_ms, load, free, values_, parameters_);
  // In a turn, one track takes more duty and the other as much less: their mean shows a stall.
  const int16_t mean_duty = static_cast<int16_t>((left_.duty + right_.duty) / 2);
  const int32_t mean_counts =
      wrapped_difference(left_.counts, wrapped_difference(left_.counts, right_.counts) / 2);
  const bool missing = mean_steps_.update(mean_duty, mean_counts, dt_ms, turn_monitor_.slope_load(),
                                          free, values_, parameters_);
  const bool good = found.left == TrackMonitor::kGood && found.right == TrackMonitor::kGood;
  if (!missing || !good) return found;
  const float left_m = shared::magnitude(left_.monitor.missing_m());
  const float right_m = shared::magnitude(right_.monitor.missing_m());
  if (left_m >= 0.5f * right_m) found.left = TrackMonitor::kStalled;
  if (right_m >= 0.5f * left_m) found.right = TrackMonitor::kStalled;
  return found;
}

Tracks::Verdicts Tracks::check_turn(const TurnMark& now, int16_t accel_x, float bias_radps) {
  Verdicts found = {TrackMonitor::kGood, TrackMonitor::kGood};
  if (turn_monitor_.idle() && phase_ != kTurnPhase) return found;
  const TurnMonitor::Verdict verdict =
      turn_monitor_.update(now, accel_x, bias_radps, values_, parameters_);
  if (verdict == TurnMonitor::kLeftShort) found.left = TrackMonitor::kStalled;
  if (verdict == TurnMonitor::kRightShort) found.right = TrackMonitor::kStalled;
  return found;
}

void Tracks::drive(float speed_mps, float turn_radps, uint16_t dt_us) {
  const TrackSpeeds wanted = skid_steer_.tracks_for(speed_mps, turn_radps);
  const float dt_s = static_cast<float>(dt_us) * 1e-6f;
  target_ = approach(target_, wanted, parameters_.max_track_mps2 * dt_s);
  const float full = static_cast<float>(wire::kFullDuty);
  const float left = left_.loop.update(target_.left, dt_s, gains_) * full;
  const float right = right_.loop.update(target_.right, dt_s, gains_) * full;
  apply(static_cast<int16_t>(left), static_cast<int16_t>(right));
}

void Tracks::apply(int16_t left, int16_t right) {
  left_.duty = left;
  right_.duty = right;
  if (has(wire::kInvertLeftMotor)) left = static_cast<int16_t>(-left);
  if (has(wire::kInvertRightMotor)) right = static_cast<int16_t>(-right);
  if (has(wire::kSwapTracks)) {
    fail_safe_.drive(right, left);
  } else {
    fail_safe_.drive(left, right);
  }
}

}  // namespace firmware
}  // namespace tp100
