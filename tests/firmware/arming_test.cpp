// Tests arm, disarm and stop.

#include <gtest/gtest.h>

#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::Fault;
using wire::Result;
using wire::State;
using wire::Type;

std::uint16_t mask(Fault fault) { return static_cast<std::uint16_t>(wire::fault_bit(fault)); }

Result result(const wire::Acknowledge& answer) { return static_cast<Result>(answer.result); }

class Arming : public testing::Test {
 protected:
  Arming() {
    rig.connect();
    rig.streams = true;
    rig.run(20);
  }
  wire::Acknowledge arm(const wire::Arm& message) {
    rig.send(message);
    rig.run(2);
    return rig.acknowledges.back();
  }

  Rig rig;
};

TEST_F(Arming, AFreshTokenArms) {
  const wire::Acknowledge answer = rig.arm();
  EXPECT_EQ(result(answer), Result::kAccepted);
  EXPECT_EQ(answer.token, rig.token);
  EXPECT_EQ(rig.program.state(), State::kArmed);
}

TEST_F(Arming, ARefusalNamesEachCause) {
  rig.hal.pack_mv = 5000;
  rig.hal.imu_answers = false;
  rig.run(400);
  rig.streams = false;
  rig.run(300);
  EXPECT_EQ(arm(rig.arm_message()).detail,
            mask(Fault::command_timeout) | mask(Fault::imu_stale) | mask(Fault::battery_low));
}

TEST_F(Arming, TheFirstTokenMayBeZero) {
  wire::Arm message = rig.arm_message();
  message.token = 0;
  EXPECT_EQ(result(arm(message)), Result::kAccepted);
  EXPECT_EQ(rig.program.state(), State::kArmed);
}

TEST_F(Arming, OfAnotherBootIsRefused) {
  wire::Arm message = rig.arm_message();
  message.boot_nonce += 1;
  EXPECT_EQ(result(arm(message)), Result::kWrongBoot);
  EXPECT_EQ(rig.program.state(), State::kDisarmed);
}

TEST_F(Arming, ExpiredOrFarAheadIsRefused) {
  wire::Arm message = rig.arm_message();
  message.expiry_us = rig.hal.now_us - 10;
  EXPECT_EQ(result(arm(message)), Result::kOutOfRange);
  message.token = ++rig.token;
  message.expiry_us = rig.hal.now_us + 502'000;
  EXPECT_EQ(result(arm(message)), Result::kOutOfRange);
  EXPECT_EQ(rig.program.state(), State::kDisarmed);
}

TEST_F(Arming, IsRefusedInTheLastMillisecondOfACommand) {
  rig.streams = false;
  rig.send(rig.command());
  rig.run(194);
  const wire::Acknowledge answer = arm(rig.arm_message());
  EXPECT_EQ(result(answer), Result::kFaultPersists);
  EXPECT_EQ(answer.detail, mask(Fault::command_timeout));
  EXPECT_EQ(rig.program.state(), State::kDisarmed);
}

TEST_F(Arming, TheSameTokenAgainIsAcknowledgedWithoutEffect) {
  const wire::Arm message = rig.arm_message();
  arm(message);
  rig.send(wire::Disarm{1});
  rig.run(2);
  ASSERT_EQ(rig.program.state(), State::kDisarmed);
  EXPECT_EQ(result(arm(message)), Result::kAccepted);
  EXPECT_EQ(rig.program.state(), State::kDisarmed);
}

TEST_F(Arming, ALowerTokenIsStale) {
  wire::Arm message = rig.arm_message();
  arm(message);
  rig.send(wire::Disarm{1});
  message.token -= 1;
  EXPECT_EQ(result(arm(message)), Result::kStaleToken);
  EXPECT_EQ(rig.program.state(), State::kDisarmed);
}

TEST_F(Arming, WithoutAFreshCommandIsRefused) {
  rig.streams = false;
  rig.run(250);
  const wire::Acknowledge answer = rig.arm();
  EXPECT_EQ(result(answer), Result::kFaultPersists);
  EXPECT_EQ(answer.detail, mask(Fault::command_timeout));
}

TEST_F(Arming, WithoutParametersIsRefused) {
  rig.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
  rig.run(2);
  const wire::Acknowledge answer = rig.arm();
  EXPECT_EQ(result(answer), Result::kFaultPersists);
  EXPECT_NE(answer.detail & mask(Fault::parameters_missing), 0);
}

TEST_F(Arming, WithAnEmptyBatteryIsRefused) {
  rig.hal.pack_mv = 5500;
  rig.run(500);
  const wire::Acknowledge answer = rig.arm();
  EXPECT_EQ(result(answer), Result::kFaultPersists);
  EXPECT_EQ(answer.detail, mask(Fault::battery_low));
}

TEST_F(Arming, WithADeadImuIsRefusedOnlyIfTheGyroIsUsed) {
  rig.hal.imu_answers = false;
  rig.run(200);
  const wire::Acknowledge answer = rig.arm();
  EXPECT_EQ(result(answer), Result::kFaultPersists);
  EXPECT_EQ(answer.detail, mask(Fault::imu_stale));

  Rig bench_setup;
  bench_setup.parameters.flags = 0;
  bench_setup.hal.imu_answers = false;
  bench_setup.drive();
  EXPECT_EQ(bench_setup.program.state(), State::kRunning);
  EXPECT_EQ(bench_setup.program.faults(), 0);
}

