#include "sim/board/avr_encoder_pins.h"

#include <avr_ioport.h>
#include <sim_avr.h>

#include <cstring>

#include "core/error.h"

namespace tp100::sim {
namespace {

struct Place {
  char port;
  std::uint8_t bit;
};
constexpr std::array<Place, 4> kPlaces = {{{'E', 4}, {'E', 5}, {'D', 3}, {'D', 2}}};

avr_ioport_t* find_port(avr_t* avr, char name) {
  for (avr_io_t* io = avr->io_port; io != nullptr; io = io->next) {
    if (std::strcmp(io->kind, "port") != 0) continue;
    auto* port = reinterpret_cast<avr_ioport_t*>(io);
    if (port->name == name) return port;
  }
  throw SetupError("libsimavr: its atmega2560 lacks a port; install libsimavr-dev 1.6");
}

}  // namespace

AvrEncoderPins::AvrEncoderPins(AvrCore& core) : core_(core) {
  for (std::size_t i = 0; i < pins_.size(); ++i) {
    Pin& pin = pins_[i];
    pin.port = find_port(core.chip(), kPlaces[i].port);
    pin.irq = pin.port->io.irq + kPlaces[i].bit;
    pin.mask = static_cast<std::uint8_t>(1U << kPlaces[i].bit);
    pin.port->external.pull_mask |= pin.mask;
    hold(pin);
  }
}

// simavr takes an input with pull-up back to high at any write to its port, unless it knows that
// something outside drives it.
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

}  // namespace tp100::sim
