#include "sim/board/avr_motor_pins.h"

#include <cstdint>

namespace tp100::sim {
namespace {

constexpr std::uint16_t kDdra = 0x21;
constexpr std::uint16_t kPorta = 0x22;
constexpr std::uint16_t kTccr4a = 0xA0;
constexpr std::uint16_t kTccr4b = 0xA1;
constexpr std::uint16_t kOcr4a = 0xA8;
constexpr std::uint16_t kOcr4b = 0xAA;
constexpr std::uint16_t kDdrh = 0x101;
constexpr std::uint16_t kPorth = 0x102;

struct Bridge {
  std::uint8_t enable;   // bit of port H
  std::uint8_t compare;  // bits COM4x of TCCR4A
  std::uint16_t ocr;
  std::uint8_t forward;  // bits of port A
  std::uint8_t backward;
};
constexpr Bridge kLeft = {0x08, 0x80, kOcr4a, 0x01, 0x02};
constexpr Bridge kRight = {0x10, 0x20, kOcr4b, 0x04, 0x08};

double drive(const std::uint8_t* data, const Bridge& bridge) {
  // A pull-down holds an enable that is not driven.
  if ((data[kDdrh] & bridge.enable) == 0) return 0.0;
  const auto inputs = static_cast<std::uint8_t>(data[kPorta] & data[kDdra]);
  const bool forward = (inputs & bridge.forward) != 0;
  const bool backward = (inputs & bridge.backward) != 0;
  if (forward == backward) return 0.0;
  const bool runs = (data[kTccr4b] & 7U) != 0;
  const bool pwm = (data[kTccr4a] & bridge.compare) != 0 && runs;
  const double share = pwm                                   ? data[bridge.ocr] / 255.0
                       : (data[kPorth] & bridge.enable) != 0 ? 1.0
                                                             : 0.0;
  return forward ? share : -share;
}

}  // namespace

Drive motor_drive(const AvrCore& core) {
  return {drive(core.data(), kLeft), drive(core.data(), kRight)};
}

}  // namespace tp100::sim
