#include "command_gate.h"

#include "shared/number.h"

namespace tp100 {
namespace firmware {
namespace {

using shared::magnitude;
using shared::wrapped_difference;

const int32_t kFurthestExpiryUs = wire::kMaxCommandLifeMs * 1000L;

bool in_range(const wire::Command& c) {
  return magnitude(c.x_m) <= 1e4f && magnitude(c.y_m) <= 1e4f && magnitude(c.yaw_rad) <= 1e3f &&
         magnitude(c.desired_yaw_rad) <= 1e3f && magnitude(c.yaw_rate_radps) <= 10.0f &&
         magnitude(c.speed_mps) <= 2.0f && magnitude(c.gyro_bias_radps) <= 1.0f;
}

}  // namespace

void CommandGate::open(uint32_t boot_nonce) {
  boot_nonce_ = boot_nonce;
  any_ = false;
  fresh_ = false;
}

Verdict CommandGate::judge(const wire::Command& command, uint32_t now_us,
                           const TurnHistory& history, const wire::Parameters& p) {
  if (command.boot_nonce != boot_nonce_) return Verdict::kWrongBoot;
  const int16_t newer = wrapped_difference(command.sequence, current_.sequence);
  if (any_ && newer <= 0) return Verdict::kRepeated;
  if (!in_range(command)) return Verdict::kOutOfRange;
  const int32_t ahead_us = wrapped_difference(command.expiry_us, now_us);
  if (ahead_us <= 0) return Verdict::kExpired;
  if (ahead_us > kFurthestExpiryUs) return Verdict::kTooFarAhead;
  const TurnMark* answered = history.find(command.answers);
  if (answered == nullptr || wrapped_difference(now_us, answered->device_us) >
                                 static_cast<int32_t>(p.yaw_window_ms) * 1000) {
    return Verdict::kUnknownSample;
  }
  current_ = command;
  answered_ = *answered;
  received_us_ = now_us;
  const uint32_t life_us = static_cast<uint32_t>(p.command_life_ms) * 1000;
  life_us_ = static_cast<uint32_t>(ahead_us) < life_us ? static_cast<uint32_t>(ahead_us) : life_us;
  any_ = true;
  fresh_ = true;
  return Verdict::kAccepted;
}

bool CommandGate::fresh(uint32_t now_us) {
  // The result is stored, so that an expired command does not become fresh when micros() wraps.
  if (fresh_ && now_us - received_us_ >= life_us_) fresh_ = false;
  return fresh_;
}

}  // namespace firmware
}  // namespace tp100
