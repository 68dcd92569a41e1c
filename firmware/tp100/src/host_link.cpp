#include "host_link.h"

namespace tp100 {
namespace firmware {
namespace {

const uint32_t kByteUs = 10UL * 1000000UL / wire::kBaud;

// COBS adds one byte to a body below 255 bytes and the delimiter follows, so that the length is
// known before encoding.
constexpr uint8_t frame_length(uint8_t payload_size) {
  return static_cast<uint8_t>(1 + payload_size + 2 + 2);
}

}  // namespace

bool HostLink::receive(uint8_t& budget) {
  uint8_t bytes[kMostReceived];
  while (const uint8_t size = hal_.uart_read(bytes, budget)) {
    budget = static_cast<uint8_t>(budget - size);
    const uint32_t now_us = bytes[size - 1] == wire::kDelimiter ? hal_.micros() : 0;
    switch (decoder_.push(bytes, size)) {
      case wire::DecodeResult::kNothing:
        break;
      case wire::DecodeResult::kFrame:
        received_us_ = now_us;
        ++counts_.good;
        return true;
      case wire::DecodeResult::kOversize:
        ++counts_.oversize;
        break;
      case wire::DecodeResult::kCobs:
        ++counts_.cobs;
        break;
      case wire::DecodeResult::kShort:
        ++counts_.undersize;
        break;
      case wire::DecodeResult::kCrc:
        ++counts_.crc;
        break;
    }
  }
  return false;
}

bool HostLink::send(uint8_t type, const uint8_t* payload, uint8_t size) {
  const uint8_t length = frame_length(size);
  if (hal_.uart_room() < length) return false;
  uint8_t frame[wire::kMaxFrame];
  wire::encode_frame(type, payload, size, frame);
  hal_.uart_write(frame, length);
  return true;
}

void HostLink::post(const wire::Sample& sample) {
  if (sample_.size > 0) ++counts_.unsent;
  sample_.push_over(sample);
  flush();
}

void HostLink::post(const wire::Hello& hello) {
  hello_.push_over(hello);
  flush();
}

void HostLink::post(const wire::SyncReply& reply) {
  if (sync_.size > 0) ++counts_.unsent;
  sync_.push_over(reply);
  flush();
}

void HostLink::post(const wire::Acknowledge& acknowledge) {
  if (!acknowledges_.push(acknowledge)) ++counts_.unsent;
  flush();
}

void HostLink::post(const wire::FaultReport& report) {
  if (!reports_.push(report)) ++counts_.unsent;
  flush();
}

void HostLink::post(const wire::Log& log) {
  if (!logs_.push(log)) ++counts_.unsent;
  flush();
}

void HostLink::log(uint8_t level, const char* text, const char* more, uint32_t at_us) {
  wire::Log message = {};
  message.device_us = at_us;
  message.level = level;
  uint8_t at = 0;
  for (; *text != 0 && at < wire::Log::kTextSize; ++text)
    message.text[at++] = static_cast<uint8_t>(*text);
  for (; *more != 0 && at < wire::Log::kTextSize; ++more)
    message.text[at++] = static_cast<uint8_t>(*more);
  post(message);
}

void HostLink::flush() {
  if (!flush_sync() || !flush(acknowledges_) || !flush(sample_)) return;
  if (!flush(reports_) || !flush_hello()) return;
  flush(logs_);
}

bool HostLink::flush_sync() {
  if (sync_.size == 0) return true;
  wire::SyncReply& reply = sync_.items[sync_.first];
  reply.sent_us = hal_.micros() + hal_.uart_waiting() * kByteUs;
  return flush(sync_);
}

bool HostLink::flush_hello() {
  if (hello_.size == 0) return true;
  if (hal_.uart_room() < 1 + frame_length(wire::Hello::kSize)) return false;
  hal_.uart_write(&wire::kDelimiter, 1);
  return flush(hello_);
}

template <class Message, uint8_t kCapacity>
bool HostLink::flush(Queue<Message, kCapacity>& queue) {
  while (queue.size > 0) {
    if (!send(queue.items[queue.first])) return false;
    queue.pop();
  }
  return true;
}

}  // namespace firmware
}  // namespace tp100
