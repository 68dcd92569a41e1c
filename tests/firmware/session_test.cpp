// Tests hello, parameters, acknowledgements, clock sync and silence.

#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "firmware/version.h"
#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::Fault;
using wire::Result;
using wire::State;
using wire::Type;

void expect_answer(const Rig& rig, Type request, std::uint32_t token, Result result,
                   std::uint16_t detail = 0) {
  ASSERT_FALSE(rig.acknowledges.empty());
  const wire::Acknowledge& last = rig.acknowledges.back();
  EXPECT_EQ(last.request, static_cast<std::uint8_t>(request));
  EXPECT_EQ(last.token, token);
  EXPECT_EQ(last.result, static_cast<std::uint8_t>(result));
  EXPECT_EQ(last.detail, detail);
}

// A good frame of a type with a payload that means nothing.
std::vector<std::uint8_t> frame_of_type(std::uint8_t type, std::size_t size) {
  return test::frame_of(type, std::vector<std::uint8_t>(size, 99));
}

TEST(Session, SaysHelloEvery200MsUntilAHostSpeaks) {
  Rig rig;
  rig.run(1010);
  ASSERT_EQ(rig.hellos.size(), 6U);
  EXPECT_EQ(rig.hellos[0].boot_nonce, 0xB007U);
  EXPECT_EQ(rig.hellos[0].protocol, wire::kProtocolVersion);
  EXPECT_EQ(rig.hellos[0].schema, wire::kSchemaHash);
  EXPECT_EQ(std::to_array(rig.hellos[0].firmware),
            (std::array<std::uint8_t, 3>{kVersionMajor, kVersionMinor, kVersionPatch}));
  EXPECT_TRUE(rig.samples.empty());
  EXPECT_EQ(rig.count_logs("boot, reset: power-on"), 1);
  EXPECT_EQ(rig.bad_frames, 0);
}

TEST(Session, ABootHasANonceAndEndsWhatWasCutOffBeforeItsFirstReport) {
  Rig rig(false);
  rig.hal.nonce = 0;
  rig.hal.cause = wire::ResetCause::kWatchdog;  // this fault is reported at once
  rig.boot();
  ASSERT_GT(rig.hal.sent.size(), 1U);
  EXPECT_EQ(rig.hal.sent[0], wire::kDelimiter);
  rig.run(2);
  EXPECT_NE(rig.hellos.at(0).boot_nonce, 0U);
}

TEST(Session, OnlyAHelloRequestEndsTheHellosAndItsAnswerIsOne) {
  Rig rig;
  rig.send(rig.command());
  rig.send(rig.arm_message());
  rig.send(wire::Stop{1});
  rig.send(wire::Disarm{2});
  rig.send(wire::SyncRequest{3});
  rig.run(10);
  rig.hellos.clear();
  rig.run(400);
  EXPECT_EQ(rig.hellos.size(), 2U);
  EXPECT_EQ(rig.acknowledges.size(), 3U);
  EXPECT_EQ(rig.sync_replies.size(), 1U);
  rig.hellos.clear();
  // A host of another version, with a longer request, learns the version of the robot.
  rig.send_bytes(frame_of_type(static_cast<std::uint8_t>(Type::kHelloRequest), 9));
  rig.run(500);
  ASSERT_EQ(rig.hellos.size(), 1U);
  EXPECT_EQ(rig.hellos[0].protocol, wire::kProtocolVersion);
  EXPECT_EQ(rig.hellos[0].state, static_cast<std::uint8_t>(State::kParameters));
}

TEST(Session, AHelloRequestSwitchesARunningRobotOff) {
  Rig rig;
  rig.drive();
  ASSERT_TRUE(rig.motors_on());
  rig.streams = false;
  rig.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
  rig.run(2);
  EXPECT_FALSE(rig.motors_on());
  EXPECT_EQ(rig.program.state(), State::kParameters);
  EXPECT_EQ(rig.count_logs("motors off"), 1);
}

TEST(Session, ParametersAreJudgedInTheOrderOfTheDocument) {
  Rig rig;
  wire::Parameters message = rig.parameters;
  const auto expect = [&](Result result, std::uint16_t detail) {
    rig.send(message);
    rig.run(3);
    expect_answer(rig, Type::kParameters, message.token, result, detail);
  };
  // The errors are corrected one after the other.
  message.boot_nonce ^= 1U;
  message.wheelbase_m = 0.0f;
  expect(Result::kWrongBoot, 0);
  message.boot_nonce ^= 1U;
  expect(Result::kOutOfRange, 3);
  EXPECT_EQ(rig.program.state(), State::kHello);
  message = rig.parameters;
  expect(Result::kAccepted, 0);
  EXPECT_EQ(rig.program.state(), State::kDisarmed) << "a hello request need not precede them";

  rig.drive(0.0f);
  ASSERT_EQ(rig.program.state(), State::kArmed);
  message.wheelbase_m = 0.0f;
  expect(Result::kWrongState, static_cast<std::uint16_t>(State::kArmed));
  message.boot_nonce ^= 1U;
  expect(Result::kWrongBoot, 0);
}

