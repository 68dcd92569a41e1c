// Tests hello, parameters, acknowledgements, clock sync and silence.

#include <gtest/gtest.h>

#include <limits>

#include "bench.h"
#include "firmware/parameters.h"
#include "firmware/version.h"

namespace tp100::firmware {
namespace {

using wire::Fault;
using wire::Result;
using wire::State;
using wire::Type;

void expect_answer(const Bench& bench, Type request, std::uint32_t token, Result result,
                   std::uint16_t detail = 0) {
  ASSERT_FALSE(bench.acknowledges.empty());
  const wire::Acknowledge& last = bench.acknowledges.back();
  EXPECT_EQ(last.request, static_cast<std::uint8_t>(request));
  EXPECT_EQ(last.token, token);
  EXPECT_EQ(last.result, static_cast<std::uint8_t>(result));
  EXPECT_EQ(last.detail, detail);
}

TEST(Session, SaysHelloEvery200MsUntilAHostSpeaks) {
  Bench bench;
  bench.run(1010);
  EXPECT_EQ(bench.hellos.size(), 6U);
  EXPECT_EQ(bench.hellos[0].boot_nonce, 0xB007U);
  EXPECT_EQ(bench.hellos[0].protocol, wire::kProtocolVersion);
  EXPECT_EQ(bench.hellos[0].schema, wire::kSchemaHash);
  EXPECT_EQ(bench.hellos[0].firmware[0], kVersionMajor);
  EXPECT_EQ(bench.hellos[0].firmware[1], kVersionMinor);
  EXPECT_EQ(bench.hellos[0].firmware[2], kVersionPatch);
  EXPECT_TRUE(bench.samples.empty());
  EXPECT_EQ(bench.count_logs("boot"), 1);
  EXPECT_EQ(bench.bad_frames, 0);
}

TEST(Session, WhatWasCutOffBeforeABootEndsBeforeTheFirstReport) {
  Bench bench(false);
  bench.hal.cause = wire::ResetCause::kWatchdog;  // this fault is reported at once
  bench.boot();
  ASSERT_GT(bench.hal.sent.size(), 1U);
  EXPECT_EQ(bench.hal.sent[0], wire::kDelimiter);
}

TEST(Session, WhatElseWasSaidOnTheLineCorruptsNoHello) {
  Bench bench;
  for (int i = 0; i < 1010; ++i) {
    // A modem manager probes the line before each hello.
    if (i % 150 == 0) bench.overhear("AT\r");
    bench.run(1);
  }
  EXPECT_EQ(bench.hellos.size(), 6U);
}

TEST(Session, AHelloRequestIsAnsweredAndEndsTheStreamOfHellos) {
  Bench bench;
  bench.run(10);
  bench.hellos.clear();
  bench.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
  bench.run(500);
  ASSERT_EQ(bench.hellos.size(), 1U);
  EXPECT_EQ(bench.hellos[0].state, static_cast<std::uint8_t>(State::kParameters));
}

TEST(Session, AHostOfAnotherVersionGetsTheHelloToo) {
  Bench bench;
  bench.run(10);
  bench.hellos.clear();
  const std::uint8_t longer[9] = {99, 0, 1, 2, 3, 4, 5, 6, 7};
  std::uint8_t frame[wire::kMaxFrame];
  const std::size_t size =
      wire::encode_frame(static_cast<std::uint8_t>(Type::kHelloRequest), longer, 9, frame);
  bench.hal.received.insert(bench.hal.received.end(), frame, frame + size);
  bench.run(10);
  ASSERT_EQ(bench.hellos.size(), 1U);
  EXPECT_EQ(bench.hellos[0].protocol, wire::kProtocolVersion);
}

TEST(Session, AHelloRequestSwitchesARunningRobotOff) {
  Bench bench;
  bench.drive();
  ASSERT_TRUE(bench.motors_on());
  bench.streams = false;
  bench.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash});
  bench.run(2);
  EXPECT_FALSE(bench.motors_on());
  EXPECT_EQ(bench.program.state(), State::kParameters);
  EXPECT_EQ(bench.count_logs("motors off"), 1);
}

TEST(Session, ParametersMayFollowAHelloWithoutARequest) {
  Bench bench;
  bench.send(bench.parameters);
  bench.run(3);
  expect_answer(bench, Type::kParameters, 1, Result::kAccepted);
  EXPECT_EQ(bench.program.state(), State::kDisarmed);
}

