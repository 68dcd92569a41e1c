#include "sim/board/native_board.h"

#include <gtest/gtest.h>

#include "board_rig.h"

namespace tp100::sim {
namespace {

constexpr std::int64_t kMs = 1'000'000;

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

// The IMU burst and the transmission of the frame take place between measurement and arrival.
TEST(NativeBoard, ASampleArrivesAfterItsBurstAndItsBytes) {
  NativeRig rig;
  ASSERT_TRUE(rig.boot());
  rig.connect();
  rig.run(500);
  const double measured_ns = rig.last().device_us * 1e3 + 4.0 * kMs;
  const double taken_ns = static_cast<double>(rig.sample_ns.back()) - measured_ns;
  const double least_ns =
      471e3 + static_cast<double>((wire::Sample::kSize + 5) * BoardRig::kByteNs);
  EXPECT_GE(taken_ns, least_ns - 2e3);
  EXPECT_LT(taken_ns, least_ns + 1e6);
}

}  // namespace
}  // namespace tp100::sim
