// Tests on both boards what firmware/PROTOCOL.md guarantees of a robot and depends on its hardware
// or its processor; tests/firmware has the rest.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "board_rig.h"
#include "wire/faults.h"

namespace tp100::sim {
namespace {

using wire::Fault;
using wire::State;

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
  wire::SyncReply sync() {
    rig().send(wire::SyncRequest{1});
    rig().run(10);
    return rig().sync_replies.back();
  }

 private:
  std::unique_ptr<BoardRig> rig_;
};

TEST_P(Conformance, ADisarmedRobotWaits700MsForACommandAndASecondForAnything) {
  rig().connect();
  const std::int64_t begin_ns = rig().sample_ns.front();
  const auto since_ms = [&] { return static_cast<double>(rig().now_ns - begin_ns) * 1e-6; };
  while (rig().last().faults == 0) rig().run(1);
  EXPECT_NEAR(since_ms(), 700.0, 15.0);
  EXPECT_EQ(rig().last().faults, wire::fault_bit(Fault::command_timeout));
  rig().hellos.clear();
  while (rig().hellos.empty()) rig().run(1);
  EXPECT_NEAR(since_ms(), 1000.0, 15.0);
}

TEST_P(Conformance, AUsbVoltageThatFallsWhileDrivingDoesNotHideAnEmptyBattery) {
  rig().battery_v = 6.3;
  rig().drive();
  rig().hardware().set_supply(4.5);
  rig().run(20'000);
  EXPECT_EQ(rig().state(), State::kRunning);
  EXPECT_NEAR(rig().last().battery_mv, 6300, 63);
  rig().battery_v = 5.8;  // it would read 6.4 V, above the cut-off, at a supply of 5 V
  EXPECT_GE(rig().ms_until_off(1200), 900);
  rig().run(20);
  EXPECT_EQ(rig().last().faults, wire::fault_bit(Fault::battery_low));
  EXPECT_EQ(rig().arm().result, static_cast<std::uint8_t>(wire::Result::kFaultPersists));
}

TEST_P(Conformance, EdgesThatWereMissedAreCountedInTheClockAnswer) {
  rig().be_ready();
  const std::uint16_t before = sync().missed_edges;
  // Both phases change at once, first on the left and then on the right encoder.
  for (const std::uint8_t a : std::to_array<std::uint8_t>({0, 2})) {
    rig().glitch(a);
    rig().run(5);
  }
  EXPECT_EQ(sync().missed_edges - before, 2);
}

// The expiry is a time of the board's clock, so it does not matter when the board reads the
// command.
TEST_P(Conformance, AnExpiredCommandSwitchesOffInTheTickBeforeItsExpiry) {
  rig().be_ready();
  // Virtual time at which the board's clock was 0, too early by the shortest delay between the
  // arrival of a request and the time of receipt in its answer.
  std::int64_t zero_ns = INT64_MIN;
  for (std::size_t spare = 0; spare < 40; ++spare) {
    rig().sync_replies.clear();
    rig().send_bytes(std::vector<std::uint8_t>(spare, wire::kDelimiter));
    const std::vector<std::uint8_t> request = test::frame_of(wire::SyncRequest{9});
    const std::int64_t arrival_ns =
        rig().now_ns + static_cast<std::int64_t>(spare + request.size()) * BoardRig::kByteNs;
    rig().send_bytes(request);
    rig().run(7);
    ASSERT_EQ(rig().sync_replies.size(), 1U);
    zero_ns =
        std::max(zero_ns, arrival_ns - std::int64_t{rig().sync_replies[0].received_us} * 1000);
  }
  for (std::uint32_t phase_us = 0; phase_us < 1000; phase_us += 90) {
    rig().speed_mps = 0.0f;
    rig().drive();
    ASSERT_TRUE(rig().moves());
    rig().streams = false;
    wire::Command last = rig().command();
    last.expiry_us = rig().device_us() + 195'000 + phase_us;
    rig().send(last);
    const std::int64_t expiry_ns = zero_ns + std::int64_t{last.expiry_us} * 1000;
    while (rig().now_ns < expiry_ns - 2 * BoardRig::kStepNs) rig().run(1);
    // The edges of the tracks can be ignored for so short a time.
    while (rig().moves() && rig().now_ns < expiry_ns + 5 * BoardRig::kStepNs) {
      rig().now_ns += 10'000;
      rig().hardware().advance(rig().now_ns, {}, {});
    }
    const double left_us = static_cast<double>(expiry_ns - rig().now_ns) / 1000.0;
    EXPECT_GE(left_us, 0.0) << phase_us;
    EXPECT_LE(left_us, 1000.0) << phase_us;
    rig().run(10);
    EXPECT_EQ(rig().last().faults, wire::fault_bit(Fault::command_timeout));
  }
}

std::string name_of(const ::testing::TestParamInfo<const char*>& test) { return test.param; }

INSTANTIATE_TEST_SUITE_P(Boards, Conformance, ::testing::Values("Native", "Avr"), name_of);

}  // namespace
}  // namespace tp100::sim