TEST(Session, ParametersOfAnotherBootAreRefused) {
  Bench bench;
  bench.parameters.boot_nonce ^= 1U;
  bench.send(bench.parameters);
  bench.run(3);
  expect_answer(bench, Type::kParameters, 1, Result::kWrongBoot);
  EXPECT_EQ(bench.program.state(), State::kHello);
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
    Bench bench;
    one.corrupt(bench.parameters);
    bench.send(bench.parameters);
    bench.run(3);
    expect_answer(bench, Type::kParameters, 1, Result::kOutOfRange, one.field);
    EXPECT_EQ(bench.program.state(), State::kHello);
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
      wire::Parameters parameters = Bench::good_parameters();
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
  Bench bench;
  bench.connect();
  bench.streams = true;
  bench.run(20);
  bench.arm();
  ASSERT_EQ(bench.program.state(), State::kArmed);
  bench.parameters.token = 999;
  bench.send(bench.parameters);
  bench.run(2);
  expect_answer(bench, Type::kParameters, 999, Result::kWrongState,
                static_cast<std::uint16_t>(State::kArmed));
}

TEST(Session, SamplesComeAt200HzOnceParametersAreAccepted) {
  Bench bench;
  bench.connect();
  bench.streams = true;
  bench.run(100);
  bench.samples.clear();
  bench.run(1000);
  ASSERT_GE(bench.samples.size(), 199U);
  ASSERT_LE(bench.samples.size(), 201U);
  for (std::size_t i = 1; i < bench.samples.size(); ++i) {
    EXPECT_EQ(bench.samples[i].sequence,
              static_cast<std::uint16_t>(bench.samples[i - 1].sequence + 1));
    EXPECT_NEAR(bench.samples[i].device_us - bench.samples[i - 1].device_us, 5000.0, 300.0);
    EXPECT_EQ(bench.samples[i].imu_age, 0);
  }
  EXPECT_EQ(bench.samples.back().accel[2], 8192);
  EXPECT_NEAR(bench.samples.back().battery_mv, 7900, 1);
  EXPECT_LE(bench.sequence - bench.samples.back().last_command, 1);
}

TEST(Session, ASampleWithoutRoomIsDroppedAndNumberedAcknowledgementsWait) {
  Bench bench;
  bench.connect();
  bench.acknowledges.clear();
  const auto before = bench.program.link_counts().unsent;
  bench.samples.clear();
  for (int i = 0; i < 400; ++i) {
    if (i == 10) bench.send(wire::Disarm{77});
    bench.hal.room = 5;
    bench.program.loop();
    bench.hal.now_us += 250;
    if (i % 4 == 3) bench.tick();
  }
  EXPECT_GT(bench.program.link_counts().unsent, before + 15);
  EXPECT_TRUE(bench.hal.sent.empty());
  bench.run(20);
  expect_answer(bench, Type::kDisarm, 77, Result::kAccepted);
  EXPECT_FALSE(bench.samples.empty());
  EXPECT_FALSE(bench.hal.overfilled);
}

TEST(Session, SyncReplyCarriesTheTimesOfReceiptAndReply) {
  Bench bench;
  bench.connect();
  const std::uint32_t before = bench.hal.now_us;
  bench.send(wire::SyncRequest{4711});
  bench.run(2);
  ASSERT_EQ(bench.sync_replies.size(), 1U);
  EXPECT_EQ(bench.sync_replies[0].id, 4711);
  EXPECT_GE(bench.sync_replies[0].received_us, before);
  EXPECT_LE(bench.sync_replies[0].received_us, bench.sync_replies[0].sent_us);
  EXPECT_LE(bench.sync_replies[0].sent_us, bench.hal.now_us);
}

TEST(Session, SyncReplyLeavesAfterWhatStillWaitsForTheLine) {
  Bench bench;
  bench.connect();
  const auto takes_us = [&](std::uint8_t waiting) {
    bench.hal.waiting = waiting;
    bench.sync_replies.clear();
    bench.send(wire::SyncRequest{4711});
    bench.run(2);
    return bench.sync_replies.empty()
               ? 0
               : bench.sync_replies[0].sent_us - bench.sync_replies[0].received_us;
  };
  const std::uint32_t at_once = takes_us(0);
  EXPECT_EQ(takes_us(10) - at_once, 10U * 20U) << "20 us a byte at 500000 baud";
}

