// Tests on both boards what firmware/PROTOCOL.md guarantees of a robot.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "conformance_rig.h"
#include "wire/faults.h"

namespace tp100::sim {
namespace {

using wire::Fault;
using wire::Result;
using wire::State;
using wire::Type;

TEST_P(Conformance, ParametersAreJudgedInTheOrderOfTheDocument) {
  be_ready();
  const wire::Parameters open = rig().parameters();
  EXPECT_EQ(static_cast<Result>(ask(open).result), Result::kAccepted)
      << "the parameters of the open session";
  ASSERT_EQ(static_cast<Result>(rig().arm().result), Result::kAccepted);
  wire::Parameters message = open;
  EXPECT_EQ(static_cast<Result>(ask(message).result), Result::kWrongState);
  message.wheelbase_m = 0.0f;
  EXPECT_EQ(static_cast<Result>(ask(message).result), Result::kWrongState);
  message.boot_nonce ^= 1U;
  EXPECT_EQ(static_cast<Result>(ask(message).result), Result::kWrongBoot);
  rig().send(wire::Disarm{7});
  rig().run(10);
  message.boot_nonce = rig().nonce;
  const wire::Acknowledge refused = ask(message);
  EXPECT_EQ(static_cast<Result>(refused.result), Result::kOutOfRange);
  EXPECT_EQ(refused.detail, 3);
}

TEST_P(Conformance, ANewSessionGoesOnWithSamplesAndCountsButNotWithCommands) {
  be_ready();
  rig().forced_mps = 0.2;
  rig().run(300);
  rig().forced_mps = 0.0;
  rig().run(20);
  const wire::Sample before = rig().last();
  ASSERT_GT(before.left_counts, 500);
  ASSERT_GT(before.last_command, 0);
  rig().streams = false;
  rig().samples.clear();
  flags_ = wire::kUseGyro | wire::kInvertLeftEncoder;
  connect_with_flags();
  const wire::Sample after = rig().last();
  EXPECT_LT(static_cast<std::uint16_t>(after.sequence - before.sequence), 12);
  EXPECT_EQ(after.left_counts, -before.left_counts);
  EXPECT_EQ(after.right_counts, before.right_counts);
  EXPECT_EQ(after.last_command, 0) << "the command belongs to another session";
  rig().sequence = 0;
  rig().send(rig().command());
  rig().run(15);
  EXPECT_EQ(rig().last().last_command, 1);
}

TEST_P(Conformance, SwappedTracksAreSwappedBeforeTheyAreInverted) {
  be_ready();
  rig().drive();
  rig().send(wire::Disarm{1});
  rig().streams = false;
  rig().run(20);
  const wire::Sample before = rig().last();
  const std::int32_t left = before.left_counts;
  rig().samples.clear();
  flags_ = wire::kSwapTracks | wire::kInvertLeftEncoder | wire::kInvertRightMotor;
  connect_with_flags();
  EXPECT_EQ(rig().last().left_counts, -before.right_counts);
  EXPECT_EQ(rig().last().right_counts, left);
  rig().streams = true;
  rig().speed_mps = 0.15f;
  rig().run(30);
  ASSERT_EQ(static_cast<Result>(rig().arm().result), Result::kAccepted);
  rig().run(60);
  ASSERT_GT(rig().last().right_duty, 0);
  // The motor of the right track is connected to the left channel.
  EXPECT_LT(rig().hardware().motor_duty().left, 0.0);
  EXPECT_GT(rig().hardware().motor_duty().right, 0.0);
}

TEST_P(Conformance, OnlyAHelloRequestAndParametersEndTheHellos) {
  const auto hellos_in_500_ms = [&] {
    rig().hellos.clear();
    rig().run(500);
    return rig().hellos.size();
  };
  rig().send(wire::SyncRequest{1});
  rig().send(wire::Stop{1});
  rig().send(wire::Disarm{2});
  rig().send(arm_with(1));
  rig().send(rig().command());
  EXPECT_GE(hellos_in_500_ms(), 2U);
  EXPECT_EQ(rig().acknowledges.size(), 3U);
  rig().send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
  EXPECT_EQ(hellos_in_500_ms(), 1U) << "only the answer to the request";
}

TEST_P(Conformance, FramesOfASecondHostDoNotKeepTheSession) {
  // The frames have another nonce, an unknown type or a wrong size.
  const auto send_invalid = [&] {
    wire::Command command = rig().command();
    command.boot_nonce ^= 1U;
    rig().send(command);
    wire::Parameters parameters = rig().parameters();
    parameters.boot_nonce ^= 1U;
    rig().send(parameters);
    rig().send(wire::Arm{rig().nonce ^ 1U, 1, 0});
    rig().send_bytes(frame(0x7E, {1, 2}));
    rig().send_bytes(frame(static_cast<std::uint8_t>(Type::kStop), {1, 2, 3}));
    rig().run(100);
  };
  rig().connect();
  rig().hellos.clear();
  for (int i = 0; i < 12; ++i) send_invalid();
  EXPECT_FALSE(rig().hellos.empty());

  // A refused frame with the nonce of this boot still comes from the host of the session.
  rig().connect();
  rig().hellos.clear();
  for (int i = 0; i < 12; ++i) {
    rig().send(wire::Arm{rig().nonce, 1, 0});
    rig().run(100);
  }
  EXPECT_TRUE(rig().hellos.empty());
}

TEST_P(Conformance, CorruptedCountsWhatTheFramingDropsAndNothingElse) {
  be_ready();
  const auto corrupted = [&] {
    rig().send(wire::SyncRequest{1});
    rig().run(10);
    return rig().sync_replies.back().corrupted;
  };
  const std::uint16_t before = corrupted();
  rig().send_bytes(frame(0x7E, {1, 2}));
  rig().send_bytes(frame(static_cast<std::uint8_t>(Type::kStop), {1, 2, 3}));
  rig().run(10);
  EXPECT_EQ(corrupted(), before) << "an unknown type or a wrong size was counted";
  std::vector<std::uint8_t> flipped = test::frame_of(wire::Disarm{1});
  flipped[2] ^= 0x40U;
  rig().send_bytes(flipped);
  rig().send_bytes({9, 1, 1, 0});                       // COBS
  rig().send_bytes({2, 1, 0});                          // too short
  rig().send_bytes(std::vector<std::uint8_t>(120, 1));  // oversize
  rig().send_bytes({0});
  rig().run(20);
  EXPECT_EQ(corrupted() - before, 4);
}

TEST_P(Conformance, ATrackThatRunsAgainstItsDutyIsReversedAfterTheDistanceOfTheDocument) {
  be_ready();
  rig().drive();
  const std::int32_t from = rig().last().left_counts;
  rig().forced_mps = -0.2;
  while (rig().moves()) rig().run(1);
  rig().run(10);
  EXPECT_NE(rig().last().faults &
                (wire::fault_bit(Fault::reversed_left) | wire::fault_bit(Fault::reversed_right)),
            0U);
  ASSERT_FALSE(rig().reports.empty());
  const double most_m = 0.02 + 0.2 * static_cast<double>(rig().parameters().max_track_mps);
  EXPECT_NEAR((from - rig().last().left_counts) / 11140.0, most_m, 0.012);
}

TEST_P(Conformance, ABatteryBelowTheCutOffIsFoundAtALowUsbVoltage) {
  rig().hardware().set_supply(4.5);
  rig().battery_v = 5.5;  // it would read 6.1 V, above the cut-off, at a supply of 5 V
  ASSERT_TRUE(rig().boot());
  be_ready();
  EXPECT_NEAR(rig().last().battery_mv, 5500, 55);
  const wire::Acknowledge refused = ask(arm_with(50));
  EXPECT_EQ(static_cast<Result>(refused.result), Result::kFaultPersists);
  EXPECT_EQ(refused.detail, wire::fault_bit(Fault::battery_low));
  rig().run(1100);
  EXPECT_EQ(rig().last().faults, wire::fault_bit(Fault::battery_low));
}

TEST_P(Conformance, AUsbVoltageThatFallsWhileDrivingDoesNotHideAnEmptyBattery) {
  rig().battery_v = 6.3;
  be_ready();
  rig().drive();
  rig().hardware().set_supply(4.5);
  rig().run(20'000);
  EXPECT_EQ(rig().state(), State::kRunning);
  EXPECT_NEAR(rig().last().battery_mv, 6300, 63);
  rig().battery_v = 5.8;
  EXPECT_GE(rig().ms_until_off(1200), 900);
  rig().run(20);
  EXPECT_EQ(rig().last().faults, wire::fault_bit(Fault::battery_low));
}

TEST_P(Conformance, EdgesThatWereMissedAreCountedInTheClockAnswer) {
  be_ready();
  const auto missed = [&] {
    rig().send(wire::SyncRequest{1});
    rig().run(10);
    return rig().sync_replies.back().missed_edges;
  };
  const std::uint16_t before = missed();
  // Both phases change at once, first on the left and then on the right encoder.
  for (const std::uint8_t a : std::to_array<std::uint8_t>({0, 2})) {
    rig().glitch(a);
    rig().run(5);
  }
  EXPECT_EQ(missed() - before, 2);
}

/// Transmission time of a byte that carries no information.
constexpr std::int64_t kSpareNs = 20'000;

// The expiry is a time of the board's clock, so it does not matter when the board reads the
// command.
TEST_P(Conformance, AnExpiredCommandSwitchesOffInTheTickBeforeItsExpiry) {
  be_ready();
  // Virtual time at which the board's clock was 0, too early by the shortest delay between the
  // arrival of a request and the time of receipt in its answer.
  std::int64_t zero_ns = INT64_MIN;
  for (std::size_t spare = 0; spare < 40; ++spare) {
    rig().sync_replies.clear();
    rig().send_bytes(std::vector<std::uint8_t>(spare, wire::kDelimiter));
    const std::vector<std::uint8_t> request = test::frame_of(wire::SyncRequest{9});
    const std::int64_t arrival_ns =
        rig().now_ns + static_cast<std::int64_t>(spare + request.size()) * kSpareNs;
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
