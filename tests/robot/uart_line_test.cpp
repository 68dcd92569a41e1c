#include <gtest/gtest.h>

#include <array>

#include "sim/robot/emulated_robot.h"

namespace tp100::sim {
namespace {

TEST(UartLine, BytesArriveOneByteTimeApart) {
  UartLine line(500000);
  const std::array<std::uint8_t, 3> bytes = {1, 2, 3};
  line.send(bytes, 1000);
  EXPECT_TRUE(line.take(20'999).empty());
  EXPECT_EQ(line.take(41'000).size(), 2u);
  const std::vector<TimedByte>& last = line.take(1'000'000);
  ASSERT_EQ(last.size(), 1u);
  EXPECT_EQ(last[0].value, 3);
  EXPECT_EQ(last[0].at_ns, 61'000);
}

TEST(UartLine, AnIdleLineStartsAtOnceAndABusyOneQueues) {
  UartLine line(500000);
  const std::array<std::uint8_t, 1> byte = {7};
  line.send(byte, 0);
  line.send(byte, 5'000);
  line.send(byte, 500'000);
  const std::vector<TimedByte> all = line.take(1'000'000);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[1].at_ns, 40'000);
  EXPECT_EQ(all[2].at_ns, 520'000);
}

}  // namespace
}  // namespace tp100::sim
