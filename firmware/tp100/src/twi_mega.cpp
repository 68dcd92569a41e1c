#include "twi_mega.h"

#if defined(__AVR__)

#include <Arduino.h>
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <util/twi.h>

namespace {

const uint32_t kBusHz = 400000;
const uint32_t kTimeoutUs = 3000;
const uint8_t kLines = _BV(PD0) | _BV(PD1);
const uint8_t kOn = _BV(TWEN);
const uint8_t kGo = _BV(TWINT) | _BV(TWEN) | _BV(TWIE);

uint32_t began_us;

void pull_up(bool on) {
  const uint8_t saved = SREG;
  cli();
  PORTD = static_cast<uint8_t>(on ? PORTD | kLines : PORTD & ~kLines);
  SREG = saved;
}

// Sleeps until the step started by `control` is over; after a time-out the controller is off.
bool step(uint8_t control) {
  TWCR = control;
  sleep_enable();
  bool over = false;
  for (;;) {
    cli();
    over = (TWCR & _BV(TWINT)) != 0;
    if (over) break;
    // The instruction after sei runs before any interrupt, so no interrupt can come in between. The
    // timer behind micros() wakes the processor even if the bus never does.
    sei();
    sleep_cpu();
    if ((TWCR & _BV(TWINT)) == 0 && micros() - began_us > kTimeoutUs) break;
  }
  sei();
  sleep_disable();
  if (!over) TWCR = 0;
  return over;
}

bool start(uint8_t status) { return step(kGo | _BV(TWSTA)) && TW_STATUS == status; }

bool send(uint8_t byte, uint8_t status) {
  TWDR = byte;
  return step(kGo) && TW_STATUS == status;
}

bool stop(bool good) {
  if ((TWCR & kOn) == 0) return false;
  TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWSTO);
  // Takes one bit time unless a device holds the bus.
  for (uint8_t wait = 255; (TWCR & _BV(TWSTO)) != 0; --wait) {
    if (wait == 0) {
      TWCR = 0;
      return false;
    }
  }
  return good;
}

bool address_for_write(uint8_t address) {
  set_sleep_mode(SLEEP_MODE_IDLE);
  began_us = micros();
  return start(TW_START) && send(static_cast<uint8_t>(address << 1), TW_MT_SLA_ACK);
}

bool receive(uint8_t* bytes, uint8_t size) {
  for (uint8_t i = 0; i < size; ++i) {
    const bool last = i + 1 == size;
    if (!step(last ? kGo : kGo | _BV(TWEA))) return false;
    if (TW_STATUS != (last ? TW_MR_DATA_NACK : TW_MR_DATA_ACK)) return false;
    bytes[i] = TWDR;
  }
  return true;
}

}  // namespace

// Only wakes step(), which tests the flag: writing TWINT as 0 leaves the flag set.
ISR(TWI_vect) { TWCR = kOn; }

namespace tp100 {
namespace firmware {
namespace twi_mega {

void begin() {
  pull_up(true);
  TWSR = 0;
  TWBR = (F_CPU / kBusHz - 16) / 2;
  TWCR = kOn;
}

void end() {
  TWCR = 0;
  pull_up(false);
}

bool write(uint8_t address, const uint8_t* bytes, uint8_t size) {
  bool good = address_for_write(address);
  for (uint8_t i = 0; good && i < size; ++i) good = send(bytes[i], TW_MT_DATA_ACK);
  return stop(good);
}

bool read(uint8_t address, uint8_t reg, uint8_t* bytes, uint8_t size) {
  const uint8_t for_read = static_cast<uint8_t>(address << 1 | 1);
  const bool good = address_for_write(address) && send(reg, TW_MT_DATA_ACK) &&
                    start(TW_REP_START) && send(for_read, TW_MR_SLA_ACK) && receive(bytes, size);
  return stop(good);
}

}  // namespace twi_mega
}  // namespace firmware
}  // namespace tp100

#endif
