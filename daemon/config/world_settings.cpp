#include "config/world_settings.h"

#include <array>

namespace tp100::config {

worlds::PeerSettings peer_settings(const WorldRun& run, std::uint32_t session, bool lockstep) {
  worlds::PeerSettings out;
  out.hello.session = session;
  out.hello.frame = run.settings.frame;
  out.hello.authority =
      run.parameters.owns_pose ? worlds::Authority::kWorld : worlds::Authority::kBridge;
  out.hello.rate_hz = run.settings.rate_hz;
  out.hello.timeout_s = run.parameters.timeout_s;
  out.hello.lockstep = lockstep;
  out.hello.version = run.version;
  out.hello.course = run.course;
  out.hello.setup = run.setup;
  out.surfaces = run.surfaces;
  return out;
}

namespace {

using text::Choice;
using text::Key;

}  // namespace

std::span<const Key<bridge::WorldParameters>> world_keys() {
  using T = bridge::WorldParameters;
  static const std::array<Key<T>, 3> kKeys = {{
      {"kind",
       text::enum_choice<T, &T::kind, bridge::kWorldKindNames>(),
       {},
       "Terrain source of the virtual robot. internal: the course's ramps and blocks; udp: a game "
       "engine or simulator, see daemon/worlds/WORLD.md; files: the same through two text files"},
      {"authority",
       Choice<T>{{"bridge", "world"},
                 [](const T& w) { return static_cast<std::size_t>(w.owns_pose); },
                 [](T& w, std::size_t i) { w.owns_pose = i == 1; }},
       {},
       "Which side determines the pose. bridge: the world answers with height, pitch and roll "
       "only; world: with the whole pose, which the controller then uses"},
      {"timeout_ms",
       &T::timeout_s,
       {50, 2000},
       "The run ends if the world has answered no pose that is younger than this",
       1e-3},
  }};
  return kKeys;
}

std::span<const Key<WorldSettings>> world_stream_keys() {
  using T = WorldSettings;
  static const std::array<Key<T>, 7> kKeys = {{
      {"frame",
       text::enum_choice<T, &T::frame, worlds::kFrameNames>(),
       {},
       "Units, axes and signs of messages and files"},
      {"rate_hz", &T::rate_hz, {1, 1000}, "Poses per second; also of files"},
      {"address", &T::address, {}, "udp: where the world listens, udp:[ADDRESS:]PORT"},
      {"listen",
       &T::listen,
       {},
       "udp: where the world's answers arrive, udp:PORT or udp:ADDRESS:PORT; empty: any free port, "
       "which the world sees as the sender"},
      {"encoder_file", &T::encoder_file, {}, "files: the file to write, replaced as a whole"},
      {"encoder_template",
       &T::encoder_template,
       {},
       "files: text of encoder_file, with {seq}, {t_s}, {left}, {right} (track speeds), "
       "{left_count}, {right_count}, {x}, {y}, {z}, {roll}, {pitch}, {yaw} (pose), {mode}"},
      {"orientation_file", &T::orientation_file, {}, "files: the file to read"},
  }};
  return kKeys;
}

}  // namespace tp100::config