TEST(Session, ANewOneGoesOnWithSamplesAndCountsButNotWithCommands) {
  Rig rig;
  rig.hal.left_counts = 500;
  rig.hal.right_counts = 600;
  rig.drive();
  const wire::Sample before = rig.samples.back();
  ASSERT_GT(before.last_command, 0);
  rig.streams = false;
  rig.send(wire::Disarm{1});
  rig.send(rig.parameters);
  rig.run(10);
  EXPECT_GT(rig.samples.back().last_command, 0) << "a copy of the parameters opens no session";
  rig.sequence = 10;
  rig.parameters.flags |= wire::kInvertLeftEncoder;
  rig.connect();
  const wire::Sample after = rig.samples.back();
  EXPECT_LT(static_cast<std::uint16_t>(after.sequence - before.sequence), 10);
  EXPECT_EQ(after.left_counts, -500);
  EXPECT_EQ(after.right_counts, 600);
  EXPECT_EQ(after.last_command, 0) << "the command belongs to another session";
  EXPECT_EQ(after.left_duty, 0);
  rig.send(rig.command());
  rig.run(10);
  EXPECT_EQ(rig.samples.back().last_command, 11) << "a first command may have any sequence";
}

// Otherwise the tracks of a robot whose wiring is set differently would seem to have jumped.
TEST(Session, ANewOneForgetsWhereTheTracksWere) {
  const auto duties = [](std::int32_t counts, unsigned flag) {
    Rig rig;
    rig.hal.left_counts = rig.hal.right_counts = counts;
    rig.connect();
    rig.parameters.flags = static_cast<std::uint8_t>(rig.parameters.flags | flag);
    rig.connect();
    rig.streams = true;
    rig.speed_mps = 0.1f;
    rig.run(6);
    rig.arm();
    rig.run(7);
    EXPECT_TRUE(rig.motors_on());
    return rig.hal.duties;
  };
  for (const unsigned flag : {wire::kInvertLeftEncoder, wire::kInvertRightEncoder})
    EXPECT_EQ(duties(30'000, flag), duties(0, flag));
}

TEST(Session, SamplesComeAt200HzOnceParametersAreAccepted) {
  Rig rig;
  rig.be_ready();
  rig.samples.clear();
  rig.run(1000);
  ASSERT_GE(rig.samples.size(), 199U);
  ASSERT_LE(rig.samples.size(), 201U);
  for (std::size_t i = 1; i < rig.samples.size(); ++i) {
    EXPECT_EQ(rig.samples[i].sequence, static_cast<std::uint16_t>(rig.samples[i - 1].sequence + 1));
    EXPECT_NEAR(rig.samples[i].device_us - rig.samples[i - 1].device_us, 5000.0, 300.0);
    EXPECT_EQ(rig.samples[i].imu_age, 0);
  }
  EXPECT_EQ(rig.samples.back().accel[2], 8192);
  EXPECT_NEAR(rig.samples.back().battery_mv, 7900, 1);
  EXPECT_LE(rig.sequence - rig.samples.back().last_command, 1);
}

TEST(Session, AfterAHangSamplesGoOnAtTheirPeriod) {
  for (int ms = 4; ms < 90; ms += 3) {
    Rig rig;
    rig.connect();
    rig.hang(ms);
    rig.samples.clear();
    rig.run(200);
    // Missed samples are not made up for, but one that is only late does not delay the others.
    EXPECT_NEAR(static_cast<double>(rig.samples.size()), 40.0, 1.0) << ms;
  }
}

// It leaves after the bytes that still wait for the line, which take 20 us each at 500000 baud.
TEST(Session, SyncReplyCarriesTheTimesOfReceiptAndReply) {
  Rig rig;
  rig.connect();
  for (const std::uint8_t waiting : {std::uint8_t{0}, std::uint8_t{10}}) {
    rig.hal.waiting = waiting;
    rig.sync_replies.clear();
    const std::uint32_t before = rig.hal.now_us;
    rig.send(wire::SyncRequest{4711});
    rig.run(2);
    ASSERT_EQ(rig.sync_replies.size(), 1U);
    EXPECT_EQ(rig.sync_replies[0].id, 4711);
    EXPECT_NEAR(rig.sync_replies[0].received_us, before, 250.0);
    EXPECT_EQ(rig.sync_replies[0].sent_us - rig.sync_replies[0].received_us, waiting * 20U);
  }
}

TEST(Session, SyncReplyCountsWhateverCorruptedAFrameAndNothingElse) {
  Rig rig;
  rig.connect();
  const auto corrupted_by = [&](const std::vector<std::uint8_t>& bytes) {
    const auto before = rig.sync_replies.empty() ? 0 : int{rig.sync_replies.back().corrupted};
    rig.send_bytes(bytes);
    rig.send(wire::SyncRequest{4711});
    rig.run(6);
    return int{rig.sync_replies.back().corrupted} - before;
  };
  std::vector<std::uint8_t> oversize(wire::kMaxFrame + 5, 0x01);
  oversize.push_back(0x00);
  EXPECT_EQ(corrupted_by(oversize), 1);
  EXPECT_EQ(corrupted_by({0x09, 'x', 'y', 0x00}), 1) << "a code that points past the end";
  EXPECT_EQ(corrupted_by({0x02, 'x', 0x00}), 1) << "too short";
  EXPECT_EQ(corrupted_by({0x05, 'x', 'y', 'z', 'u', 0x00}), 1) << "wrong CRC";
  EXPECT_EQ(corrupted_by(frame_of_type(0x7E, 2)), 0) << "a type that is unknown";
  EXPECT_EQ(corrupted_by(frame_of_type(0x46, 3)), 0) << "a stop of another size";
  EXPECT_EQ(rig.program.faults(), 0);
}

// Frames of another host, with the nonce of another boot, do not keep the session.
TEST(Session, ASilentHostIsForgottenAfterASecond) {
  struct Case {
    const char* says;
    bool kept;
    std::function<void(Rig&)> say;
  };
  const auto of_another_boot = [](auto message) {
    message.boot_nonce ^= 1U;
    return message;
  };
  const std::vector<Case> cases = {
      {"nothing", false, [](Rig&) {}},
      {"hello request", true, [](Rig& rig) { rig.send(wire::HelloRequest{}); }},
      {"the parameters", true, [](Rig& rig) { rig.send(rig.parameters); }},
      {"a command", true, [](Rig& rig) { rig.send(rig.command()); }},
      {"arm", true, [](Rig& rig) { rig.send(rig.arm_message()); }},
      {"disarm", true, [](Rig& rig) { rig.send(wire::Disarm{1}); }},
      {"stop", true, [](Rig& rig) { rig.send(wire::Stop{1}); }},
      {"sync request", true, [](Rig& rig) { rig.send(wire::SyncRequest{1}); }},
      {"other parameters", false, [&](Rig& rig) { rig.send(of_another_boot(rig.parameters)); }},
      {"another command", false, [&](Rig& rig) { rig.send(of_another_boot(rig.command())); }},
      {"another arm", false, [&](Rig& rig) { rig.send(of_another_boot(rig.arm_message())); }},
      {"an unknown type", false, [](Rig& rig) { rig.send_bytes(frame_of_type(0x7E, 2)); }},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.says);
    Rig rig;
    rig.drive();
    rig.streams = false;
    rig.run(1);
    one.say(rig);
    rig.run(900);
    EXPECT_NE(rig.program.state(), State::kHello);
    one.say(rig);
    rig.run(90);
    rig.hellos.clear();
    rig.run(30);
    EXPECT_EQ(rig.program.state() == State::kHello, !one.kept);
    EXPECT_EQ(rig.hellos.size(), one.kept ? 0U : 1U);
    EXPECT_FALSE(rig.motors_on());
  }
}

TEST(Session, WiringFlagsTurnAndSwapBothWays) {
  Rig rig;
  rig.parameters.flags = wire::kSwapTracks | wire::kInvertLeftEncoder | wire::kInvertRightMotor;
  rig.hal.left_counts = 5;
  rig.hal.right_counts = 9;
  rig.drive();
  EXPECT_EQ(rig.samples.back().left_counts, -9);
  EXPECT_EQ(rig.samples.back().right_counts, 5);
  ASSERT_GT(rig.samples.back().left_duty, 0);
  ASSERT_GT(rig.samples.back().right_duty, 0);
  // The motor of the right track is inverted and connected to the left channel.
  EXPECT_LT(rig.hal.duties.left, 0);
  EXPECT_GT(rig.hal.duties.right, 0);
}

TEST(Session, ALoopTakesNoMoreThan32BytesAndLetsTheProcessorSleepOnce) {
  Rig rig;
  rig.send_bytes(std::vector<std::uint8_t>(5000, 0x55));
  rig.run(20);
  EXPECT_EQ(rig.hal.most_read_in_a_row, 32U);
  EXPECT_EQ(rig.hal.idles, 20 * 4);
}

}  // namespace
}  // namespace tp100::firmware
