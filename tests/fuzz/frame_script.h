#pragma once
// Reads a fuzz input as a script of a peer's actions: raw bytes, frames with a valid CRC and any
// content, and passing time.

#include <vector>

#include "../support/wire_host.h"
#include "byte_source.h"

namespace tp100::fuzz {

/// Calls on_bytes(span), on_time(ms) or on_request(code) for each action of the script. A frame of
/// the input may begin with the four bytes of `nonce`, so that it belongs to this boot.
template <class OnBytes, class OnTime, class OnRequest>
void play(ByteSource& source, std::uint32_t nonce, OnBytes on_bytes, OnTime on_time,
          OnRequest on_request) {
  while (!source.empty()) {
    const std::uint8_t act = source.u8();
    switch (act & 3U) {
      case 0:
        on_bytes(source.bytes(act >> 2U));
        break;
      case 1: {
        const std::uint8_t type = source.u8();
        const std::span<const std::uint8_t> body =
            source.bytes(source.u8() % (wire::kMaxPayload + 1));
        std::vector<std::uint8_t> payload(body.begin(), body.end());
        if ((act & 4U) != 0 && payload.size() >= 4) {
          for (std::size_t i = 0; i < 4; ++i)
            payload[i] = static_cast<std::uint8_t>(nonce >> (8 * i));
        }
        on_bytes(test::frame_of(type, payload));
        break;
      }
      case 2:
        on_time((act >> 2U) + 1);
        break;
      default:
        on_request(act >> 2U);
    }
  }
}

}  // namespace tp100::fuzz
