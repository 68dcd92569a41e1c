// Tests hello, parameters, acknowledgements, clock sync and silence.

#include <gtest/gtest.h>

#include <limits>

#include "firmware/parameters.h"
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

TEST(Session, SaysHelloEvery200MsUntilAHostSpeaks) {
  Rig rig;
  rig.run(1010);
  EXPECT_EQ(rig.hellos.size(), 6U);
  EXPECT_EQ(rig.hellos[0].boot_nonce, 0xB007U);
  EXPECT_EQ(rig.hellos[0].protocol, wire::kProtocolVersion);
  EXPECT_EQ(rig.hellos[0].schema, wire::kSchemaHash);
  EXPECT_EQ(rig.hellos[0].firmware[0], kVersionMajor);
  EXPECT_EQ(rig.hellos[0].firmware[1], kVersionMinor);
  EXPECT_EQ(rig.hellos[0].firmware[2], kVersionPatch);
  EXPECT_TRUE(rig.samples.empty());
  EXPECT_EQ(rig.count_logs("boot"), 1);
  EXPECT_EQ(rig.bad_frames, 0);
}

TEST(Session, WhatWasCutOffBeforeABootEndsBeforeTheFirstReport) {
  Rig rig(false);
  rig.hal.cause = wire::ResetCause::kWatchdog;  // this fault is reported at once
  rig.boot();
  ASSERT_GT(rig.hal.sent.size(), 1U);
  EXPECT_EQ(rig.hal.sent[0], wire::kDelimiter);
}

TEST(Session, WhatElseWasSaidOnTheLineCorruptsNoHello) {
  Rig rig;
  for (int i = 0; i < 1010; ++i) {
    // A modem manager probes the line before each hello.
    if (i % 150 == 0) rig.overhear("AT\r");
    rig.run(1);
  }
  EXPECT_EQ(rig.hellos.size(), 6U);
}

TEST(Session, AHelloRequestIsAnsweredAndEndsTheStreamOfHellos) {
  Rig rig;
  rig.run(10);
  rig.hellos.clear();
  rig.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
  rig.run(500);
  ASSERT_EQ(rig.hellos.size(), 1U);
  EXPECT_EQ(rig.hellos[0].state, static_cast<std::uint8_t>(State::kParameters));
}

