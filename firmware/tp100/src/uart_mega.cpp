#include "uart_mega.h"

#if defined(__AVR__)

#include <avr/interrupt.h>
#include <avr/io.h>

#include "hal_mega.h"
#include "wire/frame.h"

namespace {

// 8-bit indices wrap by themselves; one place stays free to distinguish full from empty.
uint8_t received[256];
volatile uint8_t received_head;
volatile uint8_t received_tail;
// Frame ends put into the ring and taken out of it.
volatile uint8_t frames_in;
volatile uint8_t frames_out;
uint8_t sending[256];
volatile uint8_t sending_head;
volatile uint8_t sending_tail;

// This many bytes without a frame end mean that a host floods the line.
const uint8_t kMany = 32;

}  // namespace

ISR(USART0_RX_vect) {
  const uint8_t byte = UDR0;
  const uint8_t head = received_head;
  const uint8_t next = static_cast<uint8_t>(head + 1);
  // A full ring drops the byte; the frame's CRC reveals it.
  if (next == received_tail) return;
  received[head] = byte;
  received_head = next;
  if (byte == tp100::wire::kDelimiter) {
    frames_in = static_cast<uint8_t>(frames_in + 1);
    tp100::firmware::raise_work();
  } else if (next % kMany == 0) {
    tp100::firmware::raise_work();
  }
}

ISR(USART0_UDRE_vect) {
  const uint8_t tail = sending_tail;
  UDR0 = sending[tail];
  const uint8_t next = static_cast<uint8_t>(tail + 1);
  sending_tail = next;
  if (next == sending_head) UCSR0B = _BV(RXEN0) | _BV(TXEN0) | _BV(RXCIE0);
}

namespace tp100 {
namespace firmware {
namespace uart_mega {

void begin() {
  static_assert(F_CPU % (8 * wire::kBaud) == 0, "the baud rate is not exact with this crystal");
  UCSR0A = _BV(U2X0);
  UBRR0 = F_CPU / (8 * wire::kBaud) - 1;
  UCSR0C = _BV(UCSZ01) | _BV(UCSZ00);
  UCSR0B = _BV(RXEN0) | _BV(TXEN0) | _BV(RXCIE0);
}

bool worth_reading() {
  return frames_in != frames_out || static_cast<uint8_t>(received_head - received_tail) >= kMany;
}

uint8_t read(uint8_t* bytes, uint8_t most) {
  const uint8_t head = received_head;
  uint8_t tail = received_tail;
  uint8_t size = 0;
  while (size < most && tail != head) {
    const uint8_t byte = received[tail];
    tail = static_cast<uint8_t>(tail + 1);
    bytes[size++] = byte;
    if (byte != wire::kDelimiter) continue;
    frames_out = static_cast<uint8_t>(frames_out + 1);
    break;
  }
  received_tail = tail;
  return size;
}

uint8_t waiting() { return static_cast<uint8_t>(sending_head - sending_tail); }

uint8_t room() { return static_cast<uint8_t>(255 - waiting()); }

void write(const uint8_t* bytes, uint8_t size) {
  if (size == 0) return;
  uint8_t head = sending_head;
  for (uint8_t i = 0; i < size; ++i) {
    sending[head] = bytes[i];
    head = static_cast<uint8_t>(head + 1);
  }
  const uint8_t saved = SREG;
  cli();
  sending_head = head;
  UCSR0B = _BV(RXEN0) | _BV(TXEN0) | _BV(RXCIE0) | _BV(UDRIE0);
  SREG = saved;
}

}  // namespace uart_mega
}  // namespace firmware
}  // namespace tp100

#endif
