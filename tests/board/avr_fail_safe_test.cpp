// Tests the fail-safe of the image that users flash, in every state and for every failure of a
// host.

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "avr_rig.h"

namespace tp100::sim {
namespace {

constexpr int kLimitMs = 200 + 5;  // life of a command and one loop

enum class Failure { kSilent, kGarbage, kFlood, kStale };
const char* const kFailures[] = {"Silent", "Garbage", "Flood", "Stale"};
const char* const kStates[] = {"Hello", "Parameters", "Disarmed", "Armed", "Running", "Faulted"};

void reach(AvrRig& rig, wire::State state) {
  ASSERT_TRUE(rig.boot());
  if (state == wire::State::kHello) return;
  if (state == wire::State::kParameters) {
    rig.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
    rig.run(5);
    ASSERT_EQ(rig.hellos.back().state, static_cast<std::uint8_t>(state));
    return;
  }
  rig.connect();
  rig.streams = true;
  rig.run(50);
  if (state == wire::State::kArmed || state == wire::State::kRunning) rig.arm();
  if (state == wire::State::kRunning) rig.speed_mps = 0.15f;
  if (state == wire::State::kFaulted) rig.send(wire::Stop{++rig.token});
  rig.run(300);
  ASSERT_EQ(rig.state(), state);
  ASSERT_EQ(rig.moves(), state == wire::State::kRunning);
}

/// Simulates one millisecond of a host that fails in this way.
void fail(AvrRig& rig, Failure failure, const std::vector<std::uint8_t>& stale, int ms) {
  switch (failure) {
    case Failure::kSilent:
      break;
    case Failure::kGarbage:
      if (ms % 3 == 0) {
        std::vector<std::uint8_t> bytes;
        for (int i = 0; i < 40; ++i) bytes.push_back(static_cast<std::uint8_t>(ms * 31 + i * 17));
        rig.send_bytes(bytes);
      }
      break;
    case Failure::kFlood: {  // bytes at line rate without the end of a frame
      rig.send_bytes(std::vector<std::uint8_t>(50, 0xA5));
      break;
    }
    case Failure::kStale:
      if (ms % 10 == 0) rig.send_bytes(stale);
      break;
  }
  rig.run(1);
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
  last.expiry_us = rig.device_us() + 195'000;
  for (int ms = 0; ms < 600; ++ms) {
    last.expiry_us = rig.device_us() + 195'000;
    fail(rig, failure, test::frame_of(last), ms);
    if (ms >= kLimitMs) {
      ASSERT_FALSE(rig.moves()) << ms << " ms after the host failed";
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
  rig.connect();
  rig.run(50);
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

TEST(AvrHang, AHungMainLoopStopsTheMotorsInTimeAndTheWatchdogRecovers) {
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.drive();
  ASSERT_TRUE(rig.moves());
  const std::size_t hellos = rig.hellos.size();
  rig.board.hang_main_loop();
  const int off_ms = rig.ms_until_off(kLimitMs);
  EXPECT_GE(off_ms, 0);
  // The timer switches the motors off before the watchdog is due.
  EXPECT_EQ(rig.board.counters().watchdog_resets, 0U);
  for (int ms = 0; ms < 500; ++ms) {
    rig.run(1);
    ASSERT_FALSE(rig.moves());
  }
  EXPECT_EQ(rig.board.counters().watchdog_resets, 1U);
  ASSERT_GT(rig.hellos.size(), hellos);
  EXPECT_EQ(rig.hellos.back().reset_cause, static_cast<std::uint8_t>(wire::ResetCause::kWatchdog));
  rig.speed_mps = 0.0f;
  rig.connect();
  rig.run(50);
  EXPECT_EQ(rig.arm().result, static_cast<std::uint8_t>(wire::Result::kAccepted));
}

TEST(AvrHang, AResetLetsTheMotorsGoAtOnce) {
  for (const PowerUp cause : {PowerUp::kExternal, PowerUp::kBrownOut, PowerUp::kPowerOn}) {
    AvrRig rig;
    ASSERT_TRUE(rig.boot());
    rig.drive();
    ASSERT_TRUE(rig.moves());
    rig.board.reset(cause, rig.now_ns);
    EXPECT_FALSE(rig.moves());
    for (int ms = 0; ms < 300; ++ms) {
      rig.run(1);
      ASSERT_FALSE(rig.moves());
    }
  }
}

}  // namespace
}  // namespace tp100::sim
