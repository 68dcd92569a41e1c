#include "sim/board/avr_uart.h"

#include <avr_uart.h>
#include <sim_avr.h>

#include <algorithm>

namespace tp100::sim {
namespace {

constexpr std::uint16_t kUbrr0l = 0xC4;
constexpr std::uint16_t kUbrr0h = 0xC5;
constexpr CpuCycles kFrameBits = 10;  // 8N1
constexpr std::size_t kReceiver = 3;

avr_uart_t* uart_of(avr_io_t* io) { return reinterpret_cast<avr_uart_t*>(io); }

}  // namespace

AvrUart::AvrUart(AvrCore& core)
    : core_(core),
      uart_(uart_of(core.module("uart", [](avr_io_t* io) { return uart_of(io)->name == '0'; }))) {
  avr_t* avr = core.chip();
  // No echo on the console, no sleeping on the host while the chip polls.
  uart_->flags = 0;
  avr_irq_register_notify(avr_iomem_getirq(avr, kUbrr0l, nullptr, AVR_IOMEM_IRQ_ALL), on_baud,
                          this);
  avr_irq_register_notify(uart_->io.irq + UART_IRQ_OUTPUT, on_send, this);
  // Set directly: simavr would abort if asked to replace its own handler.
  avr->io[AVR_DATA_TO_IO(uart_->r_udr)].r = {this, on_read};
}

CpuCycles AvrUart::byte_cycles() const {
  const std::uint8_t* data = core_.data();
  const CpuCycles divider = (data[kUbrr0h] & 0x0FU) * 256U + data[kUbrr0l] + 1U;
  return kFrameBits * divider * (avr_regbit_get(core_.chip(), uart_->u2x) != 0 ? 8U : 16U);
}

// simavr includes a parity bit, which 8N1 does not have.
void AvrUart::on_baud(avr_irq_t*, std::uint32_t, void* self) {
  AvrUart& uart = *static_cast<AvrUart*>(self);
  uart.uart_->cycles_per_byte = uart.byte_cycles();
}

void AvrUart::on_send(avr_irq_t*, std::uint32_t value, void* self) {
  AvrUart& uart = *static_cast<AvrUart*>(self);
  const CpuCycles byte = uart.byte_cycles();
  uart.uart_->cycles_per_byte = byte;
  uart.transmitter_free_ = std::max(uart.transmitter_free_, uart.core_.cycle()) + byte;
  uart.sent_.push_back({uart.transmitter_free_, static_cast<std::uint8_t>(value)});
}

void AvrUart::receive(std::uint8_t value) {
  avr_t* avr = core_.chip();
  if (avr_regbit_get(avr, uart_->rxen) == 0) return;
  if (received_.size() >= kReceiver) {
    ++overruns_;
    return;
  }
  received_.push_back(value);
  avr_raise_interrupt(avr, &uart_->rxc);
}

std::uint8_t AvrUart::on_read(avr_t* avr, std::uint16_t address, void* self) {
  AvrUart& uart = *static_cast<AvrUart*>(self);
  if (!uart.received_.empty()) {
    avr->data[address] = uart.received_.front();
    uart.received_.pop_front();
  }
  if (uart.received_.empty()) {
    avr_clear_interrupt(avr, &uart.uart_->rxc);
    avr_regbit_clear(avr, uart.uart_->rxc.raised);
  } else {
    avr_raise_interrupt(avr, &uart.uart_->rxc);
  }
  return avr->data[address];
}

void AvrUart::restore() {
  received_.clear();
  // Bytes not completely sent never arrive.
  const CpuCycles now = core_.cycle();
  while (!sent_.empty() && sent_.back().at > now) sent_.pop_back();
  transmitter_free_ = now;
}

}  // namespace tp100::sim
