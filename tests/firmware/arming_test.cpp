// Tests arm, disarm and stop.

#include <gtest/gtest.h>

#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::Fault;
using wire::Result;
using wire::State;
using wire::Type;

Result result(const wire::Acknowledge& answer) { return static_cast<Result>(answer.result); }

// The robot is disarmed and receives commands.
class Arming : public testing::Test {
 protected:
  Arming() { rig.be_ready(); }
  template <class Message>
  wire::Acknowledge ask(const Message& message) {
    rig.send(message);
    rig.run(2);
    return rig.acknowledges.back();
  }
  wire::Arm arm_with(std::uint32_t token, int ahead_us = 200'000) {
    return {rig.hal.nonce, token, rig.hal.now_us + static_cast<std::uint32_t>(ahead_us)};
  }

  Rig rig;
};

TEST_F(Arming, AFreshTokenWithAnExpiryOfUpToHalfASecondAheadArms) {
  for (const auto& [token, ahead_us] : {std::pair{0U, 1},
                                        {1U, 200'000},
                                        {2U, -10},
                                        {3U, 0},
                                        {0x80000000U, 500'000},
                                        {0x80000001U, 500'001},
                                        {0xFFFFFFFFU, 200'000}}) {
    const bool accepted = ahead_us > 0 && ahead_us <= 500'000;
    const wire::Acknowledge answer = ask(arm_with(token, ahead_us));
    EXPECT_EQ(answer.request, static_cast<std::uint8_t>(Type::kArm));
    EXPECT_EQ(answer.token, token);
    EXPECT_EQ(result(answer), accepted ? Result::kAccepted : Result::kOutOfRange) << ahead_us;
    EXPECT_EQ(answer.detail, accepted ? 0 : 2) << "the number of the field";
    EXPECT_EQ(rig.program.state(), accepted ? State::kArmed : State::kDisarmed) << ahead_us;
    ask(wire::Disarm{1});
  }
}

TEST_F(Arming, IsRefusedForEveryCauseThatPersists) {
  const auto expect = [&](int causes) {
    const wire::Acknowledge answer = rig.arm();
    EXPECT_EQ(result(answer), Result::kFaultPersists);
    EXPECT_EQ(answer.detail, causes);
    EXPECT_FALSE(rig.motors_on());
  };
  rig.streams = false;
  rig.send(rig.command());
  rig.run(194);
  expect(mask(Fault::command_timeout));  // its last millisecond is too short to arm
  rig.hal.pack_mv = 5500;
  rig.run(500);
  expect(mask(Fault::command_timeout) | mask(Fault::battery_low));
  rig.streams = true;
  rig.run(20);
  expect(mask(Fault::battery_low));
  rig.hal.imu_answers = false;
  rig.run(200);
  expect(mask(Fault::battery_low) | mask(Fault::imu_stale));
  rig.hal.pack_mv = 7900;
  rig.run(500);
  expect(mask(Fault::imu_stale));
  rig.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
  rig.run(2);
  expect(mask(Fault::parameters_missing));

  Rig bench_setup;
  bench_setup.parameters.flags = 0;
  bench_setup.hal.imu_answers = false;
  bench_setup.drive();
  EXPECT_EQ(bench_setup.program.state(), State::kRunning) << "the gyro is not used";
  EXPECT_EQ(bench_setup.program.faults(), 0);
}

TEST_F(Arming, IsJudgedInTheOrderOfTheDocument) {
  // The message is wrong in every respect; its errors are corrected one after the other.
  rig.streams = false;
  rig.run(250);
  wire::Arm message{rig.hal.nonce ^ 1U, 40, 0};
  EXPECT_EQ(result(ask(message)), Result::kWrongBoot);
  message.boot_nonce = rig.hal.nonce;
  EXPECT_EQ(result(ask(message)), Result::kOutOfRange);
  message.token = 39;
  EXPECT_EQ(result(ask(message)), Result::kStaleToken);
  EXPECT_EQ(result(ask(arm_with(41))), Result::kFaultPersists);
}

// A delayed copy of a request must not get another answer than the one the host acted upon.
TEST_F(Arming, ARefusalUsesUpTheTokenUnlessItIsOfAnotherBootOrStale) {
  EXPECT_EQ(result(ask(arm_with(50, 600'000))), Result::kOutOfRange);
  wire::Arm other = arm_with(1000);
  other.boot_nonce ^= 1U;
  EXPECT_EQ(result(ask(other)), Result::kWrongBoot);
  EXPECT_EQ(result(ask(arm_with(40))), Result::kStaleToken);
  const wire::Acknowledge again = ask(arm_with(50));
  EXPECT_EQ(result(again), Result::kOutOfRange);
  EXPECT_EQ(again.detail, 2);
  rig.streams = false;
  rig.run(250);
  EXPECT_EQ(result(ask(arm_with(51))), Result::kFaultPersists);
  rig.streams = true;
  rig.run(20);
  EXPECT_EQ(result(ask(arm_with(51))), Result::kFaultPersists);
  EXPECT_FALSE(rig.motors_on());
  EXPECT_EQ(result(ask(arm_with(52))), Result::kAccepted);
  rig.connect();
  EXPECT_EQ(result(ask(arm_with(51))), Result::kStaleToken) << "tokens outlive a session";
}

TEST_F(Arming, AnAcceptedTokenAgainIsAcknowledgedWithoutEffect) {
  const wire::Arm message = rig.arm_message();
  ask(message);
  ask(wire::Disarm{1});
  EXPECT_EQ(result(ask(message)), Result::kAccepted);
  EXPECT_EQ(rig.program.state(), State::kDisarmed);
  ask(wire::Stop{3});
  ask(message);
  EXPECT_TRUE(rig.has(Fault::stop_requested));
  EXPECT_EQ(rig.program.state(), State::kFaulted);
}

TEST_F(Arming, WhileRunningChangesNothing) {
  rig.tracks_follow = true;
  rig.drive();
  rig.run(1000);
  const double mps = rig.left_mps;
  EXPECT_EQ(result(rig.arm()), Result::kAccepted);
  rig.run(10);
  EXPECT_EQ(rig.program.state(), State::kRunning);
  EXPECT_NEAR(rig.left_mps, mps, 0.01) << "the control loops were reset";
  EXPECT_EQ(result(ask(arm_with(rig.token + 1, 600'000))), Result::kOutOfRange);
  EXPECT_EQ(rig.program.state(), State::kRunning);
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

TEST(Boot, AfterTheWatchdogOrABrownOutTheFaultIsLatchedUntilArmed) {
  for (const auto& [cause, fault] : {std::pair{wire::ResetCause::kWatchdog, Fault::watchdog_reset},
                                     std::pair{wire::ResetCause::kBrownOut, Fault::brown_out}}) {
    Rig rig(false);
    rig.hal.cause = cause;
    rig.boot();
    rig.connect();
    ASSERT_FALSE(rig.hellos.empty());
    EXPECT_EQ(rig.hellos[0].faults, mask(fault));
    EXPECT_EQ(rig.hellos[0].reset_cause, static_cast<std::uint8_t>(cause));
    EXPECT_EQ(rig.program.state(), State::kFaulted);
    EXPECT_EQ(rig.program.faults(), mask(fault));
    ASSERT_EQ(rig.reports.size(), 1U);
    rig.drive(0.0f);
    EXPECT_EQ(rig.program.state(), State::kArmed);
    EXPECT_EQ(rig.program.faults(), 0);
  }
}

class InEveryState : public testing::TestWithParam<State> {
 protected:
  InEveryState() {
    if (before == State::kParameters) {
      rig.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
      rig.run(2);
    }
    if (before == State::kDisarmed) rig.be_ready();
    if (before >= State::kArmed) rig.drive(before == State::kArmed ? 0.0f : 0.1f);
    if (before == State::kFaulted) {
      rig.streams = false;
      rig.run(250);
      rig.streams = true;
    }
    EXPECT_EQ(rig.program.state(), before);
  }
  // Else the host takes the motors for running without a request, and reports a robot that stopped.
  bool reports_duty() const {
    return !rig.samples.empty() &&
           (rig.samples.back().left_duty != 0 || rig.samples.back().right_duty != 0);
  }

  const State before = GetParam();
  Rig rig;
};

TEST_P(InEveryState, StopSwitchesOffLatchesAndIsAcknowledged) {
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
  EXPECT_FALSE(reports_duty());
  EXPECT_EQ(rig.program.state() == State::kFaulted, before >= State::kDisarmed);
}

TEST_P(InEveryState, DisarmSwitchesOffWithoutAFaultAndIsAcknowledged) {
  const std::uint16_t faults = rig.program.faults();
  rig.send(wire::Disarm{43});
  rig.run(2);
  EXPECT_FALSE(rig.motors_on());
  EXPECT_EQ(rig.program.faults(), faults);
  ASSERT_FALSE(rig.acknowledges.empty());
  EXPECT_EQ(rig.acknowledges.back().token, 43U);
  rig.run(100);
  EXPECT_FALSE(rig.motors_on());
  EXPECT_FALSE(reports_duty());
  const bool was_on = before == State::kArmed || before == State::kRunning;
  EXPECT_EQ(rig.program.state(), was_on ? State::kDisarmed : before);
  EXPECT_EQ(rig.count_logs("motors off: disarm"), was_on ? 1 : 0);
}

TEST_P(InEveryState, AHangingLoopIsSwitchedOffAfter100Ms) {
  rig.hang(98);  // a first tick was after the last loop
  EXPECT_EQ(rig.motors_on(), before == State::kRunning);
  rig.hang(1);
  EXPECT_FALSE(rig.motors_on());
  rig.hang(1);  // in Hello the last loop was a tick later
  rig.run(5);
  EXPECT_TRUE(rig.has(Fault::loop_hung));
  EXPECT_EQ(rig.program.state(), before >= State::kDisarmed ? State::kFaulted : before);
  rig.run(100);
  EXPECT_FALSE(rig.motors_on()) << "a loop that resumes must not switch them on again";
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
