#include "mega.h"

#if defined(__AVR__)

#include <avr/interrupt.h>
#include <avr/io.h>

#include "../options.h"
#include "fake_mega.h"
#include "firmware.h"

namespace {

#if defined(FAKE_ROBOT)
tp100::firmware::FakeMegaHal hal;
#else
tp100::firmware::MegaHal hal;
#endif
tp100::firmware::Firmware robot(hal);

}  // namespace

// With interrupts on: an edge of an encoder must not wait for the longest routine.
ISR(TIMER3_COMPA_vect, ISR_NOBLOCK) {
  if (robot.tick_1khz()) tp100::firmware::raise_work();
}

namespace tp100 {
namespace firmware {

void mega_setup() {
  hal.begin();
  robot.setup();
  // Timer 3: clear on compare, 16 MHz / 64 / 250.
  TCCR3A = 0;
  TCCR3B = _BV(WGM32) | _BV(CS31) | _BV(CS30);
  OCR3A = 249;
  TCNT3 = 0;
  TIFR3 = _BV(OCF3A);
  TIMSK3 = _BV(OCIE3A);
}

void mega_loop() { robot.loop(); }

}  // namespace firmware
}  // namespace tp100

#endif
