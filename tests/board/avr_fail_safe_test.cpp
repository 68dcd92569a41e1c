// Tests the fail-safe of the image that users flash, in every state and for every failure of a
// host.

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "board_rig.h"

namespace tp100::sim {
namespace {

constexpr int kLimitMs = 200 + 5;  // life of a command and one loop

enum class Failure { kSilent, kGarbage, kFlood, kStale };
const char* const kFailures[] = {"Silent", "Garbage", "Flood", "Stale"};
const char* const kStates[] = {"Hello", "Parameters", "Disarmed", "Armed", "Running", "Faulted"};

/// A bridge that is enabled brakes its track, also without a direction: a robot whose motors are
/// off could not be pushed. Timer 4 drives its enable, or the pin itself is high.
bool enables(AvrRig& rig) {
  constexpr std::size_t kTccr4a = 0xA0, kPorth = 0x102;
  const std::uint8_t* data = rig.board.core().data();
  return (data[kTccr4a] & 0xA0U) != 0 || (data[kPorth] & 0x18U) != 0;
}

void reach(AvrRig& rig, wire::State state) {
  ASSERT_TRUE(rig.boot());
  if (state == wire::State::kHello) return;
  if (state == wire::State::kParameters) {
    rig.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
    rig.run(5);
    ASSERT_EQ(rig.hellos.back().state, static_cast<std::uint8_t>(state));
    return;
  }
  rig.be_ready();
  if (state == wire::State::kArmed) rig.drive(0.0f);
  if (state == wire::State::kRunning) rig.drive(0.15f);
  if (state == wire::State::kFaulted) rig.send(wire::Stop{++rig.token});
  rig.run(100);
  ASSERT_EQ(rig.state(), state);
  ASSERT_EQ(rig.moves(), state == wire::State::kRunning);
  ASSERT_EQ(enables(rig), state == wire::State::kRunning);
}

/// What a host that fails in this way sends in one millisecond.
std::vector<std::uint8_t> sent_by(Failure failure, const wire::Command& stale, int ms) {
  std::vector<std::uint8_t> bytes;
  if (failure == Failure::kGarbage && ms % 3 == 0)
    for (int i = 0; i < 40; ++i) bytes.push_back(static_cast<std::uint8_t>(ms * 31 + i * 17));
  // Bytes at line rate without the end of a frame.
  if (failure == Failure::kFlood) bytes.assign(50, 0xA5);
  if (failure == Failure::kStale && ms % 10 == 0) bytes = test::frame_of(stale);
  return bytes;
}

class AvrFailSafe : public ::testing::TestWithParam<std::tuple<int, int>> {};

TEST_P(AvrFailSafe, MotorsAreOffInTimeAndStayOffUntilAFreshArm) {
  const auto state = static_cast<wire::State>(std::get<0>(GetParam()));
  const auto failure = static_cast<Failure>(std::get<1>(GetParam()));
  AvrRig rig;
  ASSERT_NO_FATAL_FAILURE(reach(rig, state));
  rig.streams = false;
  wire::Command last = rig.command();
  last.sequence = static_cast<std::uint16_t>(last.sequence - 1);
  last.speed_mps = 0.15f;
  for (int ms = 0; ms < 600; ++ms) {
    last.expiry_us = rig.device_us() + 195'000;
    rig.send_bytes(sent_by(failure, last, ms));
    rig.run(1);
    if (ms >= kLimitMs) {
      ASSERT_FALSE(rig.moves() || enables(rig)) << ms << " ms after the host failed";
    }
  }
  // The host sends good commands again, but has not armed the robot.
  rig.run(30);
  rig.streams = true;
  rig.speed_mps = 0.15f;
  for (int ms = 0; ms < 300; ++ms) {
    rig.run(1);
    ASSERT_FALSE(rig.moves()) << ms << " ms after the host came back";
  }
  rig.speed_mps = 0.0f;
  rig.be_ready();
  const wire::Acknowledge armed = rig.arm();
  ASSERT_EQ(armed.result, static_cast<std::uint8_t>(wire::Result::kAccepted))
      << "detail " << armed.detail;
  rig.speed_mps = 0.15f;
  rig.run(100);
  EXPECT_TRUE(rig.moves());
}

std::string name_of(const ::testing::TestParamInfo<std::tuple<int, int>>& test) {
  return std::string(kStates[std::get<0>(test.param)]) + kFailures[std::get<1>(test.param)];
}

INSTANTIATE_TEST_SUITE_P(States, AvrFailSafe,
                         ::testing::Combine(::testing::Range(0, 6), ::testing::Range(0, 4)),
                         name_of);

}  // namespace
}  // namespace tp100::sim
