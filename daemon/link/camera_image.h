#pragma once
// One image of a camera as a datagram, to be shown to people: tp100-camera sends it to the address
// of its detections, and tp100d shows and records it. No OpenCV, no socket, no clock.
//
// A datagram is one line of JSON, a line feed, and the image as JPEG, together at most
// kMaxImageDatagram bytes:
//
//   {"format":"tp100-image/1","stream":193755201,"clock":"6b0c...","sequence":412,
//    "stamp_us":81234567890,"age_us":41250}
//
// The keys are those of camera_message.h, with the same ranges. `stream` and `sequence` count
// images alone: a camera that sends both has two streams. The JPEG is checked for its beginning,
// its end and at most kMaxImageSide pixels a side, so that no viewer decodes a huge one.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tp100::link {

inline constexpr std::string_view kImageFormat = "tp100-image/1";
/// One UDP datagram carries 65507 bytes at most.
inline constexpr std::size_t kMaxImageDatagram = 60'000;
inline constexpr int kMaxImageSide = 4096;

/// A decoded datagram. `jpeg` refers to the datagram's bytes.
struct ImageMessage {
  std::uint32_t stream = 0;
  std::string clock;
  std::uint32_t sequence = 0;
  std::int64_t stamp_us = 0;
  std::int64_t age_us = 0;
  std::string_view jpeg;
};

/// Whether a datagram claims to be an image and not a detection. Accepts any bytes.
bool is_image(std::string_view datagram);

/// Encodes a datagram.
std::string encode(const ImageMessage& message);

/// Decodes a datagram. Nothing if it is invalid: too long, not such JSON, a key missing, of another
/// type or out of range, or not such a JPEG. Accepts any bytes. Allocates: not for the real-time
/// thread.
std::optional<ImageMessage> decode_image(std::string_view datagram);

}  // namespace tp100::link
