// Tests that no input moves a disarmed robot.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::State;

class Hostile : public testing::TestWithParam<unsigned> {
 protected:
  std::uint32_t random() { return static_cast<std::uint32_t>(source_()); }
  std::uint32_t below(std::uint32_t limit) { return random() % limit; }

  // Sends a frame with a valid CRC around random fields; half of the frames have the right nonce.
  void push_random_frame(Rig& rig) {
    // Types with the sizes of their payloads, and some that no robot takes.
    const std::pair<std::uint8_t, std::size_t> types[] = {{0x41, 6},  {0x42, 71}, {0x43, 40},
                                                          {0x44, 12}, {0x45, 4},  {0x46, 4},
                                                          {0x47, 2},  {0x01, 18}, {0x99, 3}};
    const auto& [type, usual] = types[below(9)];
    std::vector<std::uint8_t> payload(below(10) == 0 ? below(wire::kMaxPayload) : usual);
    for (std::uint8_t& byte : payload) byte = static_cast<std::uint8_t>(random());
    if (payload.size() >= 4 && below(2) == 0) {
      for (unsigned i = 0; i < 4; ++i) payload[i] = static_cast<std::uint8_t>(rig.nonce >> (8 * i));
    }
    rig.send_bytes(test::frame_of(type, payload));
  }

  std::mt19937_64 source_{GetParam()};
};

// Random bytes, frames with random fields, and arm requests with one bit flipped, which the CRC
// must detect.
TEST_P(Hostile, NothingButAnArmRequestMovesADisarmedRobot) {
  Rig rig;
  const auto push = [&](std::uint32_t byte) {
    rig.hal.received.push_back(static_cast<std::uint8_t>(byte));
  };
  for (int i = 0; i < 6000; ++i) {
    if (i % 500 == 0) rig.connect();
    rig.streams = i % 1000 < 700;
    rig.speed_mps = 0.1f;
    switch (below(3)) {
      case 0:
        for (std::uint32_t count = below(60); count > 0; --count) push(below(8) ? random() : 0);
        break;
      case 1:
        push_random_frame(rig);
        break;
      default:
        std::vector<std::uint8_t> frame = test::frame_of(rig.arm_message());
        std::uint8_t& byte = frame[below(static_cast<std::uint32_t>(frame.size() - 1))];
        byte = static_cast<std::uint8_t>(byte ^ (1U << below(8)));
        if (byte != 0) std::for_each(frame.begin(), frame.end(), push);
    }
    rig.run(2);
    ASSERT_TRUE(rig.program.state() != State::kArmed && rig.program.state() != State::kRunning);
  }
  EXPECT_EQ(rig.hal.nonzero_writes, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Hostile, testing::Range(1U, 6U), testing::PrintToStringParamName());

}  // namespace
}  // namespace tp100::firmware
