// Switches the motors off whatever the main loop does. tick() runs in the 1 kHz timer interrupt;
// the motors are reached only through drive(), and only while enabled.
#ifndef TP100_FIRMWARE_FAIL_SAFE_H
#define TP100_FIRMWARE_FAIL_SAFE_H

#include "hal.h"
#include "wire/faults.h"

namespace tp100 {
namespace firmware {

/// Main loop silent for this long: motors off. [ms]
const uint8_t kLoopLimitMs = 100;
/// While disarmed, the first command of a session must arrive within this time. [ms]
const uint16_t kSessionGraceMs = 500 + wire::kMaxCommandLifeMs;

/// What tripped the fail-safe.
struct Trip {
  uint16_t faults;     ///< mask of the robot's bits; empty: nothing
  uint32_t at_us;      ///< device time
  int32_t silence_ms;  ///< since the last fresh command
};

/// A fault of the robot as a bit of a word that an interrupt can exchange.
inline uint16_t bit(wire::Fault fault) {
  return static_cast<uint16_t>(1U << static_cast<uint8_t>(fault));
}

class FailSafe {
 public:
  explicit FailSafe(Hal& hal) : hal_(hal) {}

  /// Timer interrupt, every millisecond.
  void tick();

  /// The functions below are for the main loop.
  void beat();
  /// A session begins: after kSessionGraceMs, commands are expected whether armed or not.
  void watch(uint32_t now_us);
  /// No session: no commands are expected.
  void unwatch();
  /// A valid command was accepted at `now_us` and may be used for `life_us`.
  void fresh(uint32_t now_us, uint32_t life_us);
  /// Enables drive() until a trip or disable(). False: tripped, or no command is fresh.
  bool enable();
  /// Motors off at once.
  void disable();
  bool enabled() const { return enabled_; }
  /// Applies duties to the motors; does nothing unless enabled.
  void drive(int16_t left, int16_t right);
  /// take_trip() has something to tell.
  bool tripped() const { return tripped_ != 0; }
  /// The trip since the last call, if any.
  Trip take_trip();
  /// Ticks since boot, wraps. [ms]
  uint8_t ticks() const { return ticks_; }

 private:
  void check_commands(uint32_t now_us);
  void trip(wire::Fault fault, uint32_t now_us);

  Hal& hal_;
  volatile uint8_t ticks_ = 0;
  volatile uint8_t silent_ticks_ = 0;
  volatile bool enabled_ = false;
  volatile bool watching_ = false;
  volatile bool starved_ = false;  // tripped, and no command received since
  volatile bool fresh_ = false;
  volatile uint16_t grace_ms_ = 0;
  volatile uint32_t fresh_us_ = 0;
  volatile uint32_t life_us_ = 0;
  volatile uint16_t tripped_ = 0;
  volatile uint32_t tripped_us_ = 0;
};

}  // namespace firmware
}  // namespace tp100

#endif
