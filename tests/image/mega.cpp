#include "mega.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wold-style-cast"
extern "C" {
#include <avr_adc.h>
#include <avr_extint.h>
#include <avr_ioport.h>
#include <avr_uart.h>
#include <sim_avr.h>
#include <sim_elf.h>
}

#include <algorithm>
#include <stdexcept>

namespace tp100::image {
namespace {

constexpr std::uint64_t kCyclesPerMs = 16000;
// simavr takes a byte of 8N1 for eleven bits.
constexpr std::uint64_t kCyclesPerByte = 352;
constexpr std::uint32_t kBatteryAtPinMv = 2500;

avr_irq_t* uart_irq(avr_t* avr, int irq) {
  return avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), irq);
}

avr_irq_t* pin_irq(avr_t* avr, char port, int pin) {
  return avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ(port), pin);
}

// simavr lets the pull-up win over the driven level at any write to the port, unless told.
void drive_pins(avr_t* avr, char port, int a_pin, int b_pin, bool a, bool b) {
  avr_ioport_external_t external{};
  external.name = static_cast<unsigned char>(port);
  external.mask = static_cast<unsigned char>((1 << a_pin) | (1 << b_pin));
  external.value = static_cast<unsigned char>((a ? 1 << a_pin : 0) | (b ? 1 << b_pin : 0));
  avr_ioctl(avr, AVR_IOCTL_IOPORT_SET_EXTERNAL(port), &external);
  avr_raise_irq(pin_irq(avr, port, a_pin), a ? 1 : 0);
  avr_raise_irq(pin_irq(avr, port, b_pin), b ? 1 : 0);
}

}  // namespace

Mega::Mega(const std::string& elf) : avr_(avr_make_mcu_by_name("atmega2560")) {
  elf_firmware_t firmware{};
  if (avr_ == nullptr || elf_read_firmware(elf.c_str(), &firmware) != 0) {
    throw std::runtime_error(elf + ": no image; build the target tp100_image");
  }
  avr_init(avr_);
  avr_load_firmware(avr_, &firmware);
  avr_->frequency = 1000 * kCyclesPerMs;
  avr_->log = LOG_ERROR;
  avr_->vcc = avr_->avcc = avr_->aref = 5000;
  avr_->run_cycle_limit = kCyclesPerMs;
  avr_->sleep = [](avr_t*, avr_cycle_count_t) {};
  // Or it looks at unused interrupt pins in every cycle.
  for (std::uint8_t i = 0; i < 8; ++i) avr_extint_set_strict_lvl_trig(avr_, i, 0);
  std::uint32_t flags = 0;
  avr_ioctl(avr_, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
  avr_irq_register_notify(uart_irq(avr_, UART_IRQ_OUTPUT), on_sent, this);
  avr_raise_irq(avr_io_getirq(avr_, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0), kBatteryAtPinMv);
  avr_cycle_timer_register(avr_, kCyclesPerByte, on_byte_time, this);
  avr_cycle_timer_register(avr_, step_cycles_, on_step_time, this);
}

Mega::~Mega() { avr_terminate(avr_); }

void Mega::run_ms(double ms) {
  const auto end = avr_->cycle + static_cast<std::uint64_t>(ms * kCyclesPerMs);
  while (avr_->cycle < end) {
    const int state = avr_run(avr_);
    if (state == cpu_Done || state == cpu_Crashed) return;
  }
}

double Mega::now_ms() const { return static_cast<double>(avr_->cycle) / kCyclesPerMs; }

void Mega::send(const std::vector<std::uint8_t>& bytes) {
  to_send_.insert(to_send_.end(), bytes.begin(), bytes.end());
}

void Mega::turn(int direction, double period_us) {
  direction_ = direction;
  step_cycles_ = static_cast<std::uint64_t>(period_us * kCyclesPerMs / 1000);
}

void Mega::on_sent(avr_irq_t*, std::uint32_t value, void* self) {
  Mega& mega = *static_cast<Mega*>(self);
  const auto byte = static_cast<std::uint8_t>(value);
  mega.bytes_.push_back(byte);
  const wire::Received received = mega.decoder_.push(byte);
  if (received == wire::Received::kFrame) {
    const std::uint8_t* payload = mega.decoder_.payload();
    mega.frames_.push_back(
        {mega.now_ms(), mega.decoder_.type(), {payload, payload + mega.decoder_.size()}});
  } else if (received != wire::Received::kNothing) {
    ++mega.bad_;
  }
}

std::uint64_t Mega::on_byte_time(avr_t* avr, std::uint64_t when, void* self) {
  Mega& mega = *static_cast<Mega*>(self);
  if (mega.sent_ < mega.to_send_.size()) {
    avr_raise_irq(uart_irq(avr, UART_IRQ_INPUT), mega.to_send_[mega.sent_++]);
  }
  return when + kCyclesPerByte;
}

std::uint64_t Mega::on_step_time(avr_t* avr, std::uint64_t when, void* self) {
  Mega& mega = *static_cast<Mega*>(self);
  mega.quarter_ = (mega.quarter_ + mega.direction_) & 3;
  const bool a = mega.quarter_ == 1 || mega.quarter_ == 2;
  const bool b = mega.quarter_ >= 2;
  drive_pins(avr, 'E', 4, 5, a, b);
  drive_pins(avr, 'D', 3, 2, a, b);
  return when + mega.step_cycles_;
}

const SentFrame& Mega::last_frame(std::uint8_t type) const {
  const auto found = std::find_if(frames_.rbegin(), frames_.rend(),
                                  [&](const SentFrame& frame) { return frame.type == type; });
  if (found == frames_.rend()) throw std::runtime_error("no frame of type " + std::to_string(type));
  return *found;
}

std::size_t Mega::count(wire::Type type) const {
  return static_cast<std::size_t>(std::count_if(
      frames_.begin(), frames_.end(),
      [&](const SentFrame& frame) { return frame.type == static_cast<std::uint8_t>(type); }));
}

namespace {

// Data addresses of the ATmega2560.
constexpr std::uint16_t kPortA = 0x22;
constexpr std::uint16_t kTccr4a = 0xA0;
constexpr std::uint16_t kOcr4aLow = 0xA8;
constexpr std::uint16_t kOcr4bLow = 0xAA;
constexpr std::uint16_t kPortH = 0x102;

}  // namespace

double Mega::duty(unsigned compare_bit, unsigned compare_register, unsigned forward_pin,
                  unsigned enable_pin) const {
  const std::uint8_t* data = avr_->data;
  double size = (data[kPortH] >> enable_pin & 1) != 0 ? 1.0 : 0.0;
  if ((data[kTccr4a] >> compare_bit & 1) != 0) size = data[compare_register] / 255.0;
  const int forward = data[kPortA] >> forward_pin & 1;
  const int backward = data[kPortA] >> (forward_pin + 1) & 1;
  return size * (forward - backward);
}

double Mega::left_duty() const { return duty(7, kOcr4aLow, 0, 3); }
double Mega::right_duty() const { return duty(5, kOcr4bLow, 2, 4); }

bool Mega::motors_off() const {
  const std::uint8_t* data = avr_->data;
  return (data[kTccr4a] & 0xA0) == 0 && (data[kPortH] & 0x18) == 0 && (data[kPortA] & 0x0F) == 0;
}

}  // namespace tp100::image

#pragma GCC diagnostic pop
