// Fuzzes the frame decoders of both sides with any bytes; frames from the encoder must decode to
// the same content.

#include <algorithm>

#include "../wire/all_messages.h"
#include "byte_source.h"
#include "core/link_state.h"
#include "link/frame_reader.h"
#include "wire/frame.h"
#include "wire/messages.h"

namespace tp100 {
namespace {

using fuzz::ByteSource;
using fuzz::require;

template <class Message>
void read_and_write(const std::uint8_t* payload, std::size_t size) {
  Message message{};
  if (!wire::read_payload(payload, size, message)) {
    require(size != Message::kSize, "a payload of the right size is a message");
    return;
  }
  std::uint8_t again[Message::kSize];
  wire::write_payload(message, again);
  require(std::equal(again, again + Message::kSize, payload),
          "a message is written as it was read");
}

void read_as_every_message(const std::uint8_t* payload, std::size_t size) {
  wire::for_each_message([&](const char*, const auto& message) {
    read_and_write<std::decay_t<decltype(message)>>(payload, size);
  });
}

void raw(std::span<const std::uint8_t> bytes) {
  LinkCounters counters{};
  link::FrameReader reader(counters);
  for (const std::uint8_t byte : bytes) {
    if (!reader.push(byte)) continue;
    require(reader.size() <= wire::kMaxPayload, "a payload is never larger than its buffer");
    read_as_every_message(reader.payload(), reader.size());
  }
}

// An encoded frame contains no delimiter except its last byte, after which every decoder is
// synchronised.
void round_trip(std::uint8_t type, std::span<const std::uint8_t> rest) {
  const std::span<const std::uint8_t> payload =
      rest.first(std::min<std::size_t>(rest.size(), wire::kMaxPayload));
  std::uint8_t frame[wire::kMaxFrame];
  const std::size_t length = wire::encode_frame(type, payload.data(), payload.size(), frame);
  require(length >= 5 && length <= wire::kMaxFrame, "a frame fits its buffer");
  require(std::find(frame, frame + length, wire::kDelimiter) == frame + length - 1,
          "only the end of a frame is zero");
  wire::FrameDecoder decoder;
  wire::DecodeResult received = wire::DecodeResult::kNothing;
  for (std::size_t i = 0; i < length; ++i) received = decoder.push(frame[i]);
  require(received == wire::DecodeResult::kFrame && decoder.type() == type &&
              decoder.size() == payload.size() &&
              std::equal(payload.begin(), payload.end(), decoder.payload()),
          "a frame comes back as it was");
  read_as_every_message(decoder.payload(), decoder.size());
}

}  // namespace
}  // namespace tp100

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tp100::fuzz::ByteSource source(data, size);
  const std::uint8_t type = source.u8();
  const std::span<const std::uint8_t> rest = source.bytes(size);
  tp100::raw(rest);
  tp100::round_trip(type, rest);
  return 0;
}
