// Registers of the RP2040, as far as the firmware needs them. Section numbers are those of the
// RP2040 data sheet (Raspberry Pi Ltd); those of the core are in ARM's "Cortex-M0+ Devices Generic
// User Guide".
#ifndef TP100_FIRMWARE_RP2040_H
#define TP100_FIRMWARE_RP2040_H

#include <stdint.h>

namespace tp100 {
namespace firmware {
namespace rp2040 {

typedef volatile uint32_t Register;

inline Register& at(uint32_t address) { return *reinterpret_cast<Register*>(address); }
/// A write here sets, or clears, only the bits that are written (2.1.2).
inline Register& set_of(Register& r) { return at(reinterpret_cast<uint32_t>(&r) + 0x2000); }
inline Register& clear_of(Register& r) { return at(reinterpret_cast<uint32_t>(&r) + 0x3000); }

constexpr uint32_t mask(unsigned bit) { return static_cast<uint32_t>(1) << bit; }

// Single-cycle input and output (2.3.1.7).
inline Register& gpio_in() { return at(0xd0000004); }
inline Register& gpio_out_set() { return at(0xd0000014); }
inline Register& gpio_out_clear() { return at(0xd0000018); }
inline Register& gpio_enable_set() { return at(0xd0000024); }
inline Register& gpio_enable_clear() { return at(0xd0000028); }

// Functions of pins (2.19.2), their pads and their interrupts (2.19.6).
enum Function : uint32_t { kUart = 2, kI2c = 3, kPwm = 4, kSio = 5, kNoFunction = 31 };
inline Register& gpio_control(unsigned pin) { return at(0x40014004 + 8 * pin); }
inline Register& pad(unsigned pin) { return at(0x4001c004 + 4 * pin); }
const uint32_t kPadPullUp = mask(3), kPadInput = mask(6);
const uint32_t kPadNoOutput = mask(7), kPadSchmitt = mask(1), kPad4mA = mask(4);
/// Eight pins per register, four bits per pin.
inline Register& gpio_interrupt(unsigned pin) { return at(0x400140f0 + 4 * (pin / 8)); }
inline Register& gpio_interrupt_enable(unsigned pin) { return at(0x40014100 + 4 * (pin / 8)); }
constexpr uint32_t both_edges(unsigned pin) {
  return static_cast<uint32_t>(0xC) << (4 * (pin % 8));
}

// Resets of the peripherals (2.14.3).
inline Register& reset() { return at(0x4000c000); }
inline Register& reset_done() { return at(0x4000c008); }
const uint32_t kResetAdc = mask(0), kResetI2c0 = mask(3), kResetIoBank0 = mask(5);
const uint32_t kResetPadsBank0 = mask(8), kResetPllSys = mask(12), kResetPllUsb = mask(13);
const uint32_t kResetPwm = mask(14), kResetTimer = mask(21), kResetUart0 = mask(22);

// Clocks (2.15.7), crystal (2.16.7), ring oscillator (2.17.8), PLLs (2.18.4).
inline Register& clk_ref_control() { return at(0x40008030); }
inline Register& clk_ref_selected() { return at(0x40008038); }
inline Register& clk_sys_control() { return at(0x4000803c); }
inline Register& clk_sys_selected() { return at(0x40008044); }
inline Register& clk_peri_control() { return at(0x40008048); }
inline Register& clk_adc_control() { return at(0x40008060); }
const uint32_t kClockEnable = mask(11);
inline Register& xosc_control() { return at(0x40024000); }
inline Register& xosc_status() { return at(0x40024004); }
inline Register& xosc_startup() { return at(0x4002400c); }
inline Register& rosc_random_bit() { return at(0x4006001c); }
const uint32_t kPllSys = 0x40028000, kPllUsb = 0x4002c000;
inline Register& pll_status(uint32_t pll) { return at(pll); }
inline Register& pll_power(uint32_t pll) { return at(pll + 0x4); }
inline Register& pll_feedback(uint32_t pll) { return at(pll + 0x8); }
inline Register& pll_dividers(uint32_t pll) { return at(pll + 0xc); }

// Parts that the watchdog restarts (2.13.5), cause of the chip's reset (2.12.8), watchdog (4.7.6),
// timer (4.6.5).
inline Register& watchdog_restarts() { return at(0x40010008); }
inline Register& chip_reset() { return at(0x40064008); }
inline Register& watchdog_control() { return at(0x40058000); }
inline Register& watchdog_load() { return at(0x40058004); }
inline Register& watchdog_reason() { return at(0x40058008); }
inline Register& watchdog_tick() { return at(0x4005802c); }
inline Register& timer_low() { return at(0x40054028); }

// UART 0 (4.2.8).
inline Register& uart_data() { return at(0x40034000); }
inline Register& uart_flags() { return at(0x40034018); }
inline Register& uart_divider() { return at(0x40034024); }
inline Register& uart_fraction() { return at(0x40034028); }
inline Register& uart_line() { return at(0x4003402c); }
inline Register& uart_control() { return at(0x40034030); }
inline Register& uart_mask() { return at(0x40034038); }
const uint32_t kUartRxEmpty = mask(4), kUartTxFull = mask(5);
const uint32_t kUartRx = mask(4), kUartTx = mask(5);

// I2C 0 (4.3.17).
inline Register& i2c_config() { return at(0x40044000); }
inline Register& i2c_target() { return at(0x40044004); }
inline Register& i2c_data() { return at(0x40044010); }
inline Register& i2c_high() { return at(0x4004401c); }
inline Register& i2c_low() { return at(0x40044020); }
inline Register& i2c_interrupts() { return at(0x40044034); }
inline Register& i2c_clear_all() { return at(0x40044040); }
inline Register& i2c_clear_abort() { return at(0x40044054); }
inline Register& i2c_enable() { return at(0x4004406c); }
inline Register& i2c_waiting() { return at(0x40044074); }
inline Register& i2c_received() { return at(0x40044078); }
inline Register& i2c_hold() { return at(0x4004407c); }
inline Register& i2c_spike() { return at(0x400440a0); }
const uint32_t kI2cRead = mask(8), kI2cStop = mask(9), kI2cRestart = mask(10);
const uint32_t kI2cAborted = mask(6), kI2cStopped = mask(9);

// ADC (4.9.6), PWM slice 7 (4.5.3).
inline Register& adc_control() { return at(0x4004c000); }
inline Register& adc_result() { return at(0x4004c004); }
const uint32_t kAdcOn = mask(0), kAdcStart = mask(2), kAdcReady = mask(8);
inline Register& pwm7_control() { return at(0x4005008c); }
inline Register& pwm7_divider() { return at(0x40050090); }
inline Register& pwm7_levels() { return at(0x40050098); }
inline Register& pwm7_top() { return at(0x4005009c); }

// The core: SysTick, interrupt controller, priorities.
inline Register& systick_control() { return at(0xe000e010); }
inline Register& systick_reload() { return at(0xe000e014); }
inline Register& systick_count() { return at(0xe000e018); }
inline Register& interrupt_enable() { return at(0xe000e100); }
inline Register& interrupt_priority(unsigned irq) { return at(0xe000e400 + 4 * (irq / 4)); }
inline Register& systick_priority() { return at(0xe000ed20); }
const unsigned kIrqGpio = 13, kIrqUart0 = 20;

}  // namespace rp2040
}  // namespace firmware
}  // namespace tp100

#endif
