#include "sim/board/native_board.h"

#include <gtest/gtest.h>

#include <cmath>

#include "board_rig.h"

namespace tp100::sim {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kByteNs = BoardRig::kByteNs;

TEST(NativeBoard, SwallowsBytesWhileItBootsAndThenSaysHello) {
  NativeRig rig({.boot_delay_ns = 840 * kMs});
  rig.run(100);
  EXPECT_TRUE(rig.bytes.empty()) << "without power it is silent";
  rig.board.reset(PowerUp::kPowerOn, rig.now_ns);
  rig.send_bytes(std::vector<std::uint8_t>(30, 0x55));
  rig.run(840);
  EXPECT_EQ(rig.board.counters().rx_lost_in_boot, 30U);
  EXPECT_EQ(rig.board.counters().rx_overruns, 0U);
  EXPECT_TRUE(rig.bytes.empty());
  rig.run(5);
  ASSERT_EQ(rig.hellos.size(), 1U);
  EXPECT_EQ(rig.hellos[0].board, static_cast<std::uint8_t>(wire::BoardType::kNative));
  EXPECT_EQ(rig.hellos[0].reset_cause, static_cast<std::uint8_t>(wire::ResetCause::kPowerOn));
  EXPECT_EQ(rig.bad_frames, 0);
}

TEST(NativeBoard, EveryByteTakesItsTimeOnTheWire) {
  NativeRig rig;
  ASSERT_TRUE(rig.boot());
  rig.connect();
  rig.run(500);
  ASSERT_GT(rig.bytes.size(), 4000U);
  for (std::size_t i = 1; i < rig.bytes.size(); ++i) {
    ASSERT_GE(rig.bytes[i].at_ns - rig.bytes[i - 1].at_ns, kByteNs);
  }
  const std::int64_t delay_ns = rig.sample_ns.back() - rig.sample_ns[rig.sample_ns.size() - 2];
  EXPECT_NEAR(static_cast<double>(delay_ns), 5.0 * kMs, 0.6 * kMs);
  // The IMU burst and the transmission of the frame take place between measurement and arrival.
  const double measured_ns = rig.last().device_us * 1e3 + 4.0 * kMs;
  const double taken_ns = static_cast<double>(rig.sample_ns.back()) - measured_ns;
  const double least_ns = 471e3 + static_cast<double>((wire::Sample::kSize + 5) * kByteNs);
  EXPECT_GE(taken_ns, least_ns - 2e3);
  EXPECT_LT(taken_ns, least_ns + 1e6);
}

TEST(NativeBoard, CountsBytesThatFindTheBufferFullAndHasNoneAtFullRate) {
  NativeRig rig;
  ASSERT_TRUE(rig.boot());
  rig.send_bytes(std::vector<std::uint8_t>(20'000, 0x55));
  rig.run(450);
  EXPECT_EQ(rig.board.counters().rx_overruns, 0U);
  // 200 bytes arrive at one instant, which is impossible on a wire; the ring buffer holds 63 in any
  // case.
  const std::vector<TimedByte> burst(200, TimedByte{rig.now_ns + 1, 0x55});
  rig.board.advance(rig.now_ns + kMs, {}, burst);
  EXPECT_EQ(rig.board.counters().rx_overruns, 200U - 63U);
}

TEST(NativeBoard, ASampleHoldsAllEdgesUpToItsTime) {
  NativeRig rig;
  ASSERT_TRUE(rig.boot());
  rig.connect();
  rig.streams = true;
  for (const double mps : {0.9, -0.9}) {
    rig.forced_mps = mps;
    const auto begin = static_cast<std::int32_t>(rig.left.counts());
    const double begin_us = static_cast<double>(rig.now_ns) * 1e-3 - 4000.0;  // device time
    const std::size_t before = rig.samples.size();
    rig.run(300);
    for (std::size_t i = before + 1; i < rig.samples.size(); ++i) {
      const wire::Sample& sample = rig.samples[i];
      const double counts = mps * (sample.device_us - begin_us) * 1e-6 * 11'140.0;
      EXPECT_NEAR(sample.left_counts - begin, counts, 2.0);
    }
    rig.forced_mps = 0.0;
    rig.run(10);
    EXPECT_EQ(rig.last().left_counts, rig.left.counts());
    EXPECT_EQ(rig.last().right_counts, rig.right.counts());
  }
}

TEST(NativeBoard, ItsClockIsOffByItsPpmAndStartsWhereItIsTold) {
  NativeRig rig({.clock_ppm = 500.0, .start_us = 0xFFFFFFFFU - 1'000'000U});
  ASSERT_TRUE(rig.boot());
  rig.connect();
  rig.streams = true;
  rig.run(10'000);
  const std::uint32_t first_us = rig.samples.front().device_us;
  const double device_us = rig.last().device_us - first_us;
  const double true_us = static_cast<double>(rig.sample_ns.back() - rig.sample_ns.front()) * 1e-3;
  EXPECT_NEAR(device_us / true_us, 1.0005, 1e-4);
  EXPECT_GT(first_us, 0xFFFFFFFFU - 1'000'000U);
  EXPECT_LT(rig.last().device_us, 20'000'000U) << "the device clock has not wrapped";
  // Timer and clock use the same resonator, so the samples do not drift against device time.
  EXPECT_NEAR(device_us / static_cast<double>(rig.samples.size() - 1), 5000.0, 0.3);
}

TEST(NativeBoard, ResetGivesANewNonceAndItsCause) {
  NativeRig rig;
  ASSERT_TRUE(rig.boot());
  rig.drive();
  ASSERT_TRUE(rig.moves());
  const std::uint32_t first = rig.nonce;
  rig.board.reset(PowerUp::kBrownOut, rig.now_ns);
  EXPECT_FALSE(rig.moves());
  ASSERT_TRUE(rig.boot(PowerUp::kBrownOut));
  EXPECT_NE(rig.nonce, first);
  EXPECT_NE(rig.nonce, 0U);
  EXPECT_EQ(rig.hellos.back().reset_cause, static_cast<std::uint8_t>(wire::ResetCause::kBrownOut));
  EXPECT_EQ(rig.hellos.back().state, static_cast<std::uint8_t>(wire::State::kHello));
}

}  // namespace
}  // namespace tp100::sim
