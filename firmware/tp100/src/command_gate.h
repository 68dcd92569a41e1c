// Decides whether a command may be used, and for how long.
#ifndef TP100_FIRMWARE_COMMAND_GATE_H
#define TP100_FIRMWARE_COMMAND_GATE_H

#include "yaw_loop.h"

namespace tp100 {
namespace firmware {

enum class Verdict : uint8_t {
  kAccepted,
  kWrongBoot,
  kRepeated,    ///< sequence not newer than the last accepted one
  kOutOfRange,  ///< or not finite
  kExpired,
  kTooFarAhead,    ///< expiry lies further ahead than kMaxCommandLifeMs
  kUnknownSample,  ///< answers a sample that was not sent, or one outside yaw_window_ms
};

class CommandGate {
 public:
  /// Opens a session: any first sequence counts as new, and no command is fresh.
  void open(uint32_t boot_nonce);
  /// Judges a command received at `now_us`; an accepted command becomes the current one.
  Verdict judge(const wire::Command& command, uint32_t now_us, const TurnHistory& history,
                const wire::Parameters& parameters);
  /// True while the current command may be used.
  bool fresh(uint32_t now_us);
  const wire::Command& current() const { return current_; }
  /// How long the current command may be used after its receipt. [us]
  uint32_t life_us() const { return life_us_; }
  /// Rotation of the robot at the answered sample.
  const TurnMark& answered() const { return answered_; }
  /// Sequence of the last accepted command of this session; 0: none yet.
  uint16_t last_sequence() const { return any_ ? current_.sequence : 0; }

 private:
  wire::Command current_ = {};
  TurnMark answered_ = {};
  uint32_t boot_nonce_ = 0;
  uint32_t received_us_ = 0;
  uint32_t life_us_ = 0;
  bool any_ = false;
  bool fresh_ = false;
};

}  // namespace firmware
}  // namespace tp100

#endif
