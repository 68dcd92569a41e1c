// Fuzzes the daemon's side of the link with a robot that sends anything, before and within a
// session.

#include <cmath>

#include "../link/session_bench.h"
#include "frame_script.h"

namespace tp100::link {
namespace {

using fuzz::require;

void check(SessionBench& bench) {
  for (const Sample& sample : bench.session.take_samples()) {
    for (const double value : {sample.gyro_radps[0], sample.gyro_radps[1], sample.gyro_radps[2],
                               sample.accel_mps2[0], sample.accel_mps2[1], sample.accel_mps2[2]})
      require(std::isfinite(value), "samples are finite");
  }
  require(bench.session.output().size() <= kMaxOut, "output is bounded");
  require(bench.session.take_events().size() <= SessionEvents::kCapacity, "events are bounded");
}

void play(fuzz::ByteSource& source) {
  SessionBench bench;
  if ((source.u8() & 1U) != 0) {
    bench.connect();
  } else {
    bench.session.open(bench.now);
  }
  fuzz::play(
      source, bench.robot.boot_nonce,
      [&](std::span<const std::uint8_t> bytes) {
        bench.session.receive(bytes, bench.now);
        check(bench);
      },
      [&](int ms) {
        bench.run(ms);
        check(bench);
        bench.samples.clear();
        bench.events.clear();
      },
      [&](int code) {
        constexpr RobotRequest kRequests[] = {RobotRequest::kArm, RobotRequest::kDisarm,
                                              RobotRequest::kStop};
        bench.session.request(kRequests[code % 3], bench.now);
        bench.commands = (code & 8) != 0;
      });
}

}  // namespace
}  // namespace tp100::link

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 2000) return 0;
  tp100::fuzz::ByteSource source(data, size);
  tp100::link::play(source);
  return 0;
}
