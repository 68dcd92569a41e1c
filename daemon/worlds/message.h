#pragma once
// The datagrams of world/1: one JSON object each, specified field by field in WORLD.md. Input is
// hostile. Allocates: not for the real-time thread.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/arithmetic.h"
#include "core/enum_names.h"
#include "core/estimates.h"
#include "core/pose.h"
#include "core/run_state.h"
#include "worlds/frame.h"

namespace tp100::worlds {

inline constexpr std::int64_t kWorldVersion = 1;
inline constexpr std::size_t kMaxWorldDatagram = 1200;

// Greater values in a world's message are a mistake of the world.
inline constexpr double kMaxPlaceM = 1000.0;
inline constexpr double kMaxYawRad = 1e4;
/// A robot that leans further than this lies on its back.
inline constexpr double kMaxLeanRad = kPi / 2.0 + 1e-6;

/// Which side integrates the pose.
enum class Authority { kBridge, kWorld };
/// Names as in a hello.
inline constexpr std::array<EnumName<Authority>, 2> kAuthorityNames = {{
    {Authority::kBridge, "bridge"},
    {Authority::kWorld, "world"},
}};
constexpr std::string_view to_string(Authority authority) {
  return name_in(kAuthorityNames, authority);
}

/// The bridge's message until it is welcomed.
struct Hello {
  std::uint32_t session = 0;  ///< unguessable number, known only to receivers of this hello
  Frame frame = Frame::kRos;
  Authority authority = Authority::kBridge;
  double rate_hz = 100.0;
  double timeout_s = 0.3;
  bool lockstep = false;  ///< the bridge waits for the reply to every pose
  std::string version;    ///< of tp100d
  std::string course;
  std::string setup;
};

/// Pose of the robot. SI, REP-103.
struct PoseReport {
  std::uint32_t session = 0;
  std::uint64_t sequence = 0;
  double stamp_s = 0.0;                    ///< host time of the step
  std::uint32_t run = 0;                   ///< +1 each time a run begins
  PoseSource source = PoseSource::kModel;  ///< of the pose
  Pose pose{};                             ///< in the course's world
  PerSource<Pose> floor{};                 ///< each estimate on the real robot's own flat floor
  Twist twist{};                           ///< of the real robot on its floor
  double left_mps = 0.0;                   ///< tracks, mean of the steps since the last pose
  double right_mps = 0.0;
  double slip_left = 0.0;
  double slip_right = 0.0;
  RunState mode = RunState::kIdle;
  double desired_yaw_rad = 0.0;
  double speed_mps = 0.0;  ///< commanded
};

/// The ground under the robot, as reported by a world.
struct ReceivedGround {
  double height_m = 0.0, roll_rad = 0.0, pitch_rad = 0.0;
  std::string surface;  ///< empty: not given
};

/// A message from a world. Values are converted to our units, finite and in range.
struct WorldMessage {
  enum class Type { kWelcome, kWorld };
  Type type = Type::kWorld;
  std::optional<std::uint32_t> session{};

  // welcome
  std::string name;                    ///< of the world, printable
  std::optional<std::string> frame{};  ///< frame that it expects
  std::optional<std::string> authority{};

  // world
  std::uint64_t sequence = 0;
  std::uint64_t answers = 0;        ///< sequence of the last pose that it received
  std::optional<double> stamp_s{};  ///< its own clock
  std::optional<ReceivedGround> ground{};
  double step_height_m = 0.0;
  bool blocked = false;
  std::optional<Pose> pose{};
  bool stop = false;
};

/// Result of decoding a datagram.
struct Decoded {
  enum class Verdict { kGood, kMalformed, kOtherVersion };
  Verdict verdict = Verdict::kMalformed;
  std::int64_t version = 0;  ///< kOtherVersion: the sender's version
  WorldMessage message{};    ///< kGood
};

/// Datagrams to send. Numbers are rounded to 1e-6 of the frame's units.
std::string encode(const Hello& hello);
std::string encode(const PoseReport& report, Frame frame);
/// Encodes an error message. `text` is cut so that the datagram fits.
std::string encode_error(std::string_view text);

/// Decodes a datagram. Unknown fields are ignored.
Decoded decode_world(std::string_view datagram, Frame frame);

}  // namespace tp100::worlds
