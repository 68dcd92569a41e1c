// Golden traces of the requests and commands of a session, and of the samples that it takes.
#include <gtest/gtest.h>

#include "session_trace.h"

namespace tp100::link {
namespace {

wire::Acknowledge answer(wire::Type type, std::uint32_t token, wire::Result result,
                         std::uint16_t detail = 0) {
  return {static_cast<std::uint8_t>(type), token, static_cast<std::uint8_t>(result), detail};
}

TEST(RequestTrace, RepeatedOverdueReplacedAndAnsweredLate) {
  SessionTrace trace("requests", 30);
  SessionRig& rig = trace.rig;
  ScriptedRobot& robot = rig.robot;
  robot.clock_ppm = 300.0;
  robot.device_offset_us = 0xFFF0'0000U;
  for (const auto early : {RobotRequest::kNone, RobotRequest::kArm, RobotRequest::kDisarm})
    trace.request(early);
  rig.session.open(rig.now);
  trace.run(3);
  trace.request(RobotRequest::kArm);
  trace.request(RobotRequest::kDisarm);
  trace.run(300);
  const RobotRequest all[] = {RobotRequest::kArm, RobotRequest::kDisarm, RobotRequest::kStop};
  for (const RobotRequest first : all) {
    trace.request(first);
    trace.run(40);
  }
  robot.answers_requests = false;
  for (const RobotRequest first : all) {
    for (const RobotRequest second : all) {
      trace.request(first);
      trace.run(17);
      trace.request(second);
      trace.run(first == second ? 230 : 44);
    }
  }
  trace.run(700);
  robot.answers_requests = true;
  trace.run(240);
  robot.answers_requests = false;
  // An arm that was given up is accepted late, once with a disarm under way.
  for (const bool disarms : {false, true}) {
    trace.request(RobotRequest::kArm);
    trace.run(220);
    const std::uint32_t token = robot.received.arms.back().token;
    if (disarms) trace.request(RobotRequest::kDisarm);
    trace.receive(answer(wire::Type::kArm, token, wire::Result::kWrongState));
    trace.receive(answer(wire::Type::kArm, token + 1, wire::Result::kAccepted));
    trace.receive(answer(wire::Type::kArm, token, wire::Result::kAccepted));
    trace.run(35);
    trace.receive(answer(wire::Type::kArm, token, wire::Result::kAccepted));
    trace.run(210);
  }
  trace.receive(answer(wire::Type::kArm, 0, wire::Result::kAccepted));
  for (int result = 0; result <= 6; ++result) {
    for (const RobotRequest request : all) {
      trace.request(request);
      trace.run(2);
      const auto& got = robot.received;
      const bool arm = request == RobotRequest::kArm, stop = request == RobotRequest::kStop;
      const wire::Type type = arm    ? wire::Type::kArm
                              : stop ? wire::Type::kStop
                                     : wire::Type::kDisarm;
      const std::uint32_t token = arm    ? got.arms.back().token
                                  : stop ? got.stops.back().token
                                         : got.disarms.back().token;
      const wire::Type other = arm ? wire::Type::kDisarm : wire::Type::kArm;
      trace.receive(answer(other, token, wire::Result::kAccepted, 3));
      trace.receive(answer(type, token - 1, wire::Result::kAccepted, 4));
      trace.receive(answer(wire::Type::kParameters, token, wire::Result::kAccepted, 5));
      trace.receive(answer(wire::Type::kSample, token, wire::Result::kAccepted, 6));
      trace.receive(answer(type, token, wire::Result(result), static_cast<std::uint16_t>(result)));
      trace.receive(answer(type, token, wire::Result::kAccepted, 7));
      trace.run(3);
    }
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(RequestTrace, AcrossTheEndOfASession) {
  SessionTrace trace("requests_across", 50);
  SessionRig& rig = trace.rig;
  rig.session.open(rig.now);
  trace.run(260);
  for (const RobotRequest request :
       {RobotRequest::kArm, RobotRequest::kDisarm, RobotRequest::kStop}) {
    for (int end = 0; end < 4; ++end) {
      rig.robot.answers_requests = false;
      trace.request(request);
      trace.run(45);
      if (end == 0) rig.robot.reboot(rig.now);
      if (end == 1) rig.robot.state = wire::State::kHello;
      if (end == 2) rig.session.close(rig.now);
      if (end == 3) rig.session.use(SessionRig::settings().parameters, rig.now);
      trace.run(end == 2 ? 60 : 2);
      if (end == 2) rig.session.open(rig.now);
      trace.run(190);
      rig.robot.answers_requests = true;
      trace.run(500);
    }
  }
  rig.robot.silent = true;
  rig.robot.answers_requests = false;
  trace.run(450);
  trace.request(RobotRequest::kStop);
  trace.run(400);
  rig.robot.silent = false;
  rig.robot.answers_requests = true;
  trace.run(400);
  EXPECT_EQ(trace.difference(), "");
}

TEST(RequestTrace, CommandsOfOffCentreValues) {
  SessionSettings settings = SessionRig::settings();
  settings.baud = 115'200;
  SessionTrace trace("commands", 20, settings);
  SessionRig& rig = trace.rig;
  rig.robot.boot_nonce = 0x1234'5678U;
  rig.robot.received.commands.push_back({});
  rig.robot.received.commands.back().sequence = 65'530;
  rig.commands = true;
  rig.session.send(Command{}, rig.now);
  rig.session.open(rig.now);
  trace.run(150);
  for (int i = 0; i < 60; ++i) {
    rig.command.answers = static_cast<std::uint16_t>(65'500 + i);
    rig.command.pose = {0.1 * i - 2.0, 1.5 - 0.2 * i, 0.3 * i - 4.0};
    rig.command.desired_yaw_rad = 2.0 - 0.25 * i;
    rig.command.yaw_rate_radps = 0.04 * i - 1.1;
    rig.command.speed_mps = 0.31 - 0.015 * i;
    rig.command.gyro_bias_radps = 0.003 * i - 0.07;
    rig.command.expiry_us = (DeviceUs{3} << 32) + 0xFFFF'F000 + i * 211;
    trace.run(1);
  }
  // While commands flow, the clock is asked at its own period.
  rig.commands = false;
  for (int i = 0; i < 300; ++i) {
    if (i % 60 == 0) rig.session.send(rig.command, rig.now);
    trace.run(5);
  }
  rig.robot.answers_sync = false;
  trace.run(1500);
  rig.robot.answers_sync = true;
  trace.port_takes = false;
  for (int i = 0; i < 40; ++i) {
    rig.session.send(rig.command, rig.now);
    if (i % 5 == 0) trace.state();
    trace.run(2);
  }
  rig.session.written(100);
  rig.session.drop_output();
  trace.port_takes = true;
  trace.run(600);
  EXPECT_EQ(trace.difference(), "");
}

TEST(RequestTrace, SamplesThatAreLostRepeatedLateAndImpossible) {
  SessionSettings settings = SessionRig::settings();
  settings.parameters.max_track_mps = 0.2F;
  settings.parameters.counts_per_metre = 10'000.0F;
  SessionTrace trace("losses", 15, settings);
  SessionRig& rig = trace.rig;
  rig.robot.sequence = 65'400;
  rig.robot.device_offset_us = 0xFFFF'FFFFU - 1'100'000U;
  rig.robot.metres_per_s = 0.15;
  rig.session.open(rig.now);
  trace.run(300);
  trace.writes_down = true;
  for (int i = 0; i < 260; ++i) {
    if (i % 9 == 4) rig.robot.sequence = static_cast<std::uint16_t>(rig.robot.sequence + i % 4);
    if (i % 13 == 6) rig.robot.sequence = static_cast<std::uint16_t>(rig.robot.sequence - i % 5);
    if (i % 31 == 30)
      rig.robot.sequence = static_cast<std::uint16_t>(rig.robot.sequence + 60 + i % 7);
    if (i % 17 == 11) {
      wire::Sample sample = rig.robot.sample(rig.now);
      sample.sequence = static_cast<std::uint16_t>(sample.sequence + 2);
      sample.device_us += static_cast<std::uint32_t>(i * 700 - 60'000);
      sample.left_counts += i % 2 * 400;
      sample.right_counts -= i % 3 * 300;
      trace.receive(sample);
    }
    trace.run(3);
  }
  // Samples of a clock that goes back are nonsense after a while.
  rig.robot.device_offset_us -= 400'000U;
  trace.run(400);
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::link
