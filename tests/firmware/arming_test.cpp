// Tests arm, disarm and stop.

#include <gtest/gtest.h>

#include "bench.h"

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
    bench.connect();
    bench.streams = true;
    bench.run(20);
  }
  wire::Acknowledge arm(const wire::Arm& message) {
    bench.send(message);
    bench.run(2);
    return bench.acknowledges.back();
  }

  Bench bench;
};

TEST_F(Arming, AFreshTokenArms) {
  const wire::Acknowledge answer = bench.arm();
  EXPECT_EQ(result(answer), Result::kAccepted);
  EXPECT_EQ(answer.token, bench.token);
  EXPECT_EQ(bench.program.state(), State::kArmed);
}

TEST_F(Arming, OfAnotherBootIsRefused) {
  wire::Arm message = bench.arm_message();
  message.boot_nonce += 1;
  EXPECT_EQ(result(arm(message)), Result::kWrongBoot);
  EXPECT_EQ(bench.program.state(), State::kDisarmed);
}

TEST_F(Arming, ExpiredOrFarAheadIsRefused) {
  wire::Arm message = bench.arm_message();
  message.expiry_us = bench.hal.now_us - 10;
  EXPECT_EQ(result(arm(message)), Result::kOutOfRange);
  message.token = ++bench.token;
  message.expiry_us = bench.hal.now_us + 502'000;
  EXPECT_EQ(result(arm(message)), Result::kOutOfRange);
  EXPECT_EQ(bench.program.state(), State::kDisarmed);
}

TEST_F(Arming, TheSameTokenAgainIsAcknowledgedWithoutEffect) {
  const wire::Arm message = bench.arm_message();
  arm(message);
  bench.send(wire::Disarm{1});
  bench.run(2);
  ASSERT_EQ(bench.program.state(), State::kDisarmed);
  EXPECT_EQ(result(arm(message)), Result::kAccepted);
  EXPECT_EQ(bench.program.state(), State::kDisarmed);
}

TEST_F(Arming, ALowerTokenIsStale) {
  wire::Arm message = bench.arm_message();
  arm(message);
  bench.send(wire::Disarm{1});
  message.token -= 1;
  EXPECT_EQ(result(arm(message)), Result::kStaleToken);
  EXPECT_EQ(bench.program.state(), State::kDisarmed);
}

TEST_F(Arming, WithoutAFreshCommandIsRefused) {
  bench.streams = false;
  bench.run(250);
  const wire::Acknowledge answer = bench.arm();
  EXPECT_EQ(result(answer), Result::kFaultPersists);
  EXPECT_EQ(answer.detail, mask(Fault::command_timeout));
}

TEST_F(Arming, WithoutParametersIsRefused) {
  bench.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
  bench.run(2);
  const wire::Acknowledge answer = bench.arm();
  EXPECT_EQ(result(answer), Result::kFaultPersists);
  EXPECT_NE(answer.detail & mask(Fault::parameters_missing), 0);
}

TEST_F(Arming, WithEmptyCellsIsRefused) {
  bench.hal.pack_mv = 5500;
  bench.run(500);
  const wire::Acknowledge answer = bench.arm();
  EXPECT_EQ(result(answer), Result::kFaultPersists);
  EXPECT_EQ(answer.detail, mask(Fault::battery_low));
}

TEST_F(Arming, WithADeadImuIsRefusedOnlyIfTheGyroIsUsed) {
  bench.hal.imu_answers = false;
  bench.run(200);
  const wire::Acknowledge answer = bench.arm();
  EXPECT_EQ(result(answer), Result::kFaultPersists);
  EXPECT_EQ(answer.detail, mask(Fault::imu_stale));

  Bench bench_setup;
  bench_setup.parameters.flags = 0;
  bench_setup.hal.imu_answers = false;
  bench_setup.drive();
  EXPECT_EQ(bench_setup.program.state(), State::kRunning);
  EXPECT_EQ(bench_setup.program.faults(), 0);
}

TEST_F(Arming, ClearsLatchedFaultsWhoseCauseIsGone) {
  bench.arm();
  bench.streams = false;
  bench.run(250);
  ASSERT_EQ(bench.program.state(), State::kFaulted);
  bench.streams = true;
  bench.run(500);
  EXPECT_EQ(bench.program.state(), State::kFaulted) << "a stream of commands must not re-arm";
  EXPECT_EQ(result(bench.arm()), Result::kAccepted);
  EXPECT_EQ(bench.program.faults(), 0);
  EXPECT_EQ(bench.program.state(), State::kArmed);
}

