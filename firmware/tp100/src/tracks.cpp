#include "tracks.h"

#include "number.h"

namespace tp100 {
namespace firmware {
namespace {

// Below this load a track runs freely.
const float kFreeDuty = 0.05f;

}  // namespace

void Tracks::restart() {
  left_.loop.restart();
  right_.loop.restart();
}

void Tracks::begin() {
  stop();
  target_ = TrackSpeeds();
  left_.monitor.reset();
  right_.monitor.reset();
  mean_monitor_.reset();
  turn_monitor_.reset();
}

void Tracks::stop() {
  fail_safe_.disable();
  left_.loop.reset();
  right_.loop.reset();
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
  left_.counts = has(wire::kInvertLeftEncoder) ? distance(INT32_C(0), left) : left;
  right_.counts = has(wire::kInvertRightEncoder) ? distance(INT32_C(0), right) : right;
  return now_us;
}

void Tracks::measure(uint16_t dt_us) {
  left_.loop.measure(left_.counts, dt_us, parameters_);
  right_.loop.measure(right_.counts, dt_us, parameters_);
}

Tracks::Verdicts Tracks::check(uint16_t dt_ms) {
  const float slope_duty = turn_monitor_.slope_duty();
  const float load_duty = slope_duty + turn_monitor_.turn_duty();
  const bool free = load_duty < kFreeDuty;
  Verdicts found;
  found.left = left_.monitor.update(left_.duty, left_.counts, dt_ms, load_duty, free, parameters_);
  found.right =
      right_.monitor.update(right_.duty, right_.counts, dt_ms, load_duty, free, parameters_);
  // In a turn, one track takes more duty and the other as much less: their mean shows a stall.
  const int16_t mean_duty = static_cast<int16_t>((left_.duty + right_.duty) / 2);
  const int32_t mean_counts = distance(left_.counts, distance(left_.counts, right_.counts) / 2);
  const TrackMonitor::Verdict mean =
      mean_monitor_.update(mean_duty, mean_counts, dt_ms, slope_duty, free, parameters_);
  const bool good = found.left == TrackMonitor::kGood && found.right == TrackMonitor::kGood;
  if (mean != TrackMonitor::kStalled || !good) return found;
  const float left_m = left_.monitor.missing_m();
  const float right_m = right_.monitor.missing_m();
  if (left_m >= 0.5f * right_m) found.left = TrackMonitor::kStalled;
  if (right_m >= 0.5f * left_m) found.right = TrackMonitor::kStalled;
  return found;
}

Tracks::Verdicts Tracks::check_turn(const TurnMark& now, int16_t accel_x, float bias_radps) {
  const TurnMonitor::Verdict verdict = turn_monitor_.update(now, accel_x, bias_radps, parameters_);
  Verdicts found = {TrackMonitor::kGood, TrackMonitor::kGood};
  if (verdict == TurnMonitor::kLeftShort) found.left = TrackMonitor::kStalled;
  if (verdict == TurnMonitor::kRightShort) found.right = TrackMonitor::kStalled;
  return found;
}

void Tracks::drive(const TrackSpeeds& wanted, uint16_t dt_us) {
  const float dt_s = static_cast<float>(dt_us) * 1e-6f;
  target_ = approach(target_, wanted, parameters_.max_track_mps2 * dt_s);
  const float full = static_cast<float>(wire::kFullDuty);
  const float left = left_.loop.update(target_.left, dt_s, parameters_) * full;
  const float right = right_.loop.update(target_.right, dt_s, parameters_) * full;
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
