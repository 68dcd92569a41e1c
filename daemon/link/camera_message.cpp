#include "link/camera_message.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace tp100::link {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kMaxStampUs = std::int64_t{1} << 53;
constexpr std::int64_t kMaxAgeUs = 10'000'000;
constexpr std::int64_t kMaxMarker = 1'000'000;
constexpr double kMaxPlaceM = 1000.0;
constexpr double kMaxYawRad = 100.0;
constexpr std::size_t kMaxClock = 64;

double rounded(double value) { return std::round(value * 1e6) / 1e6; }

template <class Integer>
bool read(const Json& json, const char* key, std::int64_t max, Integer& out) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number_integer()) return false;
  // Above the signed range the parser keeps the value as unsigned.
  if (found->is_number_unsigned() &&
      found->get<std::uint64_t>() > static_cast<std::uint64_t>(max)) {
    return false;
  }
  const auto value = found->get<std::int64_t>();
  if (value < 0) return false;
  out = static_cast<Integer>(value);
  return true;
}

bool read(const Json& json, const char* key, double max, double& out) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number()) return false;
  out = found->get<double>();
  return std::abs(out) <= max;
}

const std::string* text(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() ? nullptr : found->get_ptr<const std::string*>();
}

}  // namespace

std::string encode(const CameraMessage& message) {
  const Json json = {{"format", kCameraFormat},      {"stream", message.stream},
                     {"clock", message.clock},       {"sequence", message.sequence},
                     {"stamp_us", message.stamp_us}, {"age_us", message.age_us},
                     {"marker", message.marker},     {"x_m", rounded(message.x_m)},
                     {"y_m", rounded(message.y_m)},  {"yaw_rad", rounded(message.yaw_rad)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<CameraMessage> decode_camera(std::string_view datagram) {
  if (datagram.size() > kMaxCameraDatagram) return std::nullopt;
  const Json json = Json::parse(datagram, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  const std::string* format = text(json, "format");
  const std::string* clock = text(json, "clock");
  if (format == nullptr || *format != kCameraFormat) return std::nullopt;
  if (clock == nullptr || clock->empty() || clock->size() > kMaxClock) return std::nullopt;
  constexpr std::int64_t kMaxU32 = std::numeric_limits<std::uint32_t>::max();
  CameraMessage message;
  message.clock = *clock;
  const bool whole = read(json, "stream", kMaxU32, message.stream) &&
                     read(json, "sequence", kMaxU32, message.sequence) &&
                     read(json, "stamp_us", kMaxStampUs, message.stamp_us) &&
                     read(json, "age_us", kMaxAgeUs, message.age_us) &&
                     read(json, "marker", kMaxMarker, message.marker) &&
                     read(json, "x_m", kMaxPlaceM, message.x_m) &&
                     read(json, "y_m", kMaxPlaceM, message.y_m) &&
                     read(json, "yaw_rad", kMaxYawRad, message.yaw_rad);
  if (!whole) return std::nullopt;
  return message;
}

}  // namespace tp100::link
