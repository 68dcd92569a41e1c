#pragma once
// The datagrams of world/1: one JSON object each, described field by field in WORLD.md. Input is
// hostile. Allocates: not for the real-time thread.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/pose.h"
#include "core/run_state.h"
#include "worlds/frame.h"

namespace tp100::worlds {

inline constexpr std::int64_t kWorldVersion = 1;
inline constexpr std::size_t kMaxWorldDatagram = 1200;

/// Who integrates the pose.
enum class Authority { kBridge, kWorld };
std::string_view to_string(Authority authority);

/// What the bridge says until it is welcomed.
struct Hello {
  std::uint32_t session = 0;  ///< a number that only who got this hello can know
  Frame frame = Frame::kRos;
  Authority authority = Authority::kBridge;
  double rate_hz = 100.0;
  double timeout_s = 0.3;
  bool lockstep = false;  ///< the bridge waits for the answer to every pose
  std::string version;    ///< of tp100d
  std::string course;
  std::string setup;
};

/// Where the robot is. SI, REP-103.
struct PoseReport {
  std::uint32_t session = 0;
  std::uint64_t sequence = 0;
  double stamp_s = 0.0;     ///< host time of the step
  std::uint32_t run = 0;    ///< +1 each time a run begins
  std::string_view source;  ///< of the pose: model, odometry, fused
  Pose pose{};              ///< in the course's world
  Pose floor{};             ///< on the real robot's own floor
  Twist twist{};            ///< of the real robot on its floor
  double left_mps = 0.0;    ///< belts
  double right_mps = 0.0;
  double slip_left = 0.0;
  double slip_right = 0.0;
  RunState mode = RunState::kIdle;
  double desired_yaw_rad = 0.0;
  double speed_mps = 0.0;  ///< commanded
};

/// The ground under the robot, as a world says it.
struct SaidGround {
  double height_m = 0.0, roll_rad = 0.0, pitch_rad = 0.0;
  std::string surface;  ///< empty: not said
};

/// What a world says. Values are converted to ours, finite and in range.
struct WorldMessage {
  enum class Type { kWelcome, kWorld };
  Type type = Type::kWorld;
  std::optional<std::uint32_t> session{};

  // welcome
  std::string name;                    ///< of the world, printable
  std::optional<std::string> frame{};  ///< that it expects
  std::optional<std::string> authority{};

  // world
  std::uint64_t sequence = 0;
  std::uint64_t answers = 0;        ///< sequence of the last pose that it saw
  std::optional<double> stamp_s{};  ///< its own clock
  std::optional<SaidGround> ground{};
  double step_height_m = 0.0;
  bool blocked = false;
  std::optional<Pose> pose{};
  bool stop = false;
};

/// What became of a datagram.
struct Decoded {
  enum class Verdict { kGood, kMalformed, kOtherVersion };
  Verdict verdict = Verdict::kMalformed;
  std::int64_t version = 0;  ///< kOtherVersion: the one that was spoken
  WorldMessage message{};    ///< kGood
};

/// Datagrams to send. Numbers are rounded to 1e-6 of the frame's units.
std::string encode(const Hello& hello);
std::string encode(const PoseReport& report, Frame frame);
/// `text` is cut so that the datagram fits.
std::string encode_error(std::string_view text);

/// What a datagram says. Unknown fields are ignored.
Decoded decode_world(std::string_view datagram, Frame frame);

}  // namespace tp100::worlds
