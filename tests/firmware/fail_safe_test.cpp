// Tests that the motors switch off by themselves.

#include <gtest/gtest.h>

#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::Fault;
using wire::State;

TEST(FailSafe, SilenceSwitchesARobotOffInTheLifeOfItsLastCommand) {
  struct Case {
    const char* name;
    std::uint16_t life_ms;
    float speed_mps;
    int expiry_ms;  ///< of the last command
    int on_ms, off_ms;
  };
  // The last command is at most 5 ms old, and those of the stream expire after 195 ms.
  for (const Case& one : {Case{"running", 200, 0.1f, 0, 185, 200},
                          {"armed", 200, 0.0f, 0, 185, 200},
                          {"a shorter life", 50, 0.1f, 0, 40, 52},
                          {"an earlier expiry", 200, 0.1f, 30, 25, 32}}) {
    SCOPED_TRACE(one.name);
    Rig rig;
    rig.parameters.command_life_ms = one.life_ms;
    rig.drive(one.speed_mps);  // in a young session, which grants an armed robot no grace
    const State before = one.speed_mps != 0.0f ? State::kRunning : State::kArmed;
    rig.streams = false;
    if (one.expiry_ms > 0) {
      wire::Command command = rig.command();
      command.expiry_us = rig.hal.now_us + static_cast<std::uint32_t>(one.expiry_ms * 1000);
      rig.send(command);
    }
    rig.run(one.on_ms);
    EXPECT_EQ(rig.program.state(), before);
    EXPECT_EQ(rig.motors_on(), before == State::kRunning);
    rig.run(one.off_ms - one.on_ms);
    EXPECT_FALSE(rig.motors_on());
    EXPECT_EQ(rig.program.state(), State::kFaulted);
    ASSERT_EQ(rig.reports.size(), 1U);
    EXPECT_EQ(rig.reports[0].fault, static_cast<std::uint8_t>(Fault::command_timeout));
    EXPECT_NEAR(rig.reports[0].detail, one.off_ms - 3, 10) << "how long it was silent";
    EXPECT_EQ(rig.count_logs("motors off: command_timeout"), 1);
    EXPECT_EQ(rig.hal.locks, 0) << "interrupts are let in again";
  }
}

TEST(FailSafe, AHangIsLoggedAndFeedsNoWatchdog) {
  Rig rig;
  rig.drive();
  const int kicks = rig.hal.kicks;
  rig.hang(100);
  EXPECT_EQ(rig.hal.kicks, kicks);
  rig.program.loop();
  EXPECT_EQ(rig.hal.kicks, kicks + 1);
  rig.run(50);
  EXPECT_EQ(rig.count_logs("motors off: loop_hung"), 1);
}

TEST(FailSafe, EveryTickForcesTheOutputsOfADisarmedRobotToZero) {
  Rig rig;
  rig.connect();
  rig.hal.duties = {500, 500};  // a stray write
  rig.program.tick_1khz();
  EXPECT_FALSE(rig.motors_on());
}

TEST(FailSafe, ADisarmedRobotWhoseCommandsEndLatchesAndReportsOncePerLatch) {
  Rig rig;
  for (const std::size_t latches : {1U, 2U}) {
    rig.be_ready();
    rig.arm();
    rig.send(wire::Disarm{1});
    rig.run(1000);
    EXPECT_EQ(rig.program.faults(), 0);
    rig.streams = false;
    rig.run(210);
    EXPECT_TRUE(rig.has(Fault::command_timeout));
    rig.run(700);
    EXPECT_EQ(rig.reports.size(), latches);
  }
}

TEST(FailSafeAlone, DrivesOnlyWhileEnabledAndIsEnabledOnlyWithAFreshCommand) {
  ScriptedHal hal;
  FailSafe fail_safe(hal);
  fail_safe.watch(hal.now_us);
  fail_safe.drive(300, 300);
  EXPECT_EQ(hal.duties, ScriptedHal::Duties{});
  EXPECT_FALSE(fail_safe.enable());
  fail_safe.fresh(hal.now_us, 50'000);
  EXPECT_TRUE(fail_safe.enable());
  fail_safe.drive(300, -200);
  EXPECT_EQ(hal.duties, (ScriptedHal::Duties{300, -200}));
  fail_safe.disable();
  EXPECT_EQ(hal.duties, ScriptedHal::Duties{}) << "not at once";
  EXPECT_TRUE(fail_safe.enable());
  fail_safe.drive(300, -200);
  for (int i = 0; i < 50; ++i) {
    hal.now_us += 1000;
    fail_safe.beat();
    fail_safe.tick();
  }
  EXPECT_EQ(hal.duties, ScriptedHal::Duties{});
  fail_safe.drive(300, 300);
  EXPECT_EQ(hal.duties, ScriptedHal::Duties{});
  fail_safe.fresh(hal.now_us, 50'000);
  EXPECT_FALSE(fail_safe.enable()) << "the main loop has not taken the trip yet";
  EXPECT_EQ(fail_safe.take_trip().faults, wire::fault_bit(Fault::command_timeout));
  EXPECT_TRUE(fail_safe.enable());
}

// Ticks come every millisecond, and a command can arrive at any time between two of them. The
// motors must be off before the command expires, though a tick may take up to 100 us.
TEST(FailSafeAlone, TheLastTickOfACommandsLifeSwitchesOff) {
  for (const std::uint32_t life_us : {200'000U, 199'999U, 123'456U, 50'000U, 5'001U}) {
    for (std::uint32_t phase_us = 0; phase_us < 1000; ++phase_us) {
      ScriptedHal hal;
      hal.now_us = 0U - 100'000U;  // the clock wraps during the test
      FailSafe fail_safe(hal);
      fail_safe.watch(hal.now_us);
      const std::uint32_t fresh_us = hal.now_us + phase_us;
      fail_safe.fresh(fresh_us, life_us);
      ASSERT_TRUE(fail_safe.enable());
      fail_safe.drive(300, 300);
      while (hal.duties != ScriptedHal::Duties{} && hal.now_us - fresh_us + 1000 < 300'000U) {
        hal.now_us += 1000;
        fail_safe.beat();
        fail_safe.tick();
      }
      const std::uint32_t age_us = hal.now_us - fresh_us;
      ASSERT_LT(age_us + 100, life_us) << "a tick too late at " << phase_us;
      ASSERT_GE(age_us + 1100, life_us) << "a tick too early at " << phase_us;
    }
  }
}

}  // namespace
}  // namespace tp100::firmware
