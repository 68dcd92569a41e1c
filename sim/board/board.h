#pragma once
// A Mega running the firmware, seen from its pins. Time is virtual; one call advances one quantum.

#include <cstdint>
#include <span>
#include <vector>

#include "core/time.h"
#include "sim/sensors/quadrature_encoder.h"
#include "wire/messages.h"

namespace tp100::sim {

/// One byte with the time at which its stop bit ends.
struct TimedByte {
  HostNs at_ns;
  std::uint8_t value;
};

/// Why a board starts; none is unknown.
using PowerUp = wire::ResetCause;

/// Signed duties at the motor driver, -1..1.
struct MotorDuty {
  double left = 0.0;
  double right = 0.0;
};

class Board {
 public:
  virtual ~Board() = default;
  /// (Re)starts the firmware at virtual time `now_ns`.
  virtual void reset(PowerUp cause, HostNs now_ns) = 0;
  /// Runs until `until_ns`. `edges` and `received` are ascending in time and lie in this quantum.
  virtual void advance(HostNs until_ns, std::span<const EncoderEdge> edges,
                       std::span<const TimedByte> received) = 0;
  /// Bytes sent since the last take, with the end of their stop bits.
  virtual std::vector<TimedByte> take_sent() = 0;
  /// Outputs in effect at the end of the quantum.
  virtual MotorDuty motor_duty() const = 0;
  /// Voltage at the battery divider, set before each quantum.
  virtual void set_battery(double volts) = 0;
  /// Supply voltage of the board, the reference of its ADC; USB's 5 V by default.
  virtual void set_supply(double volts) = 0;
};

}  // namespace tp100::sim
