// Fuzzes the daemon's side of the link with a robot that sends anything, before and within a
// session.

#include <cmath>

#include "../link/session_rig.h"
#include "frame_script.h"

namespace tp100::link {
namespace {

using fuzz::require;

void check(SessionRig& rig) {
  for (const Sample& sample : rig.session.take_samples()) {
    for (const double value : {sample.gyro_radps[0], sample.gyro_radps[1], sample.gyro_radps[2],
                               sample.accel_mps2[0], sample.accel_mps2[1], sample.accel_mps2[2]})
      require(std::isfinite(value), "samples are finite");
  }
  require(rig.session.output().size() <= kMaxOut, "output is bounded");
  require(rig.session.take_events().size() <= SessionEvents::kCapacity, "events are bounded");
}

void play(fuzz::ByteSource& source) {
  SessionRig rig;
  if ((source.u8() & 1U) != 0) {
    rig.connect();
  } else {
    rig.session.open(rig.now);
  }
  fuzz::play(
      source, rig.robot.boot_nonce,
      [&](std::span<const std::uint8_t> bytes) {
        rig.session.receive(bytes, rig.now);
        check(rig);
      },
      [&](int ms) {
        rig.run(ms);
        check(rig);
        rig.samples.clear();
        rig.events.clear();
      },
      [&](int code) {
        constexpr RobotRequest kRequests[] = {RobotRequest::kArm, RobotRequest::kDisarm,
                                              RobotRequest::kStop};
        rig.session.request(kRequests[code % 3], rig.now);
        rig.commands = (code & 8) != 0;
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
