#pragma once
// UART 0 of the emulated Mega with true byte times. Receiving follows the datasheet: a buffer of
// two bytes and the shift register; a byte that arrives while all three are full is lost.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "sim/board/avr_core.h"

struct avr_irq_t;
struct avr_uart_t;

namespace tp100::sim {

/// A sent byte with the cycle at which its stop bit ends.
struct SentByte {
  CpuCycles at;
  std::uint8_t value;
};

class AvrUart {
 public:
  explicit AvrUart(AvrCore& core);

  /// A byte arrives at the chip: its stop bit ends now.
  void receive(std::uint8_t value);
  /// Bytes sent since the last take, including those still in transmission.
  std::vector<SentByte>& sent() { return sent_; }
  /// Call after a reset of the chip.
  void restore();

  std::uint64_t overruns() const { return overruns_; }

 private:
  static void on_baud(avr_irq_t*, std::uint32_t, void* uart);
  static void on_send(avr_irq_t*, std::uint32_t value, void* uart);
  static std::uint8_t on_read(avr_t*, std::uint16_t address, void* uart);
  CpuCycles byte_cycles() const;

  AvrCore& core_;
  avr_uart_t* uart_;
  std::deque<std::uint8_t> received_;
  std::vector<SentByte> sent_;
  CpuCycles transmitter_free_ = 0;
  std::uint64_t overruns_ = 0;
};

}  // namespace tp100::sim