TEST_F(Arming, AnAcceptedTokenDoesNotClearALaterFault) {
  const wire::Arm message = bench.arm_message();
  arm(message);
  bench.send(wire::Stop{3});
  bench.run(2);
  arm(message);
  EXPECT_TRUE(bench.has(Fault::stop_requested));
  EXPECT_EQ(bench.program.state(), State::kFaulted);
}

TEST(Boot, AfterTheWatchdogTheFaultIsLatchedUntilArmed) {
  Bench bench(false);
  bench.hal.cause = wire::ResetCause::kWatchdog;
  bench.boot();
  bench.connect();
  EXPECT_EQ(bench.program.state(), State::kFaulted);
  EXPECT_TRUE(bench.has(Fault::watchdog_reset));
  ASSERT_EQ(bench.reports.size(), 1U);
  bench.streams = true;
  bench.run(20);
  bench.arm();
  EXPECT_EQ(bench.program.state(), State::kArmed);
  EXPECT_EQ(bench.program.faults(), 0);
}

TEST(Boot, AfterABrownOutTheFaultIsLatched) {
  Bench bench(false);
  bench.hal.cause = wire::ResetCause::kBrownOut;
  bench.boot();
  bench.run(5);
  EXPECT_TRUE(bench.has(Fault::brown_out));
  ASSERT_FALSE(bench.hellos.empty());
  EXPECT_EQ(bench.hellos[0].faults, mask(Fault::brown_out));
}

// Brings the firmware to a state by the shortest sequence.
void bring_to(Bench& bench, State state) {
  if (state == State::kHello) return;
  if (state == State::kParameters) {
    bench.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
    bench.run(2);
    return;
  }
  bench.connect();
  bench.streams = true;
  bench.run(20);
  if (state >= State::kArmed) bench.arm();
  if (state >= State::kRunning) {
    bench.speed_mps = 0.1f;
    bench.run(20);
  }
  if (state == State::kFaulted) {
    bench.streams = false;
    bench.run(250);
    bench.streams = true;
  }
}

class InEveryState : public testing::TestWithParam<State> {};

TEST_P(InEveryState, StopSwitchesOffLatchesAndIsAcknowledged) {
  Bench bench;
  bring_to(bench, GetParam());
  ASSERT_EQ(bench.program.state(), GetParam());
  bench.send(wire::Stop{42});
  bench.run(2);
  EXPECT_FALSE(bench.motors_on());
  EXPECT_TRUE(bench.has(Fault::stop_requested));
  ASSERT_FALSE(bench.acknowledges.empty());
  EXPECT_EQ(bench.acknowledges.back().request, static_cast<std::uint8_t>(Type::kStop));
  EXPECT_EQ(bench.acknowledges.back().token, 42U);
  EXPECT_EQ(result(bench.acknowledges.back()), Result::kAccepted);
  bench.run(100);
  EXPECT_FALSE(bench.motors_on());
  EXPECT_EQ(bench.program.state() == State::kFaulted, GetParam() >= State::kDisarmed);
}

TEST_P(InEveryState, DisarmSwitchesOffWithoutAFaultAndIsAcknowledged) {
  Bench bench;
  bring_to(bench, GetParam());
  const std::uint16_t faults = bench.program.faults();
  bench.send(wire::Disarm{43});
  bench.run(2);
  EXPECT_FALSE(bench.motors_on());
  EXPECT_EQ(bench.program.faults(), faults);
  ASSERT_FALSE(bench.acknowledges.empty());
  EXPECT_EQ(bench.acknowledges.back().token, 43U);
  bench.run(100);
  EXPECT_FALSE(bench.motors_on());
  const bool was_on = GetParam() == State::kArmed || GetParam() == State::kRunning;
  EXPECT_EQ(bench.program.state(), was_on ? State::kDisarmed : GetParam());
  EXPECT_EQ(bench.count_logs("motors off: disarm"), was_on ? 1 : 0);
}

TEST_P(InEveryState, AHangingLoopIsSwitchedOffWithin101Ms) {
  Bench bench;
  bring_to(bench, GetParam());
  const bool session = GetParam() >= State::kDisarmed;
  bench.hang(101);
  EXPECT_FALSE(bench.motors_on());
  bench.run(5);
  EXPECT_TRUE(bench.has(Fault::loop_hung));
  EXPECT_EQ(bench.program.state(), session ? State::kFaulted : GetParam());
  bench.run(100);
  EXPECT_FALSE(bench.motors_on());
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
