#include "link/camera_image.h"

#include <nlohmann/json.hpp>

#include "link/camera_message.h"
#include "link/message_keys.h"

namespace tp100::link {
namespace {

using Json = nlohmann::ordered_json;

constexpr unsigned kMarker = 0xff, kStart = 0xd8, kEnd = 0xd9, kScan = 0xda;
// Baseline, extended and progressive frames, which every browser shows.
constexpr unsigned kFirstFrame = 0xc0, kLastFrame = 0xc2;
constexpr std::size_t kFrameBytes = 8;  // up to the number of components

unsigned byte(std::string_view data, std::size_t at) {
  return static_cast<unsigned char>(data[at]);
}
unsigned word(std::string_view data, std::size_t at) {
  return byte(data, at) << 8U | byte(data, at + 1);
}

/// The content of a frame header: precision, height, width, components.
bool frame_fits(std::string_view frame) {
  if (frame.size() < kFrameBytes - 2) return false;
  const unsigned height_px = word(frame, 1), width_px = word(frame, 3);
  const unsigned components = byte(frame, 5);
  const auto side = [](unsigned px) { return px > 0 && px <= kMaxImageSide; };
  return byte(frame, 0) == 8 && side(width_px) && side(height_px) &&
         (components == 1 || components == 3);
}

/// Whether there is a frame header before the first scan, and all of them fit.
bool is_jpeg(std::string_view data) {
  if (data.size() < 4 || word(data, 0) != (kMarker << 8U | kStart) ||
      word(data, data.size() - 2) != (kMarker << 8U | kEnd))
    return false;
  bool fits = false;
  // A segment: 0xff, its kind, and its length, which includes these two bytes.
  for (std::size_t at = 2; at + 4 <= data.size();) {
    const unsigned kind = byte(data, at + 1);
    const std::size_t length = word(data, at + 2);
    if (byte(data, at) != kMarker || kind < kFirstFrame || length < 2) return false;
    if (kind == kScan) return fits;
    if (at + 2 + length > data.size()) return false;
    if (kind >= kFirstFrame && kind <= kLastFrame) {
      if (fits || !frame_fits(data.substr(at + 4, length - 2))) return false;
      fits = true;
    }
    at += 2 + length;
  }
  return false;
}

}  // namespace

bool is_image(std::string_view datagram) {
  const std::size_t end = datagram.find('\n');
  return end != std::string_view::npos && end + 2 < datagram.size() &&
         byte(datagram, end + 1) == kMarker;
}

std::string encode(const ImageMessage& message) {
  const Json json = {{"format", kImageFormat},       {"stream", message.stream},
                     {"clock", message.clock},       {"sequence", message.sequence},
                     {"stamp_us", message.stamp_us}, {"age_us", message.age_us}};
  std::string datagram = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  datagram += '\n';
  datagram += message.jpeg;
  return datagram;
}

std::optional<ImageMessage> decode_image(std::string_view datagram) {
  if (datagram.size() > kMaxImageDatagram || !is_image(datagram)) return std::nullopt;
  const std::size_t end = datagram.find('\n');
  if (end > kMaxCameraDatagram) return std::nullopt;
  const Json json = Json::parse(datagram.substr(0, end), nullptr, false);
  ImageMessage message;
  message.jpeg = datagram.substr(end + 1);
  if (!read_head(json, kImageFormat, message) || !is_jpeg(message.jpeg)) return std::nullopt;
  return message;
}

}  // namespace tp100::link
