// Golden traces of the whole firmware in scripted sessions.

#include "session_trace.h"

#include <gtest/gtest.h>

#include <vector>

#include "trace_inputs.h"

namespace tp100::firmware {
namespace {

void ask(Rig& rig) { rig.send(wire::HelloRequest{wire::kProtocolVersion, wire::kSchemaHash}); }

void hand_over_parameters(Rig& rig) {
  rig.parameters.boot_nonce = rig.hal.nonce;
  rig.parameters.token = ++rig.token;
  rig.send(rig.parameters);
}

void spoil(Rig& rig, std::vector<std::uint8_t> bytes) {
  bytes.push_back(0);
  rig.hal.received.insert(rig.hal.received.end(), bytes.begin(), bytes.end());
}

TEST(GoldenSession, IsHeldAsRecorded) {
  SessionTrace session("session", 20);
  for (const auto cause :
       {wire::ResetCause::kUnknown, wire::ResetCause::kPowerOn, wire::ResetCause::kExternal,
        wire::ResetCause::kBrownOut, wire::ResetCause::kWatchdog}) {
    Rig& rig = session.plug(false);
    rig.hal.cause = cause;
    rig.hal.nonce = static_cast<std::uint32_t>(cause) * 1111;
    rig.hal.now_us = 0xFFFFFFFFU - 250'000;
    rig.boot();
    session.run(230);
    ask(rig);
    session.run(31);
  }

  Rig& rig = session.plug(false);
  rig.hal.now_us = 0xFFFFFFFFU - 2'000'000;
  rig.hal.gyro_z = -300;
  rig.hal.accel_x = 120;
  rig.hal.left_counts = 1234;
  rig.hal.right_counts = -4321;
  rig.boot();
  session.run(111);
  rig.send(rig.command());
  rig.send(rig.arm_message());
  rig.send(wire::SyncRequest{51});
  session.run(20);
  rig.send(wire::Disarm{777});
  ask(rig);
  session.run(9);
  rig.send(rig.arm_message());
  session.run(9);
  wire::Parameters wrong = rig.parameters;
  wrong.boot_nonce = 5;
  rig.send(wrong);
  wrong.boot_nonce = rig.hal.nonce;
  wrong.stall_ms = 49;
  rig.send(wrong);
  session.run(9);
  rig.parameters.command_life_ms = 130;
  rig.parameters.flags = wire::kUseGyro | wire::kSwapTracks | wire::kInvertRightMotor;
  hand_over_parameters(rig);
  session.run(17);
  rig.send(rig.parameters);
  rig.send(rig.arm_message());
  session.run(11);
  rig.streams = true;
  rig.bias_radps = 0.04f;
  session.run(40);
  wire::Arm arm = rig.arm_message();
  arm.boot_nonce = 3;
  rig.send(arm);
  for (const int ahead_us : {-1, 0, 500'001, 500'600, 500'000}) {
    arm = rig.arm_message();
    arm.expiry_us = rig.hal.now_us + static_cast<std::uint32_t>(ahead_us);
    rig.send(arm);
    session.run(7);
  }
  rig.send(arm);
  arm.token -= 2;
  rig.send(arm);
  session.run(9);
  hand_over_parameters(rig);
  session.run(20);
  rig.speed_mps = 0.06f;
  rig.yaw_rate_radps = 0.2f;
  rig.desired_yaw_rad = 0.07f;
  session.run(160);
  // Refused commands in between.
  wire::Command command = rig.command();
  command.speed_mps = 3.0f;
  rig.send(command);
  session.run(2);
  rig.hal.waiting = 33;
  rig.hal.missed = 7;
  rig.send(wire::SyncRequest{52});
  session.run(5);
  command = rig.command();
  command.expiry_us = rig.hal.now_us + 40'000;
  rig.send(command);
  rig.streams = false;
  session.run(60);
  rig.streams = true;
  session.run(20);
  rig.send(rig.arm_message());
  session.run(90);
  rig.hal.imu_answers = false;
  session.run(33);
  rig.hal.imu_answers = true;
  session.run(50);
  // Foreign bytes, and frames that are none.
  spoil(rig, {7, 1, 2});
  spoil(rig, {3, 1, 2});
  spoil(rig, {5, 0x46, 1, 2, 3});
  spoil(rig, std::vector<std::uint8_t>(150, 9));
  auto frame = test::frame_of(wire::Stop{1});
  frame[3] ^= 4;
  rig.hal.received.insert(rig.hal.received.end(), frame.begin(), frame.end());
  rig.send(wire::FaultReport{});
  const std::uint8_t payload[] = {1, 2, 3, 4, 5};
  for (std::uint8_t type = 0x40; type < 0x49; ++type) {
    std::vector<std::uint8_t> odd(wire::kMaxFrame);
    odd.resize(wire::encode_frame(type, payload, 5, odd.data()));
    if (type != 0x41) rig.hal.received.insert(rig.hal.received.end(), odd.begin(), odd.end());
  }
  session.run(21);
  rig.send(wire::SyncRequest{53});
  session.run(9);
  for (int ms = 4; ms < 17; ++ms) {
    session.hang(ms);
    session.run(23);
  }
  session.hang(120);
  session.run(33);
  rig.send(rig.arm_message());
  session.run(44);
  rig.send(wire::Stop{4242});
  session.run(30);
  rig.send(rig.arm_message());
  session.run(40);
  rig.send(wire::Disarm{4243});
  session.run(30);
  rig.send(rig.arm_message());
  session.run(40);
  // Each wish moves the robot, and none of them does not.
  for (int wish = 0; wish < 6; ++wish) {
    rig.speed_mps = wish == 1 ? -0.03f : 0.0f;
    rig.yaw_rate_radps = wish == 2 ? -0.1f : 0.0f;
    rig.desired_yaw_rad = rig.yaw_rad + (wish == 3 ? 0.03f : wish == 4 ? -6.3f : 0.0f);
    rig.send(wire::Disarm{5000});
    session.run(12);
    rig.send(rig.arm_message());
    session.run(60);
  }
  // The line takes little.
  for (const std::size_t room : {0U, 12U, 15U, 40U, 44U, 45U, 46U}) {
    rig.room = room;
    rig.send(wire::SyncRequest{static_cast<std::uint16_t>(60 + room)});
    rig.send(wire::SyncRequest{static_cast<std::uint16_t>(160 + room)});
    for (unsigned i = 0; i < 8; ++i) rig.send(wire::Disarm{static_cast<std::uint32_t>(900 + i)});
    rig.send(rig.arm_message());
    ask(rig);
    session.run(16);
    hand_over_parameters(rig);
    session.run(9);
    rig.room = 200;
    session.run(13);
  }
  for (const std::size_t room : {22U, 23U, 24U, 25U}) {
    ask(rig);
    session.run(2);
    rig.room = room;
    ask(rig);
    session.run(3);
    rig.room = 200;
    session.run(20);
  }
  rig.send(rig.arm_message());
  session.run(61);
  ask(rig);
  session.run(30);
  hand_over_parameters(rig);
  session.run(40);
  rig.send(rig.arm_message());
  session.run(61);
  rig.streams = false;
  session.run(1400);
  hand_over_parameters(rig);
  session.run(990);
  EXPECT_EQ(session.driving.difference(1e-8), "");
  EXPECT_EQ(session.events.difference(1e-8), "");
}

TEST(GoldenSession, DrivesAndFailsAsRecorded) {
  SessionTrace session("drive", 40);
  for (int hindrance = 0; hindrance < 9; ++hindrance) {
    Rig& rig = session.plug();
    rig.tracks_follow = true;
    rig.parameters = uneven_parameters();
    rig.load_duty = 0.02;
    if (hindrance == 8) rig.parameters.flags = 0;
    ask(rig);
    session.run(3);
    hand_over_parameters(rig);
    session.run(12);
    rig.streams = true;
    session.run(20);
    rig.send(rig.arm_message());
    const int ms = hindrance == 0 ? 3500 : 1400;
    for (int i = 0; i < ms; i += 5) {
      rig.speed_mps = static_cast<float>(0.11 + 0.06 * zigzag(i, 1700));
      if (hindrance % 2 == 1) rig.speed_mps = -rig.speed_mps;
      rig.yaw_rate_radps = static_cast<float>(0.3 * zigzag(i, 900));
      rig.desired_yaw_rad = static_cast<float>(0.2 * zigzag(i, 2300));
      rig.yaw_rad = static_cast<float>(rig.true_yaw_rad);
      rig.hal.pack_mv = static_cast<std::uint16_t>(7600 - i % 70);
      if (i > 600) {
        if (hindrance == 1) rig.left_blocked = true;
        if (hindrance == 2) rig.right_blocked = true;
        if (hindrance == 3) rig.jumped_m = 0.02 * (i / 250);
        if (hindrance == 4) rig.left_counted = 0.3, rig.scrub_duty = 0.03;
        if (hindrance == 5) rig.hal.imu_frozen = true;
        if (hindrance == 6) rig.hal.imu_answers = i > 1000;
        if (hindrance == 7) rig.disturbance_radps = 0.3;
        if (hindrance == 8) rig.right_counted = -1.0;
      }
      if (i == 1200) rig.send(rig.arm_message());
      session.run(5);
    }
  }
  // The battery sinks for longer than a second.
  Rig& rig = session.plug();
  rig.drive(0.1f);
  for (int i = 0; i < 1700; ++i) {
    rig.hal.pack_mv = static_cast<std::uint16_t>(i < 1350 ? 5950 : 6100);
    if (i == 1250 || i == 1500) rig.send(rig.arm_message());
    session.run(1);
  }
  // The IMU is dead from the start; only without the gyro may the robot drive.
  for (const int flags : {int{wire::kUseGyro}, 0}) {
    Rig& dead = session.plug(false);
    dead.hal.imu_answers = false;
    dead.tracks_follow = true;
    dead.boot();
    dead.parameters.flags = static_cast<std::uint8_t>(flags);
    dead.drive(-0.09f);
    session.run(200);
    dead.hal.imu_answers = true;
    session.run(200);
    dead.send(dead.arm_message());
    session.run(200);
  }
  EXPECT_EQ(session.driving.difference(1e-8), "");
  EXPECT_EQ(session.events.difference(1e-8), "");
}

TEST(GoldenSession, IsEndedByTheRecordedSilenceWhateverTheHostSaidLast) {
  SessionTrace session("silence", 100);
  for (int last = 0; last < 10; ++last) {
    Rig& rig = session.plug();
    rig.connect();
    for (int ms = 0; ms < 1900; ms += 300) {
      wire::Command command = rig.command();
      wire::Arm arm = rig.arm_message();
      wire::Parameters wrong = rig.parameters;
      const std::uint32_t other_boot = last > 7 ? 1 : 0;
      command.boot_nonce += other_boot;
      arm.boot_nonce += other_boot;
      wrong.boot_nonce += 1;
      if (last == 1) ask(rig);
      if (last == 2) hand_over_parameters(rig);
      if (last == 3 || last == 8) rig.send(command);
      if (last == 4 || last == 9) rig.send(arm);
      if (last == 5) rig.send(wire::Disarm{static_cast<std::uint32_t>(ms)});
      if (last == 6) rig.send(wire::Stop{static_cast<std::uint32_t>(ms)});
      if (last == 7) rig.send(wire::SyncRequest{static_cast<std::uint16_t>(ms)});
      if (last == 8) rig.send(wrong);
      session.run(300);
    }
  }
  EXPECT_EQ(session.driving.difference(1e-8), "");
  EXPECT_EQ(session.events.difference(1e-8), "");
}

}  // namespace
}  // namespace tp100::firmware
