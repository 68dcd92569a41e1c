#include "firmware.h"
#include "number.h"
#include "parameters.h"

namespace tp100 {
namespace firmware {
namespace {

using wire::Fault;
using wire::State;

const uint16_t kLongestStepUs = 50000;
const uint16_t kShortestStepUs = 1000;
// Below this load a track runs freely.
const float kFreeDuty = 0.05f;

}  // namespace

void Firmware::take_sample() {
  uint32_t now_us = 0;
  read_tracks(now_us);
  const uint32_t measured_us = now_us - sampled_us_;
  const bool usable = measured_us >= kShortestStepUs && measured_us <= kLongestStepUs;
  const uint16_t dt_us = usable ? static_cast<uint16_t>(measured_us) : kLongestStepUs;
  sampled_us_ = now_us;
  imu_.update();
  battery_.update(hal_.battery_mv(), parameters_.battery_cutoff_mv);
  if (!in_session()) return;
  ++sequence_;
  history_.add(sequence_, now_us, imu_.values().gyro[2], left_.counts, right_.counts);
  check_sensors(now_us);
  send_sample(now_us);
  drive(now_us, dt_us);
}

void Firmware::read_tracks(uint32_t& now_us) {
  const CriticalSection section(hal_);
  int32_t left = 0;
  int32_t right = 0;
  now_us = hal_.micros();
  hal_.counts(left, right);
  if (has(wire::kSwapTracks)) {
    const int32_t other = left;
    left = right;
    right = other;
  }
  left_.counts = has(wire::kInvertLeftEncoder) ? distance(INT32_C(0), left) : left;
  right_.counts = has(wire::kInvertRightEncoder) ? distance(INT32_C(0), right) : right;
}

void Firmware::check_sensors(uint32_t now_us) {
  if (uses_gyro(parameters_)) {
    if (imu_.missing()) latch(Fault::imu_missing, imu_.errors(), now_us);
    if (imu_.stale()) latch(Fault::imu_stale, imu_.errors(), now_us);
  }
  if (battery_.low()) latch(Fault::battery_low, battery_.millivolts(), now_us);
}

void Firmware::send_sample(uint32_t now_us) {
  const ImuValues& imu = imu_.values();
  wire::Sample sample = {};
  sample.sequence = sequence_;
  sample.device_us = now_us;
  sample.left_counts = left_.counts;
  sample.right_counts = right_.counts;
  memcpy(sample.gyro, imu.gyro, sizeof sample.gyro);
  memcpy(sample.accel, imu.accel, sizeof sample.accel);
  sample.temperature = imu.temperature;
  sample.battery_mv = battery_.millivolts();
  sample.left_duty = left_.duty;
  sample.right_duty = right_.duty;
  sample.state = static_cast<uint8_t>(state_);
  sample.faults = faults_;
  sample.last_command = gate_.last_sequence();
  sample.imu_age = imu_.age();
  link_.post(sample);
}

void Firmware::drive(uint32_t now_us, uint16_t dt_us) {
  left_.loop.measure(left_.counts, dt_us, parameters_);
  right_.loop.measure(right_.counts, dt_us, parameters_);
  if (!may_drive()) return;
  check_tracks(now_us, static_cast<uint16_t>((dt_us + 500) / 1000));
  check_turn(now_us);
  if (!may_drive()) return;
  const TrackSpeeds speeds = wanted(now_us);
  if (state_ == State::kArmed) return;
  const float dt_s = static_cast<float>(dt_us) * 1e-6f;
  target_ = approach(target_, speeds, parameters_.max_track_mps2 * dt_s);
  const float full = static_cast<float>(wire::kFullDuty);
  const float left = left_.loop.update(target_.left, dt_s, parameters_) * full;
  const float right = right_.loop.update(target_.right, dt_s, parameters_) * full;
  apply(static_cast<int16_t>(left), static_cast<int16_t>(right));
}

void Firmware::check_tracks(uint32_t now_us, uint16_t dt_ms) {
  const float slope_duty = turn_monitor_.slope_duty();
  const float load_duty = slope_duty + turn_monitor_.turn_duty();
  const bool free = load_duty < kFreeDuty;
  const TrackMonitor::Verdict left =
      left_.watch.update(left_.duty, left_.counts, dt_ms, load_duty, free, parameters_);
  const TrackMonitor::Verdict right =
      right_.watch.update(right_.duty, right_.counts, dt_ms, load_duty, free, parameters_);
  // In a turn, the extra duty of one track is missing on the other.
  const int16_t mean_duty = static_cast<int16_t>((left_.duty + right_.duty) / 2);
  const int32_t mean_counts = distance(left_.counts, distance(left_.counts, right_.counts) / 2);
  const TrackMonitor::Verdict mean =
      mean_monitor_.update(mean_duty, mean_counts, dt_ms, slope_duty, free, parameters_);
  if (left == TrackMonitor::kStalled) latch(Fault::stalled_left, left_.duty, now_us);
  if (left == TrackMonitor::kReversed) latch(Fault::reversed_left, left_.duty, now_us);
  if (right == TrackMonitor::kStalled) latch(Fault::stalled_right, right_.duty, now_us);
  if (right == TrackMonitor::kReversed) latch(Fault::reversed_right, right_.duty, now_us);
  if (mean != TrackMonitor::kStalled || !may_drive()) return;
  const float left_m = left_.watch.missing_m();
  const float right_m = right_.watch.missing_m();
  if (left_m >= 0.5f * right_m) latch(Fault::stalled_left, left_.duty, now_us);
  if (right_m >= 0.5f * left_m) latch(Fault::stalled_right, right_.duty, now_us);
}

void Firmware::check_turn(uint32_t now_us) {
  if (state_ != State::kRunning || !uses_gyro(parameters_) || !imu_.fresh()) {
    turn_monitor_.reset();
    return;
  }
  const TurnMonitor::Verdict verdict = turn_monitor_.update(
      history_.newest(), imu_.values().accel[0], gate_.current().gyro_bias_radps, parameters_);
  if (verdict == TurnMonitor::kLeftShort) latch(Fault::stalled_left, left_.duty, now_us);
  if (verdict == TurnMonitor::kRightShort) latch(Fault::stalled_right, right_.duty, now_us);
}

TrackSpeeds Firmware::wanted(uint32_t now_us) {
  const wire::Command& command = gate_.current();
  const bool stand = command.speed_mps == 0.0f && command.yaw_rate_radps == 0.0f &&
                     command.desired_yaw_rad == command.yaw_rad;
  if (stand || !gate_.fresh(now_us)) return TrackSpeeds();
  state_ = State::kRunning;
  const bool use_gyro = uses_gyro(parameters_) && imu_.fresh();
  const float turned_rad =
      turned(gate_.answered(), history_.newest(), use_gyro, command.gyro_bias_radps, parameters_);
  const float error_rad = command.desired_yaw_rad - command.yaw_rad - turned_rad;
  const float rate_radps = turn_rate(error_rad, command.yaw_rate_radps, parameters_);
  return track_speeds(command.speed_mps, rate_radps, parameters_);
}

void Firmware::apply(int16_t left, int16_t right) {
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
