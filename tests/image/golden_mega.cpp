// Runs on the ATmega2560: decodes every golden frame, checks some values, encodes it again and
// sends it.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <avr/sleep.h>

#include "golden_frames.h"
#include "wire/frame.h"
#include "wire/messages.h"

using namespace tp100::wire;

namespace {

void send(const uint8_t* bytes, size_t size) {
  for (size_t i = 0; i < size; ++i) {
    while ((UCSR0A & _BV(UDRE0)) == 0) {
    }
    UDR0 = bytes[i];
  }
}

template <class Message>
bool plausible(const Message&) {
  return true;
}
bool plausible(const Sample& m) {
  return m.left_counts == 123456 && m.right_counts == -7890 && m.gyro[2] == INT16_MIN;
}
bool plausible(const Command& m) { return m.speed_mps == 0.2f && m.desired_yaw_rad == -2.75f; }
bool plausible(const Parameters& m) { return m.wheelbase_m == 0.2742f && m.flags == 0x25; }
bool plausible(const FaultReport& m) { return m.detail == -412; }

template <class Message>
void recode(const FrameDecoder& decoder) {
  // This processor needs no padding, so the structures have the sizes in the tables.
  static_assert(sizeof(Message) == Message::kSize, "another size than stated");
  Message message;
  if (!read_payload(decoder.payload(), decoder.size(), message) || !plausible(message)) return;
  uint8_t payload[Message::kSize];
  uint8_t frame[kMaxFrame];
  write_payload(message, payload);
  send(frame, encode_frame(static_cast<uint8_t>(Message::kType), payload, Message::kSize, frame));
}

void recode(const FrameDecoder& decoder) {
  switch (static_cast<Type>(decoder.type())) {
    case Type::kHello:
      return recode<Hello>(decoder);
    case Type::kSample:
      return recode<Sample>(decoder);
    case Type::kAcknowledge:
      return recode<Acknowledge>(decoder);
    case Type::kSyncReply:
      return recode<SyncReply>(decoder);
    case Type::kFaultReport:
      return recode<FaultReport>(decoder);
    case Type::kLog:
      return recode<Log>(decoder);
    case Type::kHelloRequest:
      return recode<HelloRequest>(decoder);
    case Type::kParameters:
      return recode<Parameters>(decoder);
    case Type::kCommand:
      return recode<Command>(decoder);
    case Type::kArm:
      return recode<Arm>(decoder);
    case Type::kDisarm:
      return recode<Disarm>(decoder);
    case Type::kStop:
      return recode<Stop>(decoder);
    case Type::kSyncRequest:
      return recode<SyncRequest>(decoder);
  }
}

}  // namespace

int main() {
  UCSR0A = _BV(U2X0);
  UBRR0 = F_CPU / (8 * kBaud) - 1;
  UCSR0B = _BV(TXEN0);
  FrameDecoder decoder;
  for (size_t i = 0; i < sizeof golden_frames; ++i) {
    if (decoder.push(pgm_read_byte(&golden_frames[i])) == DecodeResult::kFrame) recode(decoder);
  }
  while ((UCSR0A & _BV(TXC0)) == 0) {
  }
  cli();
  sleep_mode();
}
