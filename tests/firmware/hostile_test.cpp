// Tests that no input moves a disarmed robot.

#include <gtest/gtest.h>

#include <random>

#include "bench.h"

namespace tp100::firmware {
namespace {

using wire::State;

bool may_move(State state) { return state == State::kArmed || state == State::kRunning; }

class Hostile : public testing::TestWithParam<unsigned> {
 protected:
  std::uint32_t random() { return static_cast<std::uint32_t>(source_()); }
  std::uint32_t below(std::uint32_t limit) { return random() % limit; }

  // Sends a frame with a valid CRC around random fields; half of the frames have the right nonce.
  void push_random_frame(Bench& bench) {
    const std::uint8_t types[] = {0x41, 0x42, 0x43, 0x44, 0x45, 0x46, 0x47, 0x01, 0x02, 0x99};
    const std::size_t sizes[] = {6, 71, 40, 12, 4, 4, 2, 18, 40, 3};
    const std::uint32_t which = below(10);
    std::uint8_t payload[wire::kMaxPayload] = {};
    for (std::uint8_t& byte : payload) byte = static_cast<std::uint8_t>(random());
    if (below(2) == 0) {
      for (int i = 0; i < 4; ++i) {
        payload[i] = static_cast<std::uint8_t>(bench.hal.nonce >> (8 * i));
      }
    }
    const std::size_t size = below(10) == 0 ? below(wire::kMaxPayload) : sizes[which];
    std::uint8_t frame[wire::kMaxFrame];
    const std::size_t length = wire::encode_frame(types[which], payload, size, frame);
    bench.hal.received.insert(bench.hal.received.end(), frame, frame + length);
  }

  std::mt19937_64 source_{GetParam()};
};

TEST_P(Hostile, RandomBytesNeverArm) {
  Bench bench;
  bench.connect();
  for (int i = 0; i < 2000; ++i) {
    const std::uint32_t count = below(60);
    for (std::uint32_t k = 0; k < count; ++k) {
      bench.hal.received.push_back(static_cast<std::uint8_t>(random() & (below(8) ? 0xFFU : 0U)));
    }
    bench.run(2);
    ASSERT_FALSE(may_move(bench.program.state()));
  }
  EXPECT_EQ(bench.hal.nonzero_writes, 0);
}

TEST_P(Hostile, RandomValidFramesNeverMoveADisarmedRobot) {
  Bench bench;
  bench.connect();
  for (int i = 0; i < 3000; ++i) {
    push_random_frame(bench);
    bench.run(1);
    ASSERT_FALSE(may_move(bench.program.state()));
    if (i % 500 == 0) bench.connect();
  }
  EXPECT_EQ(bench.hal.nonzero_writes, 0);
}

TEST_P(Hostile, CorruptedFramesOfAGoodHostNeverArm) {
  Bench bench;
  bench.connect();
  bench.streams = true;
  bench.speed_mps = 0.1f;
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::uint8_t> frame = Bench::frame_of(bench.arm_message());
    // One bit of the encoded frame is flipped, which the CRC must detect.
    const std::size_t at = below(static_cast<std::uint32_t>(frame.size() - 1));
    frame[at] = static_cast<std::uint8_t>(frame[at] ^ (1U << below(8)));
    if (frame[at] == 0) continue;
    bench.hal.received.insert(bench.hal.received.end(), frame.begin(), frame.end());
    bench.run(2);
    ASSERT_FALSE(may_move(bench.program.state()));
  }
  EXPECT_EQ(bench.hal.nonzero_writes, 0);
}

TEST_P(Hostile, NoiseOnTheWireDoesNotOutliveTheCommandLifeOfADrive) {
  Bench bench;
  bench.tracks_follow = true;
  bench.drive();
  bench.run(200);
  ASSERT_TRUE(bench.motors_on());
  bench.streams = false;
  for (int i = 0; i < 201; ++i) {
    for (int k = 0; k < 40; ++k) {
      bench.hal.received.push_back(static_cast<std::uint8_t>(random()));
    }
    bench.run(1);
  }
  EXPECT_FALSE(bench.motors_on());
}

INSTANTIATE_TEST_SUITE_P(Seeds, Hostile, testing::Range(1U, 6U), testing::PrintToStringParamName());

}  // namespace
}  // namespace tp100::firmware
