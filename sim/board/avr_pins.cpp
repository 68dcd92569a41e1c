#include "sim/board/avr_pins.h"

#include <avr_adc.h>
#include <avr_ioport.h>
#include <sim_avr.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sim/board/avr_core.h"
#include "sim/body/seed.h"

namespace tp100::sim {
namespace {

constexpr std::uint32_t kMax = 1023;
constexpr double kDivider = 3.0;
constexpr int kBattery = 0;
constexpr int kOpenPin = 7;

struct Place {
  char port;
  std::uint8_t bit;
};
constexpr std::array<Place, 4> kPlaces = {{{'E', 4}, {'E', 5}, {'D', 3}, {'D', 2}}};

avr_ioport_t* port_of(avr_io_t* io) { return reinterpret_cast<avr_ioport_t*>(io); }

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
  // A pull-down keeps an enable low that is not driven.
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

AvrAdc::AvrAdc(AvrCore& core, std::uint64_t seed) : core_(core), noise_(seed) {
  avr_irq_register_notify(avr_io_getirq(core.chip(), AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER),
                          on_conversion, this);
}

void AvrAdc::set_supply(double volts) {
  core_.chip()->avcc = static_cast<std::uint32_t>(std::lround(volts * 1e3));
}

void AvrAdc::on_conversion(avr_irq_t*, std::uint32_t, void* self) {
  AvrAdc& adc = *static_cast<AvrAdc*>(self);
  adc.noise_ = mix(adc.noise_);
  adc.put(kOpenPin, static_cast<std::uint32_t>(adc.noise_ % 64));
  const double steps = adc.volts_ / kDivider * 1024e3 / adc.core_.chip()->avcc;
  adc.put(kBattery, static_cast<std::uint32_t>(std::clamp(steps, 0.0, double{kMax})));
}

// simavr expects millivolts and scales them by 1023: the least value that gives `steps`.
void AvrAdc::put(int channel, std::uint32_t steps) {
  const std::uint32_t mv = (steps * core_.chip()->avcc + kMax - 1) / kMax;
  avr_raise_irq(avr_io_getirq(core_.chip(), AVR_IOCTL_ADC_GETIRQ, channel), mv);
}

AvrEncoderPins::AvrEncoderPins(AvrCore& core) : core_(core) {
  for (std::size_t i = 0; i < pins_.size(); ++i) {
    Pin& pin = pins_[i];
    pin.port = port_of(
        core.module("port", [&](avr_io_t* io) { return port_of(io)->name == kPlaces[i].port; }));
    pin.irq = pin.port->io.irq + kPlaces[i].bit;
    pin.mask = static_cast<std::uint8_t>(1U << kPlaces[i].bit);
    pin.port->external.pull_mask |= pin.mask;
    hold(pin);
  }
}

// simavr sets an input with pull-up back to high at any write to its port, unless it knows that
// it is driven from outside.
void AvrEncoderPins::hold(const Pin& pin) {
  std::uint8_t& levels = pin.port->external.pull_value;
  levels = static_cast<std::uint8_t>(pin.level ? levels | pin.mask : levels & ~pin.mask);
}

void AvrEncoderPins::set(std::uint8_t channel, bool level) {
  Pin& pin = pins_[channel & 3U];
  pin.level = level;
  hold(pin);
  avr_raise_irq(pin.irq, level ? 1 : 0);
}

void AvrEncoderPins::restore() {
  for (const Pin& pin : pins_) {
    std::uint8_t& levels = core_.data()[pin.port->r_pin];
    levels = static_cast<std::uint8_t>(pin.level ? levels | pin.mask : levels & ~pin.mask);
    pin.irq->value = pin.level ? 1 : 0;
  }
}

MotorDuty motor_drive(const AvrCore& core) {
  return {drive(core.data(), kLeft), drive(core.data(), kRight)};
}

}  // namespace tp100::sim
