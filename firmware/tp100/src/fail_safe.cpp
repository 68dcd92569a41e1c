#include "fail_safe.h"

#include "number.h"

namespace tp100 {
namespace firmware {
namespace {

// One tick early, so that the motors are off when the time is over and not a tick later.
const int32_t kSilenceLimitUs = (wire::kMaxCommandLifeMs - 1) * 1000L;

uint16_t bit(wire::Fault fault) { return static_cast<uint16_t>(wire::fault_bit(fault)); }

}  // namespace

FailSafe::FailSafe(Hal& hal)
    : hal_(hal),
      ticks_(0),
      silent_ticks_(0),
      enabled_(false),
      fresh_us_(0),
      tripped_(0),
      was_enabled_(false),
      tripped_us_(0) {}

void FailSafe::tick() {
  ticks_ = static_cast<uint8_t>(ticks_ + 1);
  const uint8_t silent = static_cast<uint8_t>(silent_ticks_ + 1);
  if (silent <= kLoopLimitMs) silent_ticks_ = silent;
  if (silent == kLoopLimitMs) trip(wire::Fault::loop_hung, hal_.micros());
  if (enabled_) {
    const uint32_t now_us = hal_.micros();
    if (distance(now_us, fresh_us_) >= kSilenceLimitUs) trip(wire::Fault::command_timeout, now_us);
  }
  if (!enabled_) hal_.motors(0, 0);
}

void FailSafe::trip(wire::Fault fault, uint32_t now_us) {
  if (enabled_ || tripped_ == 0) tripped_us_ = now_us;
  if (enabled_) was_enabled_ = true;
  enabled_ = false;
  tripped_ = static_cast<uint16_t>(tripped_ | bit(fault));
}

void FailSafe::beat() { silent_ticks_ = 0; }

void FailSafe::fresh(uint32_t now_us) {
  const CriticalSection section(hal_);
  fresh_us_ = now_us;
}

void FailSafe::enable() {
  const CriticalSection section(hal_);
  if (tripped_ == 0) enabled_ = true;
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
  const CriticalSection section(hal_);
  const Trip result = {tripped_, tripped_us_, distance(tripped_us_, fresh_us_) / 1000,
                       was_enabled_};
  tripped_ = 0;
  was_enabled_ = false;
  return result;
}

}  // namespace firmware
}  // namespace tp100
