#include <gtest/gtest.h>

#include "avr_rig.h"

namespace tp100::sim {
namespace {

std::vector<TimedByte> session(std::uint32_t run_cycle_limit, std::uint64_t seed = 7) {
  AvrRig rig({.seed = seed, .clock_ppm = 123.0, .run_cycle_limit = run_cycle_limit});
  rig.boot();
  rig.drive();
  rig.send_bytes({0x55, 0x13, 0x00, 0xFF});
  rig.run(50);
  rig.board.reset(PowerUp::kExternal, rig.now_ns);
  rig.run(20);
  return rig.bytes;
}

void expect_same(const std::vector<TimedByte>& a, const std::vector<TimedByte>& b) {
  ASSERT_GT(a.size(), 3000U);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].at_ns, b[i].at_ns) << "byte " << i;
    ASSERT_EQ(a[i].value, b[i].value) << "byte " << i;
  }
}

TEST(AvrDeterminism, TheSameInputsGiveTheSameBytesHoweverOftenTheEmulatorLooksAtItsTimers) {
  const std::vector<TimedByte> bytes = session(16000);
  for (const std::uint32_t run_cycle_limit : {16000U, 50U, 1U}) {
    expect_same(bytes, session(run_cycle_limit));
  }
}

TEST(AvrDeterminism, AnotherSeedIsAnotherBoard) {
  const std::vector<TimedByte> a = session(16000, 7);
  const std::vector<TimedByte> b = session(16000, 8);
  bool differs = a.size() != b.size();
  for (std::size_t i = 0; !differs && i < a.size(); ++i) differs = a[i].value != b[i].value;
  EXPECT_TRUE(differs);
}

TEST(AvrDeterminism, AClockThatIsOffStretchesDeviceTime) {
  AvrRig rig({.clock_ppm = 500.0});
  rig.boot();
  rig.connect();
  rig.streams = true;
  rig.run(900);
  const double device_us = rig.samples.back().device_us - rig.samples.front().device_us;
  const double true_us = static_cast<double>(rig.sample_ns.back() - rig.sample_ns.front()) * 1e-3;
  EXPECT_NEAR((device_us / true_us - 1.0) * 1e6, 500.0, 100.0);
}

}  // namespace
}  // namespace tp100::sim
