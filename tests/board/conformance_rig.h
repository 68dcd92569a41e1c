#pragma once
// Both boards, for tests of the guarantees of firmware/PROTOCOL.md. conformance_test.cpp names the
// boards.

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "avr_rig.h"
#include "sim/board/native_board.h"

namespace tp100::sim {

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
  /// Brings the robot to the disarmed state with a fresh command.
  void be_ready() {
    rig().connect();
    rig().streams = true;
    rig().run(50);
    ASSERT_EQ(rig().state(), wire::State::kDisarmed);
  }
  /// Sends a message and returns its acknowledgement.
  template <class Message>
  wire::Acknowledge ask(const Message& message) {
    rig().acknowledges.clear();
    rig().send(message);
    rig().run(10);
    EXPECT_EQ(rig().acknowledges.size(), 1U);
    return rig().acknowledges.empty() ? wire::Acknowledge{} : rig().acknowledges.back();
  }
  wire::Result arm(const wire::Arm& message) {
    return static_cast<wire::Result>(ask(message).result);
  }
  /// An arm message for a board that has just booted and sends no samples yet.
  wire::Arm fresh_arm(std::uint32_t token) {
    rig().sync_replies.clear();
    rig().send(wire::SyncRequest{9});
    rig().run(5);
    return {rig().nonce, token, rig().sync_replies.back().sent_us + 200'000};
  }
  static std::vector<std::uint8_t> frame(std::uint8_t type,
                                         const std::vector<std::uint8_t>& payload) {
    std::vector<std::uint8_t> bytes(wire::kMaxFrame);
    bytes.resize(wire::encode_frame(type, payload.data(), payload.size(), bytes.data()));
    return bytes;
  }
  /// Begins a new session with the flags of the test.
  void connect_with_flags() {
    wire::Parameters parameters = rig().parameters();
    parameters.token = ++rig().token;
    parameters.flags = static_cast<std::uint8_t>(flags_);
    rig().send(parameters);
    rig().run(30);
  }
  wire::Arm arm_with(std::uint32_t token, int ahead_ms = 200) {
    const auto ahead_us = static_cast<std::uint32_t>(ahead_ms * 1000);
    return {rig().nonce, token, rig().device_us() + ahead_us};
  }

  unsigned flags_ = wire::kUseGyro;

 private:
  std::unique_ptr<BoardRig> rig_;
};

}  // namespace tp100::sim
