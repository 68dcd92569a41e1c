#include "worlds/message.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/arithmetic.h"
#include "worlds/frame.h"

namespace tp100::worlds {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMaxSequence = std::uint64_t{1} << 53;
constexpr std::size_t kMaxName = 64;
constexpr std::size_t kMaxError = 200;
constexpr double kMaxStampS = 1e12;
constexpr double kMaxHeightM = 100.0;
constexpr double kMaxStepM = 1.0;

std::string cut(std::string_view text, std::size_t most) {
  std::string out(text.substr(0, most));
  for (char& c : out)
    if (c < 0x20 || c > 0x7e) c = '?';
  return out;
}

double rounded(double value) {
  const double out = std::round(value * 1e6) / 1e6;
  return out == 0.0 ? 0.0 : out;  // no -0.0
}
Json numbers(const Vector& v) { return {rounded(v[0]), rounded(v[1]), rounded(v[2])}; }
Json numbers(const Quaternion& q) {
  return {rounded(q.x), rounded(q.y), rounded(q.z), rounded(q.w)};
}
std::string datagram(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string_view mode_name(RunState state) { return to_string(state); }

/// The entry, or null if it is absent or null.
const Json* find(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() || found->is_null() ? nullptr : &*found;
}

bool read(const Json& value, double most, double& out) {
  if (!value.is_number()) return false;
  out = value.get<double>();
  return std::abs(out) <= most;
}

bool read(const Json* value, std::uint64_t most, std::uint64_t& out) {
  if (value == nullptr || !value->is_number_unsigned()) return false;
  out = value->get<std::uint64_t>();
  return out <= most;
}

bool read(const Json* value, bool& out) {
  if (value == nullptr) return true;
  if (!value->is_boolean()) return false;
  out = value->get<bool>();
  return true;
}

bool read(const Json* value, std::string& out) {
  if (value == nullptr) return true;
  const auto* text = value->get_ptr<const std::string*>();
  if (text == nullptr || text->size() > kMaxName) return false;
  out = cut(*text, kMaxName);
  return true;
}

bool read(const Json* value, std::optional<std::string>& out) {
  if (value == nullptr) return true;
  return read(value, out.emplace());
}

template <std::size_t N>
bool read(const Json* value, std::array<double, N>& out) {
  if (value == nullptr || !value->is_array() || value->size() != N) return false;
  for (std::size_t i = 0; i < N; ++i)
    if (!read((*value)[i], std::numeric_limits<double>::max(), out[i])) return false;
  return true;
}

bool plausible(double roll_rad, double pitch_rad) {
  return std::abs(roll_rad) <= kMaxLeanRad && std::abs(pitch_rad) <= kMaxLeanRad;
}

bool read_ground(const Json& json, Frame frame, ReceivedGround& out) {
  Vector rpy{};
  double height = 0.0;
  const Json* z = find(json, "z");
  const Json* pitch = find(json, "pitch");
  const Json* roll = find(json, "roll");
  if (z == nullptr || pitch == nullptr || !read(*z, 1e6, height) || !read(*pitch, 1e6, rpy[1]))
    return false;
  if (roll != nullptr && !read(*roll, 1e6, rpy[0])) return false;
  Pose pose;
  from_rpy(frame, rpy, pose);
  out.height_m = from_length(frame, height);
  out.roll_rad = pose.roll_rad;
  out.pitch_rad = pose.pitch_rad;
  return std::abs(out.height_m) <= kMaxHeightM && plausible(out.roll_rad, out.pitch_rad) &&
         read(find(json, "surface"), out.surface);
}

bool read_turn(const Json& json, Frame frame, Pose& pose) {
  if (const Json* rpy = find(json, "rpy")) {
    Vector angles{};
    if (!read(rpy, angles)) return false;
    from_rpy(frame, angles, pose);
    return true;
  }
  std::array<double, 4> q{};
  if (!read(find(json, "quat"), q)) return false;
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(length > 0.9 && length < 1.1)) return false;
  from_quaternion(frame, {q[0] / length, q[1] / length, q[2] / length, q[3] / length}, pose);
  return true;
}

bool read_pose(const Json& json, Frame frame, Pose& pose) {
  Vector place{};
  if (!read(find(json, "pos"), place) || !read_turn(json, frame, pose)) return false;
  place = from_place(frame, place);
  pose.x_m = place[0];
  pose.y_m = place[1];
  pose.z_m = place[2];
  return std::abs(pose.x_m) <= kMaxPlaceM && std::abs(pose.y_m) <= kMaxPlaceM &&
         std::abs(pose.z_m) <= kMaxHeightM && std::abs(pose.yaw_rad) <= kMaxYawRad &&
         plausible(pose.roll_rad, pose.pitch_rad);
}

bool read_contact(const Json& json, Frame frame, WorldMessage& out) {
  double height = 0.0;
  if (const Json* step = find(json, "step"); step != nullptr && !read(*step, 1e6, height))
    return false;
  out.step_height_m = from_length(frame, height);
  return out.step_height_m >= 0.0 && out.step_height_m <= kMaxStepM &&
         read(find(json, "blocked"), out.blocked);
}

bool read_welcome(const Json& json, WorldMessage& out) {
  out.type = WorldMessage::Type::kWelcome;
  return out.session.has_value() && read(find(json, "name"), out.name) &&
         read(find(json, "frame"), out.frame) && read(find(json, "authority"), out.authority);
}

bool read_world(const Json& json, Frame frame, WorldMessage& out) {
  if (!read(find(json, "seq"), kMaxSequence, out.sequence)) return false;
  if (!read(find(json, "ack"), kMaxSequence, out.answers)) return false;
  if (const Json* stamp = find(json, "timestamp"))
    if (!read(*stamp, kMaxStampS, out.stamp_s.emplace())) return false;
  if (const Json* ground = find(json, "ground"))
    if (!ground->is_object() || !read_ground(*ground, frame, out.ground.emplace())) return false;
  if (const Json* contact = find(json, "contact"))
    if (!contact->is_object() || !read_contact(*contact, frame, out)) return false;
  if (const Json* pose = find(json, "pose"))
    if (!pose->is_object() || !read_pose(*pose, frame, out.pose.emplace())) return false;
  if (const Json* command = find(json, "cmd"))
    if (!command->is_object() || !read(find(*command, "estop"), out.stop)) return false;
  return true;
}

}  // namespace

