#include "hal_mega.h"

#if defined(__AVR__)

#include <Arduino.h>
#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <avr/wdt.h>

#include "quadrature.h"
#include "twi_mega.h"
#include "uart_mega.h"

namespace {

using tp100::firmware::Quadrature;
using tp100::firmware::take_edge;

const uint8_t kScl = _BV(PD0);
const uint8_t kSda = _BV(PD1);
const uint8_t kDirections = _BV(PA0) | _BV(PA1) | _BV(PA2) | _BV(PA3);
const uint8_t kBatteryPin = 0;
const uint8_t kNoisePin = 7;
// MUX4:0 of the bandgap, MUX5 is 0 (data sheet, "Input Channel Selections").
const uint8_t kBandgap = 0x1E;
// Battery conversions, one per sample. The last two conversions of a second measure the bandgap: it
// is a weak source, so the first of them only charges the converter.
const uint8_t kConversions = 200;
const uint8_t kBatteryConversions = kConversions - 2;

Quadrature left_encoder;
Quadrature right_encoder;
uint32_t boot_counter EEMEM;
// In .noinit, because the start-up code runs after .init3 and would clear it.
uint8_t mcusr_mirror __attribute__((section(".noinit")));

// A is PE4, B is PE5. Swaps nibbles, because the compiler's shift is a loop of 22 cycles.
inline uint8_t left_phase() { return __builtin_avr_swap(PINE) & 3; }
// B is PD2, A is PD3: bit 0 is B here, hence take_edge<-1>.
inline uint8_t right_phase() { return (PIND >> 2) & 3; }

}  // namespace

ISR(INT4_vect) { take_edge<1>(left_encoder, left_phase()); }
ISR(INT5_vect, ISR_ALIASOF(INT4_vect));

ISR(INT3_vect) { take_edge<-1>(right_encoder, right_phase()); }
ISR(INT2_vect, ISR_ALIASOF(INT3_vect));

// The watchdog stays armed at its shortest period after it has fired: switch it off before anything
// else.
extern "C" void save_reset_cause() __attribute__((naked, used, section(".init3")));
extern "C" void save_reset_cause() {
  mcusr_mirror = MCUSR;
  MCUSR = 0;
  wdt_disable();
}