TEST_F(Arming, ClearsLatchedFaultsWhoseCauseIsGone) {
  rig.arm();
  rig.streams = false;
  rig.run(250);
  ASSERT_EQ(rig.program.state(), State::kFaulted);
  rig.streams = true;
  rig.run(500);
  EXPECT_EQ(rig.program.state(), State::kFaulted) << "a stream of commands must not re-arm";
  EXPECT_EQ(result(rig.arm()), Result::kAccepted);
  EXPECT_EQ(rig.program.faults(), 0);
  EXPECT_EQ(rig.program.state(), State::kArmed);
}

TEST_F(Arming, AnAcceptedTokenDoesNotClearALaterFault) {
  const wire::Arm message = rig.arm_message();
  arm(message);
  rig.send(wire::Stop{3});
  rig.run(2);
  arm(message);
  EXPECT_TRUE(rig.has(Fault::stop_requested));
  EXPECT_EQ(rig.program.state(), State::kFaulted);
}

TEST(Boot, AfterTheWatchdogTheFaultIsLatchedUntilArmed) {
  Rig rig(false);
  rig.hal.cause = wire::ResetCause::kWatchdog;
  rig.boot();
  rig.connect();
  EXPECT_EQ(rig.program.state(), State::kFaulted);
  EXPECT_TRUE(rig.has(Fault::watchdog_reset));
  ASSERT_EQ(rig.reports.size(), 1U);
  rig.streams = true;
  rig.run(20);
  rig.arm();
  EXPECT_EQ(rig.program.state(), State::kArmed);
  EXPECT_EQ(rig.program.faults(), 0);
}

TEST(Boot, AfterABrownOutTheFaultIsLatched) {
  Rig rig(false);
  rig.hal.cause = wire::ResetCause::kBrownOut;
  rig.boot();
  rig.run(5);
  EXPECT_TRUE(rig.has(Fault::brown_out));
  ASSERT_FALSE(rig.hellos.empty());
  EXPECT_EQ(rig.hellos[0].faults, mask(Fault::brown_out));
}

// Brings the firmware to a state by the shortest sequence.
void bring_to(Rig& rig, State state) {
  if (state == State::kHello) return;
  if (state == State::kParameters) {
    rig.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
    rig.run(2);
    return;
  }
  rig.connect();
  rig.streams = true;
  rig.run(20);
  if (state >= State::kArmed) rig.arm();
  if (state >= State::kRunning) {
    rig.speed_mps = 0.1f;
    rig.run(20);
  }
  if (state == State::kFaulted) {
    rig.streams = false;
    rig.run(250);
    rig.streams = true;
  }
}

class InEveryState : public testing::TestWithParam<State> {};

TEST_P(InEveryState, StopSwitchesOffLatchesAndIsAcknowledged) {
  Rig rig;
  bring_to(rig, GetParam());
  ASSERT_EQ(rig.program.state(), GetParam());
  rig.send(wire::Stop{42});
  rig.run(2);
  EXPECT_FALSE(rig.motors_on());
  EXPECT_TRUE(rig.has(Fault::stop_requested));
  ASSERT_FALSE(rig.acknowledges.empty());
  EXPECT_EQ(rig.acknowledges.back().request, static_cast<std::uint8_t>(Type::kStop));
  EXPECT_EQ(rig.acknowledges.back().token, 42U);
  EXPECT_EQ(result(rig.acknowledges.back()), Result::kAccepted);
  rig.run(100);
  EXPECT_FALSE(rig.motors_on());
  EXPECT_EQ(rig.program.state() == State::kFaulted, GetParam() >= State::kDisarmed);
}

TEST_P(InEveryState, DisarmSwitchesOffWithoutAFaultAndIsAcknowledged) {
  Rig rig;
  bring_to(rig, GetParam());
  const std::uint16_t faults = rig.program.faults();
  rig.send(wire::Disarm{43});
  rig.run(2);
  EXPECT_FALSE(rig.motors_on());
  EXPECT_EQ(rig.program.faults(), faults);
  ASSERT_FALSE(rig.acknowledges.empty());
  EXPECT_EQ(rig.acknowledges.back().token, 43U);
  rig.run(100);
  EXPECT_FALSE(rig.motors_on());
  const bool was_on = GetParam() == State::kArmed || GetParam() == State::kRunning;
  EXPECT_EQ(rig.program.state(), was_on ? State::kDisarmed : GetParam());
  EXPECT_EQ(rig.count_logs("motors off: disarm"), was_on ? 1 : 0);
}

TEST_P(InEveryState, AHangingLoopIsSwitchedOffWithin101Ms) {
  Rig rig;
  bring_to(rig, GetParam());
  const bool session = GetParam() >= State::kDisarmed;
  rig.hang(101);
  EXPECT_FALSE(rig.motors_on());
  rig.run(5);
  EXPECT_TRUE(rig.has(Fault::loop_hung));
  EXPECT_EQ(rig.program.state(), session ? State::kFaulted : GetParam());
  rig.run(100);
  EXPECT_FALSE(rig.motors_on());
}

std::string name_of(const testing::TestParamInfo<State>& info) {
  const char* const names[] = {"Hello", "Parameters", "Disarmed", "Armed", "Running", "Faulted"};
  return names[static_cast<int>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(States, InEveryState,
                         testing::Values(State::kHello, State::kParameters, State::kDisarmed,
                                         State::kArmed, State::kRunning, State::kFaulted),
                         name_of);

}  // namespace
}  // namespace tp100::firmware
