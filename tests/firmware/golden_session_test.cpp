// Golden traces of the whole firmware in scripted sessions.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "../support/golden_trace.h"
#include "rig.h"
#include "trace_inputs.h"

namespace tp100::firmware {
namespace {

using test::GoldenTrace;

/// Runs a rig and records what it sends and does.
class Session {
 public:
  Session(const std::string& name, int period_ms)
      : driving{"firmware/golden_" + name + "_samples.csv",
                {"ms",           "state",      "faults",      "verdict",      "left_motor",
                 "right_motor",  "samples",    "sequence",    "age_us",       "left_counts",
                 "right_counts", "left_duty",  "right_duty",  "gyro_z",       "accel_x",
                 "battery_mv",   "told_state", "told_faults", "last_command", "imu_age",
                 "corrupted",    "unknown",    "unsent",      "good",         "idles",
                 "kicks",        "writes",     "i2c_calls",   "recoveries"}},
        events{"firmware/golden_" + name + "_events.csv",
               {"ms", "type", "a", "b", "c", "d", "e", "f", "g", "h"}},
        period_ms_(period_ms) {}

  /// Another robot is plugged in.
  Rig& plug(bool boot_now = true) {
    rig_ = std::make_unique<Rig>(boot_now);
    told_ = Told{};
    return *rig_;
  }
  void run(int ms) {
    for (int i = 0; i < ms; ++i) {
      rig_->run(1);
      ++ms_;
      write_events();
      if (ms_ % period_ms_ == 0) write_samples();
    }
  }
  void hang(int ms) {
    rig_->hang(ms);
    ms_ += ms;
  }

  GoldenTrace driving;
  GoldenTrace events;

 private:
  struct Told {
    std::size_t samples = 0;
    std::size_t hellos = 0;
    std::size_t acknowledges = 0;
    std::size_t sync_replies = 0;
    std::size_t reports = 0;
    std::size_t logs = 0;
  };

  double ago_us(std::uint32_t us) const { return static_cast<std::int32_t>(rig_->hal.now_us - us); }
  void event(wire::Type type, std::vector<double> values) {
    values.resize(8);
    values.insert(values.begin(), {1.0 * ms_, 1.0 * static_cast<int>(type)});
    events.row(values);
  }
  void write_events() {
    Rig& r = *rig_;
    for (; told_.hellos < r.hellos.size(); ++told_.hellos) {
      const wire::Hello& m = r.hellos[told_.hellos];
      event(m.kType, {1.0 * m.protocol, m.firmware[0] * 1e4 + m.firmware[1] * 1e2 + m.firmware[2],
                      m.schema == wire::kSchemaHash ? 1.0 : 0.0, 1.0 * m.board, 1.0 * m.boot_nonce,
                      1.0 * m.reset_cause, 1.0 * m.state, 1.0 * m.faults});
    }
    for (; told_.acknowledges < r.acknowledges.size(); ++told_.acknowledges) {
      const wire::Acknowledge& m = r.acknowledges[told_.acknowledges];
      event(m.kType, {1.0 * m.request, 1.0 * m.token, 1.0 * m.result, 1.0 * m.detail});
    }
    for (; told_.sync_replies < r.sync_replies.size(); ++told_.sync_replies) {
      const wire::SyncReply& m = r.sync_replies[told_.sync_replies];
      event(m.kType, {1.0 * m.id, ago_us(m.received_us), ago_us(m.sent_us), 1.0 * m.corrupted,
                      1.0 * m.missed_edges});
    }
    for (; told_.reports < r.reports.size(); ++told_.reports) {
      const wire::FaultReport& m = r.reports[told_.reports];
      event(m.kType, {ago_us(m.device_us), 1.0 * m.fault, 1.0 * m.faults, 1.0 * m.detail});
    }
    for (; told_.logs < r.log_messages.size(); ++told_.logs) {
      const wire::Log& m = r.log_messages[told_.logs];
      int text = 0;
      for (const std::uint8_t byte : m.text) text = (text * 31 + byte) % 1'000'003;
      event(m.kType, {ago_us(m.device_us), 1.0 * m.level, 1.0 * text});
    }
  }
  // Sums over the samples since the last row, so that none is missing.
  void write_samples() {
    const Rig& r = *rig_;
    wire::Sample last{};
    double left_duty = 0.0, right_duty = 0.0, gyro_z = 0.0, accel_x = 0.0, left_counts = 0.0,
           right_counts = 0.0, age_us = 0.0;
    int states = 0, faults = 0, commands = 0, imu_ages = 0;
    const std::size_t before = told_.samples;
    for (; told_.samples < r.samples.size(); ++told_.samples) {
      last = r.samples[told_.samples];
      left_duty += last.left_duty;
      right_duty += last.right_duty;
      gyro_z += last.gyro[2];
      accel_x += last.accel[0];
      left_counts += last.left_counts;
      right_counts += last.right_counts;
      age_us += ago_us(last.device_us);
      states += last.state;
      faults += last.faults;
      commands += last.last_command;
      imu_ages += last.imu_age;
    }
    const LinkCounts& link = r.program.link_counts();
    driving.row({1.0 * ms_,
                 1.0 * static_cast<int>(r.program.state()),
                 1.0 * r.program.faults(),
                 1.0 * static_cast<int>(r.program.last_verdict()),
                 1.0 * r.hal.duties.left,
                 1.0 * r.hal.duties.right,
                 static_cast<double>(told_.samples - before),
                 1.0 * last.sequence,
                 age_us,
                 left_counts,
                 right_counts,
                 left_duty,
                 right_duty,
                 gyro_z,
                 accel_x,
                 1.0 * last.battery_mv,
                 1.0 * states,
                 1.0 * faults,
                 1.0 * commands,
                 1.0 * imu_ages,
                 1.0 * link.corrupted(),
                 1.0 * link.unknown,
                 1.0 * link.unsent,
                 1.0 * link.good,
                 1.0 * r.hal.idles,
                 1.0 * r.hal.kicks,
                 1.0 * r.hal.nonzero_writes,
                 1.0 * r.hal.i2c_calls,
                 1.0 * r.hal.recoveries});
  }

  std::unique_ptr<Rig> rig_;
  Told told_;
  int period_ms_;
  int ms_ = 0;
};

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
  Session session("session", 20);
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
  for (const int ahead_us : {-1, 500'600, 499'000}) {
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
  session.run(21);
  rig.send(wire::SyncRequest{53});
  session.run(9);
  session.hang(7);
  session.run(10);
  session.hang(14);
  session.run(33);
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
  Session session("drive", 40);
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
  EXPECT_EQ(session.driving.difference(1e-8), "");
  EXPECT_EQ(session.events.difference(1e-8), "");
}

}  // namespace
}  // namespace tp100::firmware
