// Tests on both boards what firmware/PROTOCOL.md guarantees of a robot and depends on its hardware
// or its processor; tests/firmware has the rest.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "board_rig.h"
#include "wire/faults.h"

namespace tp100::sim {
namespace {

using wire::Fault;
using wire::State;

struct Values {
  std::uint64_t seed = 1;
  double clock_ppm = 0.0;
  std::uint32_t start_us = 0;
};

/// Boots each kind of board.
class Conformance : public ::testing::TestWithParam<const char*> {
 protected:
  Conformance() { use({}); }
  /// Another board, with these values.
  void use(const Values& values) {
    const auto [seed, ppm, start_us] = values;
    if (native())
      rig_ = std::make_unique<NativeRig>(
          NativeBoardSettings{.seed = seed, .clock_ppm = ppm, .start_us = start_us});
    else
      rig_ = std::make_unique<AvrRig>(
          AvrBoardSettings{.seed = seed, .clock_ppm = ppm, .start_us = start_us});
    EXPECT_TRUE(rig().boot());
  }
  static bool native() { return GetParam() == std::string("Native"); }
  BoardRig& rig() { return *rig_; }
  wire::SyncReply sync() {
    rig().send(wire::SyncRequest{1});
    rig().run(10);
    return rig().sync_replies.back();
  }

 private:
  std::unique_ptr<BoardRig> rig_;
};

TEST_P(Conformance, EachBootSaysHelloWithItsCauseAndANonceOfItsOwnAndTheMotorsOff) {
  std::set<std::uint32_t> nonces;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    use({.seed = seed});
    for (const PowerUp cause :
         {PowerUp::kPowerOn, PowerUp::kExternal, PowerUp::kBrownOut, PowerUp::kWatchdog}) {
      rig().drive();
      EXPECT_TRUE(rig().moves());
      rig().hardware().reset(cause, rig().now_ns);
      EXPECT_FALSE(rig().moves());
      rig().streams = false;
      ASSERT_TRUE(rig().boot(cause));
      const wire::Hello& hello = rig().hellos.back();
      EXPECT_EQ(hello.board, static_cast<std::uint8_t>(native() ? wire::BoardType::kNative
                                                                : wire::BoardType::kMega2560));
      EXPECT_EQ(hello.schema, wire::kSchemaHash);
      EXPECT_EQ(hello.reset_cause, static_cast<std::uint8_t>(cause));
      EXPECT_EQ(hello.state, static_cast<std::uint8_t>(State::kHello));
      nonces.insert(rig().nonce);
    }
  }
  EXPECT_EQ(nonces.size(), 12U);
  EXPECT_FALSE(nonces.contains(0));
}

TEST_P(Conformance, EachTrackRunsForwardsAndBackwards) {
  for (const float mps : {0.1f, -0.1f}) {
    rig().speed_mps = 0.0f;
    rig().drive(mps);
    const MotorDuty duty = rig().hardware().motor_duty();
    EXPECT_GT(duty.left * static_cast<double>(mps), 0.0) << mps;
    EXPECT_GT(duty.right * static_cast<double>(mps), 0.0) << mps;
  }
}

TEST_P(Conformance, ItsClockIsOffByItsPpmAndStartsWhereItIsTold) {
  constexpr std::uint32_t kStartUs = 0xFFFFFC00U - 1'024'000U;
  use({.clock_ppm = 500.0, .start_us = kStartUs});
  rig().be_ready();
  rig().run(3000);
  const std::uint32_t first_us = rig().samples.front().device_us;
  EXPECT_GT(first_us, kStartUs);
  EXPECT_LT(rig().last().device_us, first_us) << "it has not wrapped";
  const double device_us = rig().last().device_us - first_us;
  const double true_us =
      static_cast<double>(rig().sample_ns.back() - rig().sample_ns.front()) * 1e-3;
  EXPECT_NEAR((device_us / true_us - 1.0) * 1e6, 500.0, 100.0);
  // Timer and clock use the same resonator, so the samples do not drift against device time.
  EXPECT_NEAR(device_us / static_cast<double>(rig().samples.size() - 1), 5000.0, 0.6);
}

// Ten thousand edges a second on each of four channels, and with the commands about 47 of the 50
// bytes that fit into a millisecond.
TEST_P(Conformance, NoEdgeAndNoByteIsLostWithFullTraffic) {
  rig().be_ready();
  std::uint16_t asked = 0;
  std::vector<std::uint8_t> noise(35, 0x55);
  noise.back() = wire::kDelimiter;
  for (const double direction : {1.0, -1.0}) {
    const double mps = rig().forced_mps = direction * 20'000.0 / 11'140.0;
    rig().run(10);
    const std::size_t from = rig().samples.size();
    for (int ms = 0; ms < 500; ++ms) {
      rig().send(wire::SyncRequest{asked++});
      rig().send_bytes(noise);
      rig().run(1);
    }
    for (std::size_t i = from + 1; i < rig().samples.size(); ++i) {
      const wire::Sample &before = rig().samples[i - 1], &now = rig().samples[i];
      EXPECT_EQ(static_cast<std::uint16_t>(before.sequence + 1), now.sequence);
      const double counts = mps * (now.device_us - before.device_us) * 1e-6 * 11'140.0;
      EXPECT_NEAR(now.left_counts - before.left_counts, counts, 4.0);
      EXPECT_NEAR(now.right_counts - before.right_counts, counts, 4.0);
    }
  }
  rig().forced_mps = 0.0;
  rig().run(50);
  ASSERT_GT(rig().samples.size(), 200U);
  EXPECT_EQ(rig().last().left_counts, rig().left.counts());
  EXPECT_EQ(rig().last().right_counts, rig().right.counts());
  EXPECT_EQ(rig().overruns(), 0U);
  EXPECT_EQ(rig().bad_frames, 0);
  EXPECT_GT(rig().sync_replies.size(), 400U);
}

// Bytes that arrive at one instant, which is impossible on a wire.
TEST_P(Conformance, BytesThatFindTheReceiverFullAreLostAndCounted) {
  rig().run(10);
  const std::vector<TimedByte> at_once(200, {rig().now_ns + 500'000, 0x55});
  rig().hardware().advance(rig().now_ns + BoardRig::kStepNs, {}, at_once);
  EXPECT_EQ(rig().overruns(), 200U - (native() ? 63U : 3U));
}

TEST_P(Conformance, EveryByteTakesItsTimeOnTheWire) {
  rig().connect();
  rig().run(500);
  ASSERT_GT(rig().bytes.size(), 4000U);
  for (std::size_t i = 1; i < rig().bytes.size(); ++i)
    ASSERT_GE(rig().bytes[i].at_ns - rig().bytes[i - 1].at_ns, BoardRig::kByteNs);
}

TEST_P(Conformance, ADisarmedRobotWaits700MsForACommandAndASecondForAnything) {
  rig().run(1500);
  EXPECT_EQ(rig().hellos.back().faults, 0) << "there is no session yet";
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
    EXPECT_LE(left_us, 1100.0) << phase_us;
    rig().run(10);
    EXPECT_EQ(rig().last().faults, wire::fault_bit(Fault::command_timeout));
  }
}

std::string name_of(const ::testing::TestParamInfo<const char*>& test) { return test.param; }

INSTANTIATE_TEST_SUITE_P(Boards, Conformance, ::testing::Values("Native", "Avr"), name_of);

}  // namespace
}  // namespace tp100::sim