namespace tp100 {
namespace firmware {
namespace {

void begin_motors() {
  PORTA &= static_cast<uint8_t>(~kDirections);
  DDRA |= kDirections;
  TCCR4A &= static_cast<uint8_t>(~(_BV(COM4A1) | _BV(COM4B1)));
  PORTH &= static_cast<uint8_t>(~(_BV(PH3) | _BV(PH4)));
  DDRH |= _BV(PH3) | _BV(PH4);
}

void begin_encoders() {
  PORTE |= _BV(PE4) | _BV(PE5);
  PORTD |= _BV(PD2) | _BV(PD3);
  left_encoder.phase = left_phase();
  right_encoder.phase = right_phase();
  EICRA = static_cast<uint8_t>((EICRA & 0x0F) | _BV(ISC20) | _BV(ISC30));
  EICRB = static_cast<uint8_t>((EICRB & 0xF0) | _BV(ISC40) | _BV(ISC50));
  EIFR = _BV(INTF2) | _BV(INTF3) | _BV(INTF4) | _BV(INTF5);
  EIMSK |= _BV(INT2) | _BV(INT3) | _BV(INT4) | _BV(INT5);
}

void start_conversion(uint8_t channel) {
  ADMUX = static_cast<uint8_t>(_BV(REFS0) | channel);
  ADCSRA |= _BV(ADSC);
}

uint16_t converted(uint8_t channel) {
  start_conversion(channel);
  for (uint16_t wait = 0; (ADCSRA & _BV(ADSC)) != 0 && wait < 2000; ++wait) {
  }
  return ADC;
}

uint32_t mixed(uint32_t hash, uint32_t value) {
  hash ^= value;
  hash *= 0x9E3779B1UL;
  return hash ^ (hash >> 15);
}

// The counter differs between boots of one board, the noise of an open pin differs between boards.
uint32_t new_nonce() {
  const uint32_t boots = eeprom_read_dword(&boot_counter) + 1;
  eeprom_update_dword(&boot_counter, boots);
  uint32_t hash = mixed(0x811C9DC5UL, boots);
  for (uint8_t i = 0; i < 16; ++i) hash = mixed(hash, converted(kNoisePin));
  hash = mixed(hash, ::micros());
  return hash != 0 ? hash : 1;
}

void half_clock() { delayMicroseconds(3); }

// Open drain: the line is pulled low by making it an output.
void pull(uint8_t line) { DDRD |= line; }
void release(uint8_t line) { DDRD &= static_cast<uint8_t>(~line); }

uint8_t duty_byte(int16_t duty) {
  const uint16_t size = static_cast<uint16_t>(duty < 0 ? -duty : duty);
  if (size >= static_cast<uint16_t>(wire::kFullDuty)) return 255;
  // 255/1000 with an error below a 250th of a step, without a division.
  return static_cast<uint8_t>((size * 16712UL + 32768UL) >> 16);
}

}  // namespace

void MegaHal::begin() {
  begin_motors();
  wdt_enable(WDTO_250MS);
  uart_mega::begin();
  begin_encoders();
  nonce_ = new_nonce();
  converted(kBandgap);
  delayMicroseconds(1000);
  supply_.update(converted(kBandgap));
  start_conversion(kBatteryPin);
  twi_mega::begin();
}

uint32_t MegaHal::micros() { return ::micros(); }

uint8_t MegaHal::uart_read(uint8_t* bytes, uint8_t most) { return uart_mega::read(bytes, most); }
uint8_t MegaHal::uart_room() { return uart_mega::room(); }
uint8_t MegaHal::uart_waiting() { return uart_mega::waiting(); }
void MegaHal::uart_write(const uint8_t* bytes, uint8_t size) { uart_mega::write(bytes, size); }

bool MegaHal::i2c_write(uint8_t address, uint8_t reg, uint8_t value) {
  const uint8_t bytes[] = {reg, value};
  return twi_mega::write(address, bytes, sizeof bytes);
}

bool MegaHal::i2c_read(uint8_t address, uint8_t reg, uint8_t* bytes, uint8_t size) {
  return twi_mega::read(address, reg, bytes, size);
}

void MegaHal::i2c_recover() {
  twi_mega::end();
  const uint8_t saved = lock();
  PORTD &= static_cast<uint8_t>(~(kScl | kSda));
  release(kSda | kScl);
  unlock(saved);
  // A device cut off in the middle of a byte releases SDA within nine clocks.
  for (uint8_t i = 0; i < 9; ++i) {
    pull(kScl);
    half_clock();
    release(kScl);
    half_clock();
  }
  pull(kScl);
  pull(kSda);
  half_clock();
  release(kScl);
  half_clock();
  release(kSda);
  half_clock();
  twi_mega::begin();
}

void MegaHal::counts(int32_t& left, int32_t& right) {
  const CriticalSection section(*this);
  left = extended_counts(left_encoder);
  right = extended_counts(right_encoder);
}

uint16_t MegaHal::missed_edges() {
  const CriticalSection section(*this);
  return static_cast<uint16_t>(left_encoder.missed + right_encoder.missed);
}

void MegaHal::motors(int16_t left, int16_t right) {
  const CriticalSection section(*this);
  if (left == 0 || right == 0) {
    // A compare value of 0 still produces a spike, so the pin itself is set low instead.
    uint8_t off = 0;
    if (left == 0) off |= _BV(COM4A1);
    if (right == 0) off |= _BV(COM4B1);
    TCCR4A &= static_cast<uint8_t>(~off);
  }
  uint8_t directions = 0;
  if (left > 0) directions |= _BV(PA0);
  if (left < 0) directions |= _BV(PA1);
  if (right > 0) directions |= _BV(PA2);
  if (right < 0) directions |= _BV(PA3);
  PORTA = static_cast<uint8_t>((PORTA & ~kDirections) | directions);
  if (left != 0) {
    OCR4A = duty_byte(left);
    TCCR4A |= _BV(COM4A1);
  }
  if (right != 0) {
    OCR4B = duty_byte(right);
    TCCR4A |= _BV(COM4B1);
  }
}

uint16_t MegaHal::battery_mv() {
  if ((ADCSRA & _BV(ADSC)) != 0) return battery_mv_;
  if (conversion_ < kBatteryConversions) battery_mv_ = supply_.battery_mv(ADC);
  if (conversion_ == kConversions - 1) supply_.update(ADC);
  conversion_ = static_cast<uint8_t>((conversion_ + 1) % kConversions);
  start_conversion(conversion_ < kBatteryConversions ? kBatteryPin : kBandgap);
  return battery_mv_;
}

void MegaHal::kick_watchdog() { wdt_reset(); }

wire::ResetCause MegaHal::reset_cause() {
  const uint8_t cause = mcusr_mirror;
  if ((cause & _BV(WDRF)) != 0) return wire::ResetCause::kWatchdog;
  // A slowly rising supply sets both flags.
  if ((cause & _BV(PORF)) != 0) return wire::ResetCause::kPowerOn;
  if ((cause & _BV(BORF)) != 0) return wire::ResetCause::kBrownOut;
  if ((cause & _BV(EXTRF)) != 0) return wire::ResetCause::kExternal;
  return wire::ResetCause::kUnknown;
}

uint8_t MegaHal::lock() {
  const uint8_t saved = SREG;
  cli();
  return saved;
}

void MegaHal::unlock(uint8_t saved) {
  __asm__ volatile("" ::: "memory");
  SREG = saved;
}

// An edge or a byte received or sent wakes the processor, but is no work for the loop: one pass for
// each would take more time than all other work.
void MegaHal::idle() {
  // The last pass left received bytes behind.
  if (uart_mega::worth_reading()) return;
  set_sleep_mode(SLEEP_MODE_IDLE);
  sleep_enable();
  for (;;) {
    cli();
    if (work_raised()) break;
    // The instruction after sei runs before any interrupt, so no interrupt can come in between.
    sei();
    sleep_cpu();
  }
  clear_work();
  sei();
  sleep_disable();
}

}  // namespace firmware
}  // namespace tp100

#endif
