#include <gtest/gtest.h>

#include "avr_rig.h"

namespace tp100::sim {
namespace {

TEST(AvrLoad, NoEdgeIsLostAtTenKilohertzOnAllFourChannelsWithFullTraffic) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.connect();
  rig.streams = true;
  rig.run(50);
  for (const double direction : {1.0, -1.0}) {
    rig.forced_mps = direction * 20'000.0 / 11'140.0;
    rig.run(500);
  }
  rig.forced_mps = 0.0;
  rig.run(30);
  ASSERT_GT(rig.samples.size(), 200U);
  EXPECT_EQ(rig.last().left_counts, rig.left.counts());
  EXPECT_EQ(rig.last().right_counts, rig.right.counts());
  EXPECT_EQ(rig.board.counters().rx_overruns, 0U);
  EXPECT_EQ(rig.bad_frames, 0);
}

TEST(AvrLoad, NoByteIsLostAtLineRate) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.connect();
  rig.streams = true;
  rig.forced_mps = 0.2;
  const std::size_t before = rig.sync_replies.size();
  std::uint16_t asked = 0;
  for (int ms = 0; ms < 500; ++ms) {
    // Each request has seven bytes; with the commands this is close to the 50 bytes that fit into a
    // millisecond.
    for (int i = 0; i < 6; ++i) rig.send(wire::SyncRequest{asked++});
    rig.run(1);
  }
  rig.run(50);
  EXPECT_EQ(rig.board.counters().rx_overruns, 0U);
  EXPECT_EQ(rig.bad_frames, 0);
  ASSERT_GT(rig.sync_replies.size(), before);
}

TEST(AvrLoad, TheReceiverHoldsThreeBytesAndLosesTheRest) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.run(10);
  const std::int64_t at_ns = rig.now_ns + 500'000;
  const std::vector<TimedByte> at_once(10, {at_ns, 0x55});
  rig.board.advance(rig.now_ns + AvrRig::kStepNs, {}, at_once);
  EXPECT_EQ(rig.board.counters().rx_overruns, 7U);
}

TEST(AvrLoad, DeviceTimeWrapsWithoutAJump) {
  AvrRig rig({.start_us = 0xFFFFFFFFU - 1'500'000U});
  ASSERT_TRUE(rig.boot());
  rig.drive();
  ASSERT_GT(rig.last().device_us, 0xF0000000U);
  const std::size_t before = rig.samples.size();
  for (int ms = 0; ms < 2000; ++ms) {
    rig.run(1);
    ASSERT_TRUE(rig.moves()) << "at device time " << rig.last().device_us;
  }
  EXPECT_LT(rig.last().device_us, 0x10000000U);
  for (std::size_t i = before; i < rig.samples.size(); ++i) {
    const wire::Sample& a = rig.samples[i - 1];
    const wire::Sample& b = rig.samples[i];
    ASSERT_EQ(static_cast<std::uint16_t>(a.sequence + 1), b.sequence);
    ASSERT_NEAR(b.device_us - a.device_us, 5000U, 1000U);
    ASSERT_LT(std::abs(b.left_counts - a.left_counts), 40);
  }
  rig.streams = false;
  EXPECT_GE(rig.ms_until_off(205), 0);
}

}  // namespace
}  // namespace tp100::sim
