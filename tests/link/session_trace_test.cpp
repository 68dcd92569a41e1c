// Golden traces of sessions with a robot that restarts, is silent, refuses and answers late.
#include "session_trace.h"

#include <gtest/gtest.h>

namespace tp100::link {
namespace {

wire::Hello hello_of(const ScriptedRobot& robot) {
  return {robot.protocol, {3, 1, 4}, robot.schema, robot.board, robot.boot_nonce, 0, 0, 0x15};
}

wire::Log text(std::uint32_t device_us, const std::string& words) {
  wire::Log log{};
  log.device_us = device_us;
  std::copy_n(words.begin(), std::min(words.size(), wire::Log::kTextSize), log.text);
  return log;
}

TEST(SessionTrace, EachAnswerOfAHandshakeIsMissingLateOrWrong) {
  SessionTrace trace("handshakes", 150);
  ScriptedRobot& robot = trace.rig.robot;
  robot.silent = true;
  trace.run(30);
  trace.rig.session.open(trace.rig.now);
  trace.run(5400);
  trace.receive_bytes({'U', 'U', 0, 7});
  robot.silent = false;
  robot.answers_parameters = false;
  trace.run(5300);
  robot.answers_parameters = true;
  robot.answers_sync = false;
  trace.run(5600);
  robot.answers_sync = true;
  trace.delay_ms = 230;
  trace.run(5200);
  trace.delay_ms = 180;
  trace.run(2500);
  trace.delay_ms = 0;
  trace.run(1700);
  for (const auto result : {wire::Result::kWrongBoot, wire::Result::kStaleToken,
                            wire::Result::kWrongState, wire::Result::kOutOfRange}) {
    robot.parameters_result = result;
    robot.state = wire::State::kHello;
    trace.run(350);
  }
  // A board that refused its parameters is asked again after a restart only.
  trace.run(300);
  robot.parameters_result = wire::Result::kAccepted;
  robot.reboot(trace.rig.now);
  trace.run(700);
  EXPECT_EQ(trace.difference(), "");
}

TEST(SessionTrace, RestartsSilencesAndPortsThatGo) {
  SessionTrace trace("restarts", 60);
  SessionRig& rig = trace.rig;
  rig.session.open(rig.now);
  trace.run(1400);
  rig.robot.reboot(rig.now);
  trace.run(420);
  rig.robot.state = wire::State::kHello;
  trace.run(430);
  rig.robot.silent = true;
  trace.run(620);
  rig.robot.silent = false;
  trace.run(900);
  rig.robot.samples = false;
  trace.run(700);
  rig.robot.samples = true;
  trace.run(600);
  rig.session.close(rig.now);
  trace.run(30);
  rig.session.open(rig.now);
  trace.run(300);
  trace.receive_bytes({9, 'c', 'u', 't'});
  rig.session.open(rig.now);
  trace.run(350);
  // It joins a robot that is up, with another protocol of bytes before the first frame.
  trace.receive_bytes({9, 'c', 'u', 't'});
  rig.session.close(rig.now);
  trace.receive_bytes(frame_of(rig.robot.sample(rig.now)));
  trace.run(40);
  rig.session.open(rig.now);
  trace.robot_hears = false;
  trace.run(500);
  trace.robot_hears = true;
  trace.run(400);
  trace.port_takes = false;
  trace.run(260);
  rig.session.drop_output();
  trace.state();
  trace.port_takes = true;
  trace.run(200);
  EXPECT_EQ(trace.difference(), "");
}

TEST(SessionTrace, HellosOfOtherBoardsAndVersions) {
  SessionTrace trace("hellos", 40);
  SessionRig& rig = trace.rig;
  rig.session.open(rig.now);
  trace.run(300);
  rig.robot.silent = true;
  for (int board = 0; board <= 6; ++board) {
    wire::Hello hello = hello_of(rig.robot);
    hello.board = static_cast<std::uint8_t>(board);
    hello.boot_nonce = 0x10000U + static_cast<std::uint32_t>(board);
    trace.receive(hello);
    trace.run(9);
    trace.receive(hello);
    trace.run(3);
  }
  for (const int state : {5, 6, 6, 9, 0}) {
    wire::Hello hello = hello_of(rig.robot);
    hello.boot_nonce = 0x23456;
    hello.state = static_cast<std::uint8_t>(state);
    trace.receive(hello);
    trace.run(8);
  }
  for (const std::uint32_t nonce : {0U, 0U, 77U, 77U}) {
    wire::Hello hello = hello_of(rig.robot);
    hello.boot_nonce = nonce;
    hello.state = nonce == 77U ? 8 : 0;
    trace.receive(hello);
    trace.run(5);
  }
  for (const int other : {1, 1, 2, 3, 0, 3, 1}) {
    wire::Hello hello = hello_of(rig.robot);
    if ((other & 1) != 0) hello.protocol = 0x0203;
    if ((other & 2) != 0) hello.schema ^= 0x00010001U;
    trace.receive(hello);
    trace.run(7);
    trace.state();
  }
  for (const std::size_t size : {1U, 8U, 9U, 10U, 17U, 19U, 30U}) {
    std::vector<std::uint8_t> payload(wire::Hello::kSize);
    wire::write_payload(hello_of(rig.robot), payload.data());
    payload.resize(size);
    trace.receive_frame(wire::Type::kHello, payload);
    trace.state();
    payload.at(0) ^= 0x40U;
    trace.receive_frame(wire::Type::kHello, payload);
    trace.run(3);
    trace.state();
  }
  for (int type = 0; type < 0x49; ++type) {
    if (type == 1) continue;
    trace.receive_frame(static_cast<wire::Type>(type),
                        std::vector<std::uint8_t>(static_cast<std::size_t>(type % 3 + 1)));
    if (type % 8 == 3 || type < 8) trace.state();
  }
  rig.robot.silent = false;
  rig.robot.reboot(rig.now);
  trace.run(500);
  EXPECT_EQ(trace.difference(), "");
}

TEST(SessionTrace, OtherParametersInEveryState) {
  SessionSettings settings = SessionRig::settings();
  settings.timeout_ns = 330 * kNsPerMs;
  settings.first_frame_timeout_ns = 700 * kNsPerMs;
  settings.clock_answer_ns = 130 * kNsPerMs;
  settings.parameters.wheelbase_m = 0.31F;
  settings.parameters.max_track_mps = 0.1F;
  settings.parameters.counts_per_metre = 5000.0F;
  SessionTrace trace("parameters", 45, settings);
  SessionRig& rig = trace.rig;
  wire::Parameters parameters = settings.parameters;
  const auto use = [&] {
    parameters.wheelbase_m += 0.01F;
    parameters.counts_per_metre += 1500.0F;
    rig.session.use(parameters, rig.now);
  };
  rig.robot.metres_per_s = 1.0;
  use();
  rig.session.open(rig.now);
  use();
  trace.run(15);
  use();
  trace.run(400);
  use();
  trace.run(3);
  use();
  trace.run(500);
  rig.robot.answers_parameters = false;
  use();
  trace.run(800);
  use();
  trace.run(40);
  rig.robot.answers_parameters = true;
  rig.robot.parameters_result = wire::Result::kOutOfRange;
  trace.run(320);
  use();
  trace.run(20);
  rig.robot.parameters_result = wire::Result::kAccepted;
  use();
  trace.run(300);
  rig.robot.schema ^= 2U;
  rig.robot.reboot(rig.now);
  trace.run(20);
  use();
  trace.run(300);
  rig.robot.schema ^= 2U;
  trace.run(500);
  rig.robot.silent = true;
  trace.run(1500);
  EXPECT_EQ(trace.difference(), "");
}

TEST(SessionTrace, SessionsOfEveryLengthAndTheWaitsAfterThem) {
  SessionTrace trace("waits", 400);
  SessionRig& rig = trace.rig;
  rig.session.open(rig.now);
  std::size_t counted = rig.samples.size();
  const auto lasts = [&](std::uint64_t samples) {
    // Samples before the clock was known count too.
    const auto taken = [&] { return rig.session.counters().frames_in; };
    while (rig.session.state() != SessionState::kReady &&
           rig.session.state() != SessionState::kSyncing)
      trace.run(1);
    const std::uint64_t before = taken();
    while (taken() - before < samples) trace.run(1);
    rig.robot.silent = true;
    trace.run(3);
    rig.robot.silent = false;
    rig.robot.state = wire::State::kHello;
    trace.run(210);
    counted = rig.samples.size();
  };
  for (const std::uint64_t samples : {60U, 70U, 80U, 230U, 90U, 70U, 60U, 75U, 60U, 70U, 60U, 80U})
    lasts(samples);
  for (std::uint64_t samples = 205; samples < 225; ++samples) lasts(samples);
  EXPECT_GT(counted, 0u);
  EXPECT_EQ(trace.difference(), "");
}

TEST(SessionTrace, WhatTheRobotReports) {
  SessionTrace trace("reports", 10);
  SessionRig& rig = trace.rig;
  rig.session.open(rig.now);
  trace.run(260);
  for (int i = 0; i < 12; ++i) {
    const auto fault = static_cast<std::uint8_t>(i);
    trace.receive(wire::FaultReport{1, fault, 3, (i - 5) * 70'001});
    trace.receive(text(0xFFFF'0000U + static_cast<std::uint32_t>(i) * 40'009U,
                       std::string(static_cast<std::size_t>(i) * 4, static_cast<char>('!' + i)) +
                           "\x1f ~\x7f\x80\xff" + "tail"));
    trace.run(1);
  }
  std::vector<std::uint8_t> flood;
  for (int i = 0; i < 40; ++i) {
    const auto frame = frame_of(text(7, "more"));
    flood.insert(flood.end(), frame.begin(), frame.end());
  }
  trace.receive_bytes(flood);
  rig.robot.corrupted = 65'500;
  rig.robot.missed_edges = 65'400;
  for (int i = 0; i < 20; ++i) {
    trace.run(110);
    rig.robot.corrupted = static_cast<std::uint16_t>(rig.robot.corrupted + 7 * i);
    rig.robot.missed_edges = static_cast<std::uint16_t>(rig.robot.missed_edges + 13 * i);
  }
  rig.robot.say_hello();
  trace.run(100);
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::link
