#include "link/camera_message.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "link/message_keys.h"

namespace tp100::link {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kMaxMarker = 1'000'000;
constexpr double kMaxPlaceM = 1000.0;
constexpr double kMaxYawRad = 100.0;

double rounded(double value) { return std::round(value * 1e6) / 1e6; }

bool read(const Json& json, const char* key, double max, double& out) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number()) return false;
  out = found->get<double>();
  return std::abs(out) <= max;
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
  CameraMessage message;
  const bool whole =
      read_head(json, kCameraFormat, message) && read(json, "marker", kMaxMarker, message.marker) &&
      read(json, "x_m", kMaxPlaceM, message.x_m) && read(json, "y_m", kMaxPlaceM, message.y_m) &&
      read(json, "yaw_rad", kMaxYawRad, message.yaw_rad);
  if (!whole) return std::nullopt;
  return message;
}

}  // namespace tp100::link
