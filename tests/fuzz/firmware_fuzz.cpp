// Fuzzes the firmware with a host that sends anything: the motors must be on only while the robot
// is armed, and must go off when the host falls silent.

#include "../firmware/bench.h"
#include "frame_script.h"

namespace tp100::firmware {
namespace {

using fuzz::require;

void check(const Bench& bench) {
  const wire::State state = bench.program.state();
  require(!bench.motors_on() || state == wire::State::kArmed || state == wire::State::kRunning,
          "only an armed robot moves");
  require(!bench.hal.overfilled, "no more is written than there is room for");
  require(bench.hal.locks == 0, "interrupts are let in again");
}

void play(fuzz::ByteSource& source) {
  Bench bench;
  const std::uint8_t start = source.u8();
  if ((start & 1U) != 0) bench.connect();
  if ((start & 3U) == 3U) bench.arm();
  fuzz::play(
      source, bench.hal.nonce,
      [&](std::span<const std::uint8_t> bytes) {
        bench.hal.received.insert(bench.hal.received.end(), bytes.begin(), bytes.end());
        bench.run(1);
        check(bench);
      },
      [&](int ms) {
        bench.run(ms);
        check(bench);
      },
      [&](int code) {
        bench.streams = (code & 1) != 0;
        bench.speed_mps = 0.1f;
        bench.hal.imu_answers = (code & 2) == 0;
      });
  bench.streams = false;
  bench.hal.received.clear();
  bench.run(230);
  require(!bench.motors_on(), "a silent host stops the robot");
  require(bench.bad_frames == 0, "what the robot sends is in order");
}

}  // namespace
}  // namespace tp100::firmware

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 2000) return 0;
  tp100::fuzz::ByteSource source(data, size);
  tp100::firmware::play(source);
  return 0;
}
