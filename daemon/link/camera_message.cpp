#include "link/camera_message.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace tp100::link {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMaxU32 = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kMaxStampUs = std::uint64_t{1} << 53;
constexpr std::uint64_t kMaxAgeUs = 10'000'000;
constexpr std::size_t kMaxClock = 64;
constexpr std::uint64_t kMaxMarker = 1'000'000;
constexpr double kMaxPlaceM = 1000.0;
constexpr double kMaxYawRad = 100.0;

/// An integer of 0 to `max`; false: there is none.
template <class Integer>
bool read(const Json& json, const char* key, std::uint64_t max, Integer& out) {
  const auto found = json.find(key);
  // The parser keeps only integers below 0 as signed.
  if (found == json.end() || !found->is_number_unsigned()) return false;
  const auto value = found->get<std::uint64_t>();
  out = static_cast<Integer>(value);
  return value <= max;
}

bool read(const Json& json, const char* key, double max, double& out) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number()) return false;
  out = found->get<double>();
  return std::abs(out) <= max;
}

/// Reads the keys that detections and images have in common; false: not all of them are there and
/// in range, or the format is another.
template <class Message>
bool read_head(const Json& json, std::string_view format, Message& out) {
  if (!json.is_object() || json.value("format", Json()) != format) return false;
  const Json clock = json.value("clock", Json());
  if (!clock.is_string()) return false;
  out.clock = clock.get<std::string>();
  return !out.clock.empty() && out.clock.size() <= kMaxClock &&
         read(json, "stream", kMaxU32, out.stream) &&
         read(json, "sequence", kMaxU32, out.sequence) &&
         read(json, "stamp_us", kMaxStampUs, out.stamp_us) &&
         read(json, "age_us", kMaxAgeUs, out.age_us);
}

template <class Message>
Json head(std::string_view format, const Message& message) {
  return {{"format", format},
          {"stream", message.stream},
          {"clock", message.clock},
          {"sequence", message.sequence},
          {"stamp_us", message.stamp_us},
          {"age_us", message.age_us}};
}

std::string line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

double rounded(double value) { return std::round(value * 1e6) / 1e6; }

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

std::string encode(const CameraMessage& message) {
  Json json = head(kCameraFormat, message);
  json["marker"] = message.marker;
  json["x_m"] = rounded(message.x_m);
  json["y_m"] = rounded(message.y_m);
  json["yaw_rad"] = rounded(message.yaw_rad);
  return line(json);
}

std::string encode(const ImageMessage& message) {
  std::string datagram = line(head(kImageFormat, message)) + '\n';
  return datagram += message.jpeg;
}

std::optional<CameraMessage> decode_camera(std::string_view datagram) {
  if (datagram.size() > kMaxCameraDatagram) return std::nullopt;
  const Json json = Json::parse(datagram, nullptr, false);
  CameraMessage message;
  const bool whole =
      read_head(json, kCameraFormat, message) && read(json, "marker", kMaxMarker, message.marker) &&
      read(json, "x_m", kMaxPlaceM, message.x_m) && read(json, "y_m", kMaxPlaceM, message.y_m) &&
      read(json, "yaw_rad", kMaxYawRad, message.yaw_rad);
  if (!whole) return std::nullopt;
  return message;
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