TEST(Session, AHostOfAnotherVersionGetsTheHelloToo) {
  Rig rig;
  rig.run(10);
  rig.hellos.clear();
  const std::uint8_t longer[9] = {99, 0, 1, 2, 3, 4, 5, 6, 7};
  std::uint8_t frame[wire::kMaxFrame];
  const std::size_t size =
      wire::encode_frame(static_cast<std::uint8_t>(Type::kHelloRequest), longer, 9, frame);
  rig.hal.received.insert(rig.hal.received.end(), frame, frame + size);
  rig.run(10);
  ASSERT_EQ(rig.hellos.size(), 1U);
  EXPECT_EQ(rig.hellos[0].protocol, wire::kProtocolVersion);
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

TEST(Session, ParametersMayFollowAHelloWithoutARequest) {
  Rig rig;
  rig.send(rig.parameters);
  rig.run(3);
  expect_answer(rig, Type::kParameters, 1, Result::kAccepted);
  EXPECT_EQ(rig.program.state(), State::kDisarmed);
}

TEST(Session, ParametersOfAnotherBootAreRefused) {
  Rig rig;
  rig.parameters.boot_nonce ^= 1U;
  rig.send(rig.parameters);
  rig.run(3);
  expect_answer(rig, Type::kParameters, 1, Result::kWrongBoot);
  EXPECT_EQ(rig.program.state(), State::kHello);
}

TEST(Session, EveryParameterOutsideItsRangeIsNamed) {
  struct Case {
    std::uint16_t field;
    std::function<void(wire::Parameters&)> corrupt;
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<Case> cases = {
      {2, [=](auto& p) { p.counts_per_metre = nan; }},
      {2, [=](auto& p) { p.counts_per_metre = 99.0f; }},
      {3, [=](auto& p) { p.wheelbase_m = 0.0f; }},
      {4, [=](auto& p) { p.wheelbase_tight_m = 2.1f; }},
      {5, [=](auto& p) { p.wheelbase_spin_m = 0.0f; }},
      {6, [=](auto& p) { p.turn_slip_share = nan; }},
      {7, [=](auto& p) { p.slip_left = 1.0f; }},
      {8, [=](auto& p) { p.slip_right = -0.6f; }},
      {9, [=](auto& p) { p.max_track_mps = inf; }},
      {10, [=](auto& p) { p.max_track_mps2 = 0.0f; }},
      {11, [=](auto& p) { p.feed_forward = -1.0f; }},
      {12, [=](auto& p) { p.dead_band = 0.95f; }},
      {13, [=](auto& p) { p.speed_kp = 101.0f; }},
      {14, [=](auto& p) { p.speed_ki = -inf; }},
      {15, [=](auto& p) { p.yaw_kp = 51.0f; }},
      {16, [=](auto& p) { p.max_yaw_radps = 0.0f; }},
      {17, [=](auto& p) { p.gyro_z_radps_per_lsb = 0.0f; }},
      {17, [=](auto& p) { p.gyro_z_radps_per_lsb = -0.1f; }},
      {19, [=](auto& p) { p.stall_duty = 1001; }},
      {20, [=](auto& p) { p.stall_ms = 49; }},
      {21, [=](auto& p) { p.command_life_ms = 201; }},
      {21, [=](auto& p) { p.command_life_ms = 19; }},
      {22, [=](auto& p) { p.yaw_window_ms = 201; }},
      {23, [=](auto& p) { p.flags = 0x40; }},
  };
  for (const Case& one : cases) {
    Rig rig;
    one.corrupt(rig.parameters);
    rig.send(rig.parameters);
    rig.run(3);
    expect_answer(rig, Type::kParameters, 1, Result::kOutOfRange, one.field);
    EXPECT_EQ(rig.program.state(), State::kHello);
  }
}

TEST(Session, BoundsOfParametersAreInRangeAsBinary32) {
  struct Range {
    float wire::Parameters::*field;
    float low, high;
  };
  using P = wire::Parameters;
  const Range ranges[] = {
      {&P::counts_per_metre, 100.0f, 1e6f}, {&P::wheelbase_m, 0.05f, 2.0f},
      {&P::wheelbase_tight_m, 0.05f, 2.0f}, {&P::wheelbase_spin_m, 0.05f, 2.0f},
      {&P::turn_slip_share, 0.0f, 1.0f},    {&P::slip_left, -0.5f, 0.9f},
      {&P::slip_right, -0.5f, 0.9f},        {&P::max_track_mps, 0.01f, 2.0f},
      {&P::max_track_mps2, 0.05f, 20.0f},   {&P::feed_forward, 0.0f, 100.0f},
      {&P::dead_band, 0.0f, 0.9f},          {&P::speed_kp, 0.0f, 100.0f},
      {&P::speed_ki, 0.0f, 1000.0f},        {&P::yaw_kp, 0.0f, 50.0f},
      {&P::max_yaw_radps, 0.05f, 10.0f},    {&P::gyro_z_radps_per_lsb, 1e-5f, 1e-2f}};
  const float inf = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < std::size(ranges); ++i) {
    const auto& [field, low, high] = ranges[i];
    const auto answer = [&, field = field](float value) {
      wire::Parameters parameters = test::good_parameters();
      parameters.*field = value;
      return int{bad_field(parameters)};
    };
    const int index = static_cast<int>(i) + 2;
    EXPECT_EQ(answer(low), 0) << index;
    EXPECT_EQ(answer(high), 0) << index;
    EXPECT_EQ(answer(std::nextafterf(low, -inf)), index);
    EXPECT_EQ(answer(std::nextafterf(high, inf)), index);
  }
}

TEST(Session, ParametersAreRefusedWhileArmed) {
  Rig rig;
  rig.connect();
  rig.streams = true;
  rig.run(20);
  rig.arm();
  ASSERT_EQ(rig.program.state(), State::kArmed);
  rig.parameters.token = 999;
  rig.send(rig.parameters);
  rig.run(2);
  expect_answer(rig, Type::kParameters, 999, Result::kWrongState,
                static_cast<std::uint16_t>(State::kArmed));
}

TEST(Session, SamplesComeAt200HzOnceParametersAreAccepted) {
  Rig rig;
  rig.connect();
  rig.streams = true;
  rig.run(100);
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

TEST(Session, ASampleWithoutRoomIsDroppedAndNumberedAcknowledgementsWait) {
  Rig rig;
  rig.connect();
  rig.acknowledges.clear();
  const auto before = rig.program.link_counts().unsent;
  rig.samples.clear();
  for (int i = 0; i < 400; ++i) {
    if (i == 10) rig.send(wire::Disarm{77});
    rig.hal.room = 5;
    rig.program.loop();
    rig.hal.now_us += 250;
    if (i % 4 == 3) rig.tick();
  }
  EXPECT_GT(rig.program.link_counts().unsent, before + 15);
  EXPECT_TRUE(rig.hal.sent.empty());
  rig.run(20);
  expect_answer(rig, Type::kDisarm, 77, Result::kAccepted);
  EXPECT_FALSE(rig.samples.empty());
  EXPECT_FALSE(rig.hal.overfilled);
}

TEST(Session, SyncReplyCarriesTheTimesOfReceiptAndReply) {
  Rig rig;
  rig.connect();
  const std::uint32_t before = rig.hal.now_us;
  rig.send(wire::SyncRequest{4711});
  rig.run(2);
  ASSERT_EQ(rig.sync_replies.size(), 1U);
  EXPECT_EQ(rig.sync_replies[0].id, 4711);
  EXPECT_GE(rig.sync_replies[0].received_us, before);
  EXPECT_LE(rig.sync_replies[0].received_us, rig.sync_replies[0].sent_us);
  EXPECT_LE(rig.sync_replies[0].sent_us, rig.hal.now_us);
}

TEST(Session, SyncReplyLeavesAfterWhatStillWaitsForTheLine) {
  Rig rig;
  rig.connect();
  const auto takes_us = [&](std::uint8_t waiting) {
    rig.hal.waiting = waiting;
    rig.sync_replies.clear();
    rig.send(wire::SyncRequest{4711});
    rig.run(2);
    return rig.sync_replies.empty() ? 0
                                    : rig.sync_replies[0].sent_us - rig.sync_replies[0].received_us;
  };
  const std::uint32_t at_once = takes_us(0);
  EXPECT_EQ(takes_us(10) - at_once, 10U * 20U) << "20 us a byte at 500000 baud";
}

TEST(Session, SyncReplyCarriesHowManyFramesCameCorrupted) {
  Rig rig;
  rig.connect();
  const auto asked = [&] {
    rig.sync_replies.clear();
    rig.send(wire::SyncRequest{4711});
    rig.run(2);
    return rig.sync_replies.empty() ? -1 : int{rig.sync_replies[0].corrupted};
  };
  const int before = asked();
  const std::uint8_t corrupted[] = {0x05, 'x', 'y', 'z', 'u', 0x00};
  rig.hal.received.insert(rig.hal.received.end(), std::begin(corrupted), std::end(corrupted));
  rig.run(2);
  EXPECT_EQ(asked(), before + 1);
}

TEST(Session, SyncReplyCountsWhateverCorruptedAFrame) {
  Rig rig;
  rig.connect();
  const auto asked = [&] {
    rig.sync_replies.clear();
    rig.send(wire::SyncRequest{4711});
    rig.run(2);
    return rig.sync_replies.empty() ? -1 : int{rig.sync_replies[0].corrupted};
  };
  const int before = asked();
  std::vector<std::uint8_t> oversize(wire::kMaxFrame + 5, 0x01);
  oversize.push_back(0x00);
  const std::vector<std::uint8_t> past_its_end{0x09, 'x', 'y', 0x00}, too_short{0x02, 'x', 0x00};
  int corrupted = 0;
  for (const auto& bytes : {oversize, past_its_end, too_short}) {
    rig.hal.received.insert(rig.hal.received.end(), bytes.begin(), bytes.end());
    rig.run(5);
    EXPECT_EQ(asked(), before + ++corrupted);
  }
}

TEST(Session, SyncReplyCarriesHowManyEncoderEdgesWereMissed) {
  Rig rig;
  rig.connect();
  rig.hal.missed = 65535;
  rig.send(wire::SyncRequest{4711});
  rig.run(2);
  ASSERT_EQ(rig.sync_replies.size(), 1U);
  EXPECT_EQ(rig.sync_replies[0].missed_edges, 65535);
}

TEST(Session, ASilentHostIsForgottenAfterASecond) {
  Rig rig;
  rig.drive();
  rig.streams = false;
  rig.run(900);
  EXPECT_NE(rig.program.state(), State::kHello);
  rig.hellos.clear();
  rig.run(310);
  EXPECT_EQ(rig.program.state(), State::kHello);
  EXPECT_GE(rig.hellos.size(), 1U);
  EXPECT_FALSE(rig.motors_on());
}

TEST(Session, AHostThatOnlyAsksToArmIsNotForgotten) {
  Rig rig;
  rig.connect();
  for (int i = 0; i < 15; ++i) {
    rig.send(rig.arm_message());
    rig.run(100);
  }
  EXPECT_NE(rig.program.state(), State::kHello);
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

TEST(Session, ALoopTakesNoMoreThan32Bytes) {
  Rig rig;
  rig.hal.received.insert(rig.hal.received.end(), 5000, std::uint8_t{0x55});
  rig.run(20);
  EXPECT_EQ(rig.hal.most_read_in_a_row, 32U);
}

TEST(Session, EveryLoopLetsTheProcessorSleepOnce) {
  Rig rig;
  rig.program.loop();
  rig.program.loop();
  EXPECT_EQ(rig.hal.idles, 2);
}

TEST(Session, TwoFirmwaresInOneProcessDoNotInfluenceEachOther) {
  Rig alone;
  Rig first;
  Rig second;
  second.hal.nonce = 0xC0DE;
  second.parameters.boot_nonce = 0xC0DE;
  alone.drive();
  first.connect();
  first.streams = true;
  first.run(10);
  second.send(wire::Stop{1});
  second.run(50);
  first.run(10);
  first.arm();
  second.run(50);
  first.speed_mps = 0.1f;
  first.run(20);
  EXPECT_EQ(first.hal.duties, alone.hal.duties);
  EXPECT_EQ(first.samples.size(), alone.samples.size());
  EXPECT_EQ(first.samples.back().device_us, alone.samples.back().device_us);
  EXPECT_FALSE(second.motors_on());
  EXPECT_TRUE(second.has(Fault::stop_requested));
  EXPECT_FALSE(first.has(Fault::stop_requested));
}

}  // namespace
}  // namespace tp100::firmware