std::string encode(const Hello& hello) {
  return datagram({{"v", kWorldVersion},
                   {"type", "hello"},
                   {"session", hello.session},
                   {"name", "tp100d"},
                   {"version", cut(hello.version, kMaxName)},
                   {"frame", to_string(hello.frame)},
                   {"authority", to_string(hello.authority)},
                   {"rate_hz", rounded(hello.rate_hz)},
                   {"timeout_s", rounded(hello.timeout_s)},
                   {"lockstep", hello.lockstep},
                   {"course", cut(hello.course, kMaxName)},
                   {"setup", cut(hello.setup, kMaxName)}});
}

std::string encode(const PoseReport& report, Frame frame) {
  const auto speed = [&](double mps) { return rounded(to_length(frame, mps)); };
  const Twist& twist = report.twist;
  Pose desired;
  desired.yaw_rad = report.desired_yaw_rad;
  const auto on_floor = [&](const Pose& pose) {
    return Json{{"pos", numbers(to_place(frame, {pose.x_m, pose.y_m, 0.0}))},
                {"yaw", rounded(to_rpy(frame, pose)[2])}};
  };
  Json estimates = Json::object();
  for (const PoseSource source : kPoseSources)
    estimates[std::string(to_string(source))] = on_floor(report.floor[source]);
  return datagram(
      {{"v", kWorldVersion},
       {"type", "pose"},
       {"session", report.session},
       {"seq", report.sequence},
       {"timestamp", rounded(report.stamp_s)},
       {"run", report.run},
       {"frame", to_string(frame)},
       {"src", to_string(report.source)},
       {"pos", numbers(to_place(frame, {report.pose.x_m, report.pose.y_m, report.pose.z_m}))},
       {"quat", numbers(to_quaternion(frame, report.pose))},
       {"rpy", numbers(to_rpy(frame, report.pose))},
       {"floor", on_floor(report.floor[report.source])},
       {"estimates", std::move(estimates)},
       {"vel", numbers(to_place(frame, {twist.vx_mps, twist.vy_mps, 0.0}))},
       {"omega", numbers(to_turn(frame, {0.0, 0.0, twist.yaw_rate_radps}))},
       {"tracks", {{"l", speed(report.left_mps)}, {"r", speed(report.right_mps)}}},
       {"slip", {{"l", rounded(report.slip_left)}, {"r", rounded(report.slip_right)}}},
       {"mode", mode_name(report.mode)},
       {"target",
        {{"yaw", rounded(to_rpy(frame, desired)[2])}, {"speed", speed(report.speed_mps)}}}});
}

std::string encode_error(std::string_view text) {
  return datagram({{"v", kWorldVersion}, {"type", "error"}, {"text", cut(text, kMaxError)}});
}

Decoded decode_world(std::string_view text, Frame frame) {
  Decoded out;
  if (text.size() > kMaxWorldDatagram) return out;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return out;
  const Json* version = find(json, "v");
  if (version == nullptr || !version->is_number_integer()) return out;
  out.version = version->get<std::int64_t>();
  if (out.version != kWorldVersion) {
    out.verdict = Decoded::Verdict::kOtherVersion;
    return out;
  }
  if (const Json* session = find(json, "session")) {
    std::uint64_t number = 0;
    if (!read(session, std::numeric_limits<std::uint32_t>::max(), number)) return out;
    out.message.session = static_cast<std::uint32_t>(number);
  }
  std::string type;
  if (!read(find(json, "type"), type)) return out;
  const bool good = type == "welcome" ? read_welcome(json, out.message)
                                      : type == "world" && read_world(json, frame, out.message);
  if (good) out.verdict = Decoded::Verdict::kGood;
  return out;
}

}  // namespace tp100::worlds
