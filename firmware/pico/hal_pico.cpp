#include "hal_pico.h"

#include "quadrature.h"
#include "rp2040.h"
#include "scaling.h"
#include "wire/frame.h"

namespace tp100 {
namespace firmware {
namespace {

using namespace rp2040;

const unsigned kTx = 0, kRx = 1, kSda = 4, kScl = 5, kLeftA = 6, kRightA = 8;
const unsigned kLeftForward = 10, kLeftBack = 11, kRightForward = 12, kRightBack = 13;
const unsigned kLeftEnable = 14, kRightEnable = 15, kBattery = 26;
const uint32_t kDirections =
    mask(kLeftForward) | mask(kLeftBack) | mask(kRightForward) | mask(kRightBack);
const uint32_t kEnables = mask(kLeftEnable) | mask(kRightEnable);

const uint32_t kWatchdogUs = 250000;
const uint32_t kI2cTimeoutUs = 3000;
const uint32_t kI2cHz = 400000;

Quadrature left_encoder;
Quadrature right_encoder;

// 8-bit indices wrap by themselves; one place stays free to distinguish full from empty.
uint8_t received[256];
volatile uint8_t received_head;
volatile uint8_t received_tail;
uint8_t sending[256];
volatile uint8_t sending_head;
volatile uint8_t sending_tail;

uint8_t phase(unsigned a_pin) { return static_cast<uint8_t>((gpio_in() >> a_pin) & 3); }

// If the bits never come, the board stays here with its outputs low.
void wait_for(Register& r, uint32_t bits) {
  while ((r & bits) != bits) {
  }
}

void begin_outputs() {
  const uint32_t first = kResetIoBank0 | kResetPadsBank0;
  clear_of(reset()) = first;
  wait_for(reset_done(), first);
  gpio_out_clear() = kDirections | kEnables;
  gpio_enable_set() = kDirections | kEnables;
  for (unsigned pin = kLeftForward; pin <= kRightEnable; ++pin) gpio_control(pin) = kSio;
}

void begin_pll(uint32_t pll, uint32_t feedback, uint32_t divider1, uint32_t divider2) {
  pll_status(pll) = 1;
  pll_feedback(pll) = feedback;
  clear_of(pll_power(pll)) = mask(0) | mask(5);
  wait_for(pll_status(pll), mask(31));
  pll_dividers(pll) = divider1 << 16 | divider2 << 12;
  clear_of(pll_power(pll)) = mask(3);
}

void begin_clocks() {
  xosc_startup() = pico::kCrystalHz / 1000 / 256;
  xosc_control() = 0xfab << 12 | 0xaa0;
  wait_for(xosc_status(), mask(31));
  // The crystal becomes the reference clock; the system runs from it while its PLL starts.
  clear_of(clk_sys_control()) = 1;
  wait_for(clk_sys_selected(), mask(0));
  clk_ref_control() = 2;
  wait_for(clk_ref_selected(), mask(2));
  const uint32_t plls = kResetPllSys | kResetPllUsb;
  set_of(reset()) = plls;
  clear_of(reset()) = plls;
  wait_for(reset_done(), plls);
  begin_pll(kPllSys, pico::kSysFeedback, pico::kSysDivider1, pico::kSysDivider2);
  begin_pll(kPllUsb, pico::kAdcFeedback, pico::kAdcDivider1, pico::kAdcDivider2);
  clk_sys_control() = 0;
  set_of(clk_sys_control()) = 1;
  wait_for(clk_sys_selected(), mask(1));
  clk_peri_control() = kClockEnable;
  clk_adc_control() = kClockEnable;
  // One tick per microsecond for timer and watchdog.
  watchdog_tick() = mask(9) | pico::kCrystalHz / 1000000;
}

void begin_watchdog(PicoHal& hal) {
  // The watchdog resets everything but the two oscillators.
  watchdog_restarts() = 0x1fffc;
  hal.kick_watchdog();
  set_of(watchdog_control()) = mask(30);
}

void begin_peripherals() {
  const uint32_t used = kResetAdc | kResetI2c0 | kResetPwm | kResetTimer | kResetUart0;
  set_of(reset()) = used;
  clear_of(reset()) = used;
  wait_for(reset_done(), used);
}

void begin_pwm() {
  pwm7_divider() = pico::kPwmDivider << 4;
  pwm7_top() = pico::kPwmTop;
  pwm7_levels() = 0;
  pwm7_control() = 1;
  gpio_control(kLeftEnable) = kPwm;
  gpio_control(kRightEnable) = kPwm;
}

void begin_uart() {
  static_assert(pico::kSysHz * 4 % wire::kBaud == 0, "the baud rate is not exact");
  uart_divider() = pico::kUartDivider64 / 64;
  uart_fraction() = pico::kUartDivider64 % 64;
  // 8N1 without the FIFOs: they report bytes up to 64 us late, which would disturb the clock sync.
  uart_line() = 3 << 5;
  uart_control() = mask(0) | mask(8) | mask(9);
  uart_mask() = kUartRx;
  gpio_control(kTx) = kUart;
  gpio_control(kRx) = kUart;
}

void begin_encoders() {
  for (unsigned pin = kLeftA; pin < kRightA + 2; ++pin) {
    pad(pin) = kPadInput | kPadPullUp | kPadSchmitt;
    gpio_control(pin) = kSio;
  }
  left_encoder.phase = phase(kLeftA);
  right_encoder.phase = phase(kRightA);
  for (unsigned pin = kLeftA; pin < kRightA + 2; ++pin) {
    gpio_interrupt(pin) = both_edges(pin);
    set_of(gpio_interrupt_enable(pin)) = both_edges(pin);
  }
}

void begin_i2c() {
  i2c_enable() = 0;
  // Master, 7-bit addresses, fast mode, restarts, no slave (4.3.10.2.1).
  i2c_config() = mask(0) | 2 << 1 | mask(5) | mask(6) | mask(8);
  const uint32_t period = pico::kSysHz / kI2cHz;
  i2c_low() = period * 3 / 5;
  i2c_high() = period - period * 3 / 5;
  i2c_spike() = period * 3 / 5 / 16;
  // SDA holds 300 ns after SCL falls.
  i2c_hold() = pico::kSysHz / 1000000 * 3 / 10;
  i2c_enable() = 1;
  for (unsigned pin = kSda; pin <= kScl; ++pin) {
    pad(pin) = kPadInput | kPadPullUp | kPadSchmitt | kPad4mA;
    gpio_control(pin) = kI2c;
  }
}

void begin_adc() {
  pad(kBattery) = kPadNoOutput;
  gpio_control(kBattery) = kNoFunction;
  adc_control() = kAdcOn;
  wait_for(adc_control(), kAdcReady);
  adc_control() = kAdcOn | kAdcStart;
}

void set_priority(unsigned irq, uint32_t priority) {
  interrupt_priority(irq) |= priority << (8 * (irq % 4) + 6);
}

void begin_interrupts() {
  // Priorities: the UART holds one received byte for 20 us; an edge may wait longer, the tick
  // longest.
  set_priority(kIrqGpio, 1);
  systick_priority() = static_cast<uint32_t>(2) << 30;
  interrupt_enable() = mask(kIrqGpio) | mask(kIrqUart0);
}

void wait_us(uint32_t us) {
  const uint32_t from = timer_low();
  while (timer_low() - from < us) {
  }
}

// Hashes the phase of the ring oscillator against the crystal over half a millisecond, which
// differs at each boot.
uint32_t new_nonce() {
  uint32_t hash = 0x811C9DC5;
  for (unsigned i = 0; i < 256; ++i) {
    wait_us(2);
    hash = (hash ^ (rosc_random_bit() + 2 * timer_low())) * 0x01000193;
  }
  hash ^= hash >> 15;
  return hash != 0 ? hash : 1;
}

// Open drain: the line is pulled low by making it an output.
void pull(unsigned pin) { gpio_enable_set() = mask(pin); }
void release(unsigned pin) { gpio_enable_clear() = mask(pin); }

}  // namespace

void PicoHal::begin() {
  begin_outputs();
  begin_clocks();
  begin_watchdog(*this);
  begin_peripherals();
  begin_pwm();
  begin_uart();
  begin_encoders();
  begin_i2c();
  begin_adc();
  nonce_ = new_nonce();
  begin_interrupts();
}

void PicoHal::on_uart() {
  while ((uart_flags() & kUartRxEmpty) == 0) {
    const uint8_t byte = static_cast<uint8_t>(uart_data());
    const uint8_t head = received_head;
    const uint8_t next = static_cast<uint8_t>(head + 1);
    // A full ring drops the byte; the frame's CRC reveals it.
    if (next == received_tail) continue;
    received[head] = byte;
    received_head = next;
    if (byte == wire::kDelimiter || next % 32 == 0) work_ = true;
  }
  while (sending_tail != sending_head && (uart_flags() & kUartTxFull) == 0) {
    uart_data() = sending[sending_tail];
    sending_tail = static_cast<uint8_t>(sending_tail + 1);
  }
  if (sending_tail == sending_head) clear_of(uart_mask()) = kUartTx;
}

void PicoHal::on_edge() {
  // Acknowledged before the phases are read, so that a later edge raises the interrupt again.
  gpio_interrupt(kLeftA) = both_edges(kLeftA) | both_edges(kLeftA + 1);
  gpio_interrupt(kRightA) = both_edges(kRightA) | both_edges(kRightA + 1);
  take_edge<1>(left_encoder, phase(kLeftA));
  take_edge<1>(right_encoder, phase(kRightA));
}

void PicoHal::outputs_off() {
  gpio_control(kLeftEnable) = kSio;
  gpio_control(kRightEnable) = kSio;
  gpio_out_clear() = kDirections | kEnables;
}

uint32_t PicoHal::micros() { return timer_low(); }

bool PicoHal::uart_read(uint8_t& byte) {
  const uint8_t tail = received_tail;
  if (tail == received_head) return false;
  byte = received[tail];
  received_tail = static_cast<uint8_t>(tail + 1);
  return true;
}

uint8_t PicoHal::uart_waiting() { return static_cast<uint8_t>(sending_head - sending_tail); }

uint8_t PicoHal::uart_room() { return static_cast<uint8_t>(255 - uart_waiting()); }

void PicoHal::uart_write(const uint8_t* bytes, uint8_t size) {
  uint8_t head = sending_head;
  for (uint8_t i = 0; i < size; ++i) {
    sending[head] = bytes[i];
    head = static_cast<uint8_t>(head + 1);
  }
  const CriticalSection section(*this);
  sending_head = head;
  // The interrupt comes when a byte has left, so the first one is written here (4.2.6).
  if (size > 0) on_uart();
  if (sending_tail != sending_head) set_of(uart_mask()) = kUartTx;
}

bool PicoHal::i2c_transfer(uint8_t address, const uint8_t* out, uint8_t out_size, uint8_t* in,
                           uint8_t in_size) {
  const uint32_t began_us = micros();
  i2c_enable() = 0;
  i2c_target() = address;
  i2c_enable() = 1;
  (void)static_cast<uint32_t>(i2c_clear_all());
  const uint8_t all = static_cast<uint8_t>(out_size + in_size);
  uint8_t asked = 0;
  uint8_t got = 0;
  for (;;) {
    if ((i2c_interrupts() & kI2cAborted) != 0 || micros() - began_us > kI2cTimeoutUs) break;
    if (asked < all && i2c_waiting() < 8) {
      const bool reads = asked >= out_size;
      uint32_t entry = reads ? kI2cRead : out[asked];
      if (reads && asked == out_size && out_size > 0) entry |= kI2cRestart;
      if (asked + 1 == all) entry |= kI2cStop;
      i2c_data() = entry;
      ++asked;
    }
    while (i2c_received() > 0 && got < in_size) in[got++] = static_cast<uint8_t>(i2c_data());
    if (asked == all && got == in_size && (i2c_interrupts() & kI2cStopped) != 0) return true;
  }
  (void)static_cast<uint32_t>(i2c_clear_abort());
  i2c_enable() = 0;
  return false;
}

bool PicoHal::i2c_write(uint8_t address, uint8_t reg, uint8_t value) {
  const uint8_t bytes[] = {reg, value};
  return i2c_transfer(address, bytes, sizeof bytes, nullptr, 0);
}

bool PicoHal::i2c_read(uint8_t address, uint8_t reg, uint8_t* bytes, uint8_t size) {
  return i2c_transfer(address, &reg, 1, bytes, size);
}

void PicoHal::i2c_recover() {
  i2c_enable() = 0;
  gpio_out_clear() = mask(kSda) | mask(kScl);
  release(kSda);
  release(kScl);
  gpio_control(kSda) = kSio;
  gpio_control(kScl) = kSio;
  // A device cut off in the middle of a byte releases SDA within nine clocks; a STOP follows.
  for (uint8_t i = 0; i < 9; ++i) {
    pull(kScl);
    wait_us(3);
    release(kScl);
    wait_us(3);
  }
  pull(kScl);
  pull(kSda);
  wait_us(3);
  release(kScl);
  wait_us(3);
  release(kSda);
  wait_us(3);
  begin_i2c();
}

void PicoHal::counts(int32_t& left, int32_t& right) {
  const CriticalSection section(*this);
  left = extended_counts(left_encoder);
  right = extended_counts(right_encoder);
}

uint16_t PicoHal::missed_edges() {
  const CriticalSection section(*this);
  return static_cast<uint16_t>(left_encoder.missed + right_encoder.missed);
}

void PicoHal::motors(int16_t left, int16_t right) {
  const CriticalSection section(*this);
  uint32_t directions = 0;
  if (left > 0) directions |= mask(kLeftForward);
  if (left < 0) directions |= mask(kLeftBack);
  if (right > 0) directions |= mask(kRightForward);
  if (right < 0) directions |= mask(kRightBack);
  gpio_out_clear() = kDirections & ~directions;
  // A new level takes effect at the end of the PWM's period, but a motor with both inputs low
  // coasts at once.
  pwm7_levels() = static_cast<uint32_t>(pico::pwm_level(right)) << 16 | pico::pwm_level(left);
  gpio_out_set() = directions;
}

uint16_t PicoHal::battery_mv() {
  if ((adc_control() & kAdcReady) == 0) return battery_mv_;
  battery_mv_ = pico::battery_mv(static_cast<uint16_t>(adc_result()));
  adc_control() = kAdcOn | kAdcStart;
  return battery_mv_;
}

// The counter falls by two per microsecond (erratum RP2040-E1).
void PicoHal::kick_watchdog() { watchdog_load() = 2 * kWatchdogUs; }

wire::ResetCause PicoHal::reset_cause() {
  if ((watchdog_reason() & 3) != 0) return wire::ResetCause::kWatchdog;
  const uint32_t cause = chip_reset();
  // A brown-out counts as power-on here: the chip has one flag for both (2.12.8).
  if ((cause & mask(8)) != 0) return wire::ResetCause::kPowerOn;
  if ((cause & (mask(16) | mask(20))) != 0) return wire::ResetCause::kExternal;
  return wire::ResetCause::kUnknown;
}

uint8_t PicoHal::lock() {
  uint32_t saved;
  __asm__ volatile("mrs %0, primask\n cpsid i" : "=r"(saved)::"memory");
  return static_cast<uint8_t>(saved);
}

void PicoHal::unlock(uint8_t saved) {
  __asm__ volatile("msr primask, %0" ::"r"(static_cast<uint32_t>(saved)) : "memory");
}

void PicoHal::idle() {
  if (received_head != received_tail) return;
  for (;;) {
    const uint8_t saved = lock();
    const bool work = work_;
    // wfi also wakes for an interrupt that is pending while interrupts are off, so that none is
    // missed.
    if (!work) __asm__ volatile("wfi" ::: "memory");
    if (work) work_ = false;
    unlock(saved);
    if (work) return;
  }
}

}  // namespace firmware
}  // namespace tp100
