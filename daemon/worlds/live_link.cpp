#include "worlds/live_link.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "worlds/frame.h"

namespace tp100::worlds {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

}  // namespace

std::string encode_live_link(std::string_view subject, const Pose& pose, LiveLinkDialect dialect) {
  const Vector place = to_place(Frame::kUnreal, {pose.x_m, pose.y_m, pose.z_m});
  const Quaternion turn = to_quaternion(Frame::kUnreal, pose);
  Json transform = Json::object();
  if (dialect == LiveLinkDialect::kBones) {
    transform["Name"] = "root";
    transform["Parent"] = -1;
  }
  transform["Location"] = {rounded(place[0]), rounded(place[1]), rounded(place[2])};
  transform["Rotation"] = {rounded(turn.x), rounded(turn.y), rounded(turn.z), rounded(turn.w)};
  transform["Scale"] = {1, 1, 1};
  Json out = Json::object();
  if (dialect == LiveLinkDialect::kBones) {
    out[std::string(subject)] = Json::array({transform});
  } else {
    out[std::string(subject)] = transform;
  }
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tp100::worlds
