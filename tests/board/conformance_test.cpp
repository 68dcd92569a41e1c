// What firmware/PROTOCOL.md promises of a robot, on both boards.

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>

#include "avr_rig.h"
#include "sim/board/native_board.h"
#include "wire/faults.h"

namespace tp100::sim {
namespace {

using wire::Fault;
using wire::Result;
using wire::State;
using wire::Type;

class NativeRig final : public BoardRig {
 public:
  NativeRig() : BoardRig(1), board({}, &imu) {}
  Board& hardware() override { return board; }

  NativeBoard board;
};

class Conformance : public ::testing::TestWithParam<const char*> {
 protected:
  Conformance() {
    if (GetParam() == std::string("Native")) {
      rig_ = std::make_unique<NativeRig>();
    } else {
      rig_ = std::make_unique<AvrRig>();
    }
    EXPECT_TRUE(rig().boot());
  }
  BoardRig& rig() { return *rig_; }
  /// Disarmed, with a fresh command.
  void be_ready() {
    rig().connect();
    rig().streams = true;
    rig().run(50);
    ASSERT_EQ(rig().state(), State::kDisarmed);
  }
  /// The answer to a message that is acknowledged.
  template <class Message>
  wire::Acknowledge ask(const Message& message) {
    rig().acknowledges.clear();
    rig().send(message);
    rig().run(10);
    EXPECT_EQ(rig().acknowledges.size(), 1U);
    return rig().acknowledges.empty() ? wire::Acknowledge{} : rig().acknowledges.back();
  }
  Result arm(const wire::Arm& message) { return static_cast<Result>(ask(message).result); }
  wire::Arm arm_with(std::uint32_t token, int ahead_ms = 200) {
    const auto ahead_us = static_cast<std::uint32_t>(ahead_ms * 1000);
    return {rig().nonce, token, rig().device_us() + ahead_us};
  }

 private:
  std::unique_ptr<BoardRig> rig_;
};

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
  EXPECT_EQ(arm(arm_with(50)), Result::kOutOfRange) << "a stale token has become the last one";
  EXPECT_EQ(arm(arm_with(51)), Result::kAccepted);
}

TEST_P(Conformance, EdgesThatWereMissedAreCountedInTheClockAnswer) {
  be_ready();
  const auto missed = [&] {
    rig().send(wire::SyncRequest{1});
    rig().run(10);
    return rig().sync_replies.back().missed_edges;
  };
  const std::uint16_t before = missed();
  // Both phases at once, on either encoder.
  for (const std::uint8_t a : std::to_array<std::uint8_t>({0, 2})) {
    rig().glitch(a);
    rig().run(5);
  }
  EXPECT_EQ(missed() - before, 2);
}

std::string name_of(const ::testing::TestParamInfo<const char*>& test) { return test.param; }

INSTANTIATE_TEST_SUITE_P(Boards, Conformance, ::testing::Values("Native", "Avr"), name_of);

}  // namespace
}  // namespace tp100::sim