TEST(Session, SyncReplyCarriesHowManyFramesCameCorrupted) {
  Bench bench;
  bench.connect();
  const auto asked = [&] {
    bench.sync_replies.clear();
    bench.send(wire::SyncRequest{4711});
    bench.run(2);
    return bench.sync_replies.empty() ? -1 : int{bench.sync_replies[0].corrupted};
  };
  const int before = asked();
  const std::uint8_t corrupted[] = {0x05, 'x', 'y', 'z', 'u', 0x00};
  bench.hal.received.insert(bench.hal.received.end(), std::begin(corrupted), std::end(corrupted));
  bench.run(2);
  EXPECT_EQ(asked(), before + 1);
}

TEST(Session, SyncReplyCountsWhateverCorruptedAFrame) {
  Bench bench;
  bench.connect();
  const auto asked = [&] {
    bench.sync_replies.clear();
    bench.send(wire::SyncRequest{4711});
    bench.run(2);
    return bench.sync_replies.empty() ? -1 : int{bench.sync_replies[0].corrupted};
  };
  const int before = asked();
  std::vector<std::uint8_t> oversize(wire::kMaxFrame + 5, 0x01);
  oversize.push_back(0x00);
  const std::vector<std::uint8_t> past_its_end{0x09, 'x', 'y', 0x00}, too_short{0x02, 'x', 0x00};
  int corrupted = 0;
  for (const auto& bytes : {oversize, past_its_end, too_short}) {
    bench.hal.received.insert(bench.hal.received.end(), bytes.begin(), bytes.end());
    bench.run(5);
    EXPECT_EQ(asked(), before + ++corrupted);
  }
}

TEST(Session, SyncReplyCarriesHowManyEncoderEdgesWereMissed) {
  Bench bench;
  bench.connect();
  bench.hal.missed = 65535;
  bench.send(wire::SyncRequest{4711});
  bench.run(2);
  ASSERT_EQ(bench.sync_replies.size(), 1U);
  EXPECT_EQ(bench.sync_replies[0].missed_edges, 65535);
}

TEST(Session, ASilentHostIsForgottenAfterASecond) {
  Bench bench;
  bench.drive();
  bench.streams = false;
  bench.run(900);
  EXPECT_NE(bench.program.state(), State::kHello);
  bench.hellos.clear();
  bench.run(310);
  EXPECT_EQ(bench.program.state(), State::kHello);
  EXPECT_GE(bench.hellos.size(), 1U);
  EXPECT_FALSE(bench.motors_on());
}

TEST(Session, AHostThatOnlyAsksToArmIsNotForgotten) {
  Bench bench;
  bench.connect();
  for (int i = 0; i < 15; ++i) {
    bench.send(bench.arm_message());
    bench.run(100);
  }
  EXPECT_NE(bench.program.state(), State::kHello);
}

TEST(Session, WiringFlagsTurnAndSwapBothWays) {
  Bench bench;
  bench.parameters.flags = wire::kSwapTracks | wire::kInvertLeftEncoder | wire::kInvertRightMotor;
  bench.hal.left_counts = 5;
  bench.hal.right_counts = 9;
  bench.drive();
  EXPECT_EQ(bench.samples.back().left_counts, -9);
  EXPECT_EQ(bench.samples.back().right_counts, 5);
  ASSERT_GT(bench.samples.back().left_duty, 0);
  ASSERT_GT(bench.samples.back().right_duty, 0);
  // The motor of the right track is inverted and connected to the left channel.
  EXPECT_LT(bench.hal.duties.left, 0);
  EXPECT_GT(bench.hal.duties.right, 0);
}

TEST(Session, ALoopTakesNoMoreThan32Bytes) {
  Bench bench;
  bench.hal.received.insert(bench.hal.received.end(), 5000, std::uint8_t{0x55});
  bench.run(20);
  EXPECT_EQ(bench.hal.most_read_in_a_row, 32U);
}

TEST(Session, TwoFirmwaresInOneProcessDoNotInfluenceEachOther) {
  Bench alone;
  Bench first;
  Bench second;
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
