// Fuzzes the firmware with a host that sends anything: the motors must be on only while the robot
// is armed, and must go off when the host falls silent.

#include "../firmware/rig.h"
#include "frame_script.h"

namespace tp100::firmware {
namespace {

using fuzz::require;

void check(const Rig& rig) {
  const wire::State state = rig.program.state();
  require(!rig.motors_on() || state == wire::State::kArmed || state == wire::State::kRunning,
          "only an armed robot moves");
  require(!rig.hal.overfilled, "no more is written than there is room for");
  require(rig.hal.locks == 0, "interrupts are let in again");
}

void play(fuzz::ByteSource& source) {
  Rig rig;
  const std::uint8_t start = source.u8();
  if ((start & 1U) != 0) rig.connect();
  if ((start & 3U) == 3U) rig.arm();
  fuzz::play(
      source, rig.nonce,
      [&](std::span<const std::uint8_t> bytes) {
        rig.hal.received.insert(rig.hal.received.end(), bytes.begin(), bytes.end());
        rig.run(1);
        check(rig);
      },
      [&](int ms) {
        rig.run(ms);
        check(rig);
      },
      [&](int code) {
        rig.streams = (code & 1) != 0;
        rig.speed_mps = 0.1f;
        rig.hal.imu_answers = (code & 2) == 0;
      });
  rig.streams = false;
  rig.hal.received.clear();
  rig.run(230);
  require(!rig.motors_on(), "a silent host stops the robot");
  require(rig.bad_frames == 0, "what the robot sends is in order");
}

}  // namespace
}  // namespace tp100::firmware

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 2000) return 0;
  tp100::fuzz::ByteSource source(data, size);
  tp100::firmware::play(source);
  return 0;
}
