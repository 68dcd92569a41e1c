// Tests on both boards what firmware/PROTOCOL.md guarantees of arming.

#include <gtest/gtest.h>

#include <utility>

#include "conformance_rig.h"
#include "wire/faults.h"

namespace tp100::sim {
namespace {

using wire::Fault;
using wire::Result;
using wire::State;

TEST_P(Conformance, AnArmRefusedForItsExpiryHasUsedItsToken) {
  be_ready();
  for (const auto& [token, ahead_ms] : {std::pair{50U, 600}, std::pair{60U, -20}}) {
    const wire::Acknowledge refused = ask(arm_with(token, ahead_ms));
    EXPECT_EQ(static_cast<Result>(refused.result), Result::kOutOfRange);
    EXPECT_EQ(refused.detail, 2);
    const wire::Acknowledge again = ask(arm_with(token));
    EXPECT_EQ(static_cast<Result>(again.result), Result::kOutOfRange);
    EXPECT_EQ(again.detail, 2);
    EXPECT_EQ(arm(arm_with(token - 1)), Result::kStaleToken);
    EXPECT_EQ(rig().state(), State::kDisarmed);
  }
  EXPECT_EQ(arm(arm_with(61)), Result::kAccepted);
  rig().run(10);
  EXPECT_EQ(rig().state(), State::kArmed);
}

TEST_P(Conformance, AnArmRefusedForAFaultHasUsedItsToken) {
  rig().connect();
  const wire::Acknowledge refused = ask(arm_with(50));
  EXPECT_EQ(static_cast<Result>(refused.result), Result::kFaultPersists);
  EXPECT_EQ(refused.detail, wire::fault_bit(Fault::command_timeout));
  rig().streams = true;
  rig().run(50);
  EXPECT_EQ(arm(arm_with(50)), Result::kFaultPersists);
  EXPECT_EQ(arm(arm_with(49)), Result::kStaleToken);
  EXPECT_EQ(rig().state(), State::kDisarmed);
  EXPECT_EQ(arm(arm_with(51)), Result::kAccepted);
}

TEST_P(Conformance, AnArmOfAnotherBootOrWithAStaleTokenUsesNone) {
  be_ready();
  wire::Arm other = arm_with(1000);
  other.boot_nonce ^= 1U;
  EXPECT_EQ(arm(other), Result::kWrongBoot);
  EXPECT_EQ(arm(arm_with(50, 600)), Result::kOutOfRange);
  EXPECT_EQ(arm(arm_with(40)), Result::kStaleToken);
  EXPECT_EQ(arm(arm_with(50)), Result::kOutOfRange) << "the stale token replaced the last one";
  EXPECT_EQ(arm(arm_with(51)), Result::kAccepted);
}

TEST_P(Conformance, AnArmIsJudgedInTheOrderOfTheDocument) {
  rig().send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
  rig().run(5);
  // The message is wrong in every respect; its errors are corrected one after the other.
  wire::Arm message{rig().nonce ^ 1U, 40, 0};
  EXPECT_EQ(arm(message), Result::kWrongBoot);
  message.boot_nonce = rig().nonce;
  const wire::Acknowledge expired = ask(message);
  EXPECT_EQ(static_cast<Result>(expired.result), Result::kOutOfRange);
  message.token = 39;
  EXPECT_EQ(arm(message), Result::kStaleToken);
  const wire::Acknowledge without_session = ask(fresh_arm(41));
  EXPECT_EQ(static_cast<Result>(without_session.result), Result::kFaultPersists);
  EXPECT_EQ(without_session.detail, wire::fault_bit(Fault::parameters_missing));
  rig().connect();
  const wire::Acknowledge without_command = ask(arm_with(42));
  EXPECT_EQ(static_cast<Result>(without_command.result), Result::kFaultPersists);
  EXPECT_EQ(without_command.detail, wire::fault_bit(Fault::command_timeout));
}

TEST_P(Conformance, AfterTheHighestTokenABootArmsNoMore) {
  be_ready();
  EXPECT_EQ(arm(arm_with(0xFFFFFFFFU, 600)), Result::kOutOfRange);
  EXPECT_EQ(arm(arm_with(0)), Result::kStaleToken);
  rig().connect();
  EXPECT_EQ(arm(arm_with(1000)), Result::kStaleToken) << "the last token must outlive a session";
  EXPECT_EQ(arm(arm_with(0xFFFFFFFFU)), Result::kOutOfRange);
}

TEST_P(Conformance, AnArmWhileRunningChangesNothing) {
  be_ready();
  rig().drive();
  ASSERT_EQ(rig().state(), State::kRunning);
  rig().run(500);
  const std::int16_t duty = rig().last().left_duty;
  EXPECT_EQ(static_cast<Result>(rig().arm().result), Result::kAccepted);
  rig().run(10);
  EXPECT_EQ(rig().state(), State::kRunning);
  EXPECT_NEAR(rig().last().left_duty, duty, 30) << "the control loops were reset";
  EXPECT_EQ(arm(arm_with(rig().token + 1, 600)), Result::kOutOfRange);
  EXPECT_EQ(rig().state(), State::kRunning);
  EXPECT_TRUE(rig().moves());
}

TEST_P(Conformance, AStandstillAskedForWhileRunningStaysRunning) {
  be_ready();
  rig().drive();
  rig().speed_mps = 0.0f;
  rig().run(1000);
  EXPECT_FALSE(rig().moves());
  EXPECT_EQ(rig().state(), State::kRunning);
}

TEST_P(Conformance, AnArmedRobotOfAYoungSessionStopsAfter200MsWithoutCommands) {
  rig().connect();
  rig().streams = true;
  rig().run(30);
  ASSERT_EQ(static_cast<Result>(rig().arm().result), Result::kAccepted);
  rig().speed_mps = 0.15f;
  rig().run(60);
  ASSERT_TRUE(rig().moves());
  rig().streams = false;
  EXPECT_GE(rig().ms_until_off(201), 0);
  rig().run(20);
  EXPECT_NE(rig().last().faults & wire::fault_bit(Fault::command_timeout), 0U);
}

TEST_P(Conformance, ADisarmedRobotWaits700MsForTheFirstCommand) {
  rig().connect();
  const std::int64_t begin_ns = rig().sample_ns.front();
  while (rig().last().faults == 0) rig().run(1);
  EXPECT_NEAR(static_cast<double>(rig().now_ns - begin_ns) * 1e-6, 700.0, 15.0);
  EXPECT_EQ(rig().last().faults, wire::fault_bit(Fault::command_timeout));
}

}  // namespace
}  // namespace tp100::sim
