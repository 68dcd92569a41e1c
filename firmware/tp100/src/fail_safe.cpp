#include "fail_safe.h"

#include "shared/number.h"

namespace tp100 {
namespace firmware {
namespace {

using shared::wrapped_difference;

// Commands expire one tick, and the time that a tick may take, early: the motors are off by the end
// of the command's life.
const int32_t kEarlyUs = 1100;

}  // namespace

void FailSafe::tick() {
  ticks_ = static_cast<uint8_t>(ticks_ + 1);
  const uint32_t now_us = hal_.micros();
  const uint8_t silent = static_cast<uint8_t>(silent_ticks_ + 1);
  if (silent <= kLoopLimitMs) silent_ticks_ = silent;
  if (silent == kLoopLimitMs) trip(wire::Fault::loop_hung, now_us);
  check_commands(now_us);
  if (!enabled_) hal_.motors(0, 0);
}

void FailSafe::check_commands(uint32_t now_us) {
  if (fresh_ &&
      wrapped_difference(now_us, fresh_us_) + kEarlyUs >= static_cast<int32_t>(life_us_)) {
    fresh_ = false;
  }
  if (grace_ms_ > 0) grace_ms_ = static_cast<uint16_t>(grace_ms_ - 1);
  const bool expected = enabled_ || (watching_ && grace_ms_ == 0);
  if (fresh_ || starved_ || !expected) return;
  starved_ = true;
  trip(wire::Fault::command_timeout, now_us);
}

void FailSafe::trip(wire::Fault fault, uint32_t now_us) {
  if (enabled_ || tripped_ == 0) tripped_us_ = now_us;
  enabled_ = false;
  tripped_ = static_cast<uint16_t>(tripped_ | bit(fault));
}

void FailSafe::beat() { silent_ticks_ = 0; }

void FailSafe::watch(uint32_t now_us) {
  const CriticalSection section(hal_);
  watching_ = true;
  starved_ = false;
  fresh_ = false;
  fresh_us_ = now_us;
  grace_ms_ = kSessionGraceMs;
}

void FailSafe::unwatch() {
  const CriticalSection section(hal_);
  watching_ = false;
  fresh_ = false;
}

void FailSafe::fresh(uint32_t now_us, uint32_t life_us) {
  const CriticalSection section(hal_);
  fresh_ = true;
  starved_ = false;
  fresh_us_ = now_us;
  life_us_ = life_us;
}

bool FailSafe::enable() {
  const CriticalSection section(hal_);
  if (tripped_ != 0 || !fresh_) return false;
  enabled_ = true;
  return true;
}

void FailSafe::disable() {
  const CriticalSection section(hal_);
  enabled_ = false;
  hal_.motors(0, 0);
}

void FailSafe::drive(int16_t left, int16_t right) {
  const CriticalSection section(hal_);
  if (enabled_) hal_.motors(left, right);
}

Trip FailSafe::take_trip() {
  Trip result = {};
  if (!tripped()) return result;
  const CriticalSection section(hal_);
  result = {tripped_, tripped_us_, wrapped_difference(tripped_us_, fresh_us_) / 1000};
  tripped_ = 0;
  return result;
}

}  // namespace firmware
}  // namespace tp100
