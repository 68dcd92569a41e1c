// Tests speed and yaw of an armed robot.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::State;

TEST(Drive, ReachesTheSpeedThatEquationsOneAndFiveAsk) {
  for (const float speed : {0.03f, 0.1f, 0.14f, -0.08f}) {
    Rig rig;
    rig.parameters.yaw_kp = 0.0f;
    rig.tracks_follow = true;
    rig.drive(speed);
    rig.run(1500);
    const std::int32_t left = rig.hal.left_counts, right = rig.hal.right_counts;
    rig.run(1000);
    const double counts = static_cast<double>(speed) * 11140.0;
    EXPECT_NEAR(rig.hal.left_counts - left, counts / 0.84, 0.03 * std::abs(counts)) << speed;
    EXPECT_NEAR(rig.hal.right_counts - right, counts / 0.90, 0.03 * std::abs(counts)) << speed;
    EXPECT_EQ(rig.program.faults(), 0);
  }
}

TEST(Drive, AccelerationIsLimited) {
  Rig rig;
  rig.tracks_follow = true;
  rig.drive(0.15f);
  double fastest = 0.0;
  double last = rig.right_mps;
  for (int i = 0; i < 200; ++i) {
    rig.run(5);
    fastest = std::max(fastest, (rig.right_mps - last) / 5e-3);
    last = rig.right_mps;
  }
  EXPECT_LT(fastest, 0.6 * 1.6);
}

TEST(Drive, AZeroTargetEndsWithNoDutyAndStays) {
  Rig rig;
  rig.tracks_follow = true;
  rig.drive(0.12f);
  rig.run(1000);
  rig.speed_mps = 0.0f;
  rig.run(1000);
  EXPECT_FALSE(rig.motors_on());
  const int writes = rig.hal.nonzero_writes;
  rig.run(1000);
  EXPECT_EQ(rig.hal.nonzero_writes, writes);
  EXPECT_EQ(rig.program.state(), State::kRunning);
}

TEST(Drive, IntegratorsStartClearedAfterAnArm) {
  Rig rig;
  rig.parameters.stall_duty = 0;
  rig.tracks_follow = true;
  rig.left_blocked = true;
  rig.drive(0.1f);
  rig.run(1000);
  rig.send(wire::Disarm{1});
  rig.run(50);
  rig.left_blocked = false;
  rig.speed_mps = 0.0f;
  rig.yaw_rad = rig.desired_yaw_rad = 0.0f;
  rig.run(300);
  const int writes = rig.hal.nonzero_writes;
  rig.arm();
  rig.run(100);
  EXPECT_EQ(rig.hal.nonzero_writes, writes);
}

// Right minus left duty, 30 ms after a command that answers a sample 50 ms old. The gyro reads
// `rate_radps` until the command arrives.
int turning_duty(float rate_radps, float desired_yaw_rad, float bias_radps = 0.0f) {
  Rig rig;
  rig.parameters.max_track_mps2 = 20.0f;
  rig.be_ready();
  rig.run(80);
  rig.arm();
  rig.streams = false;
  rig.run(20);
  rig.hal.gyro_z = static_cast<std::int16_t>(rate_radps / test::kGyroRadpsPerLsb);
  rig.run(60);
  rig.hal.gyro_z = 0;
  wire::Command command = rig.command();
  command.answers = static_cast<std::uint16_t>(rig.samples.back().sequence - 10);
  command.yaw_rad = 1.0f;
  command.desired_yaw_rad = 1.0f + desired_yaw_rad;
  command.speed_mps = 0.08f;
  command.gyro_bias_radps = bias_radps;
  rig.send(command);
  rig.run(30);
  EXPECT_EQ(rig.program.state(), State::kRunning);
  return rig.samples.back().right_duty - rig.samples.back().left_duty;
}

TEST(Drive, YawIsCarriedForwardFromTheAnsweredSample) {
  const int straight = turning_duty(0.0f, 0.0f);
  // The robot has turned at 0.5 rad/s for 50 ms since the answered sample, and for half a sample
  // more.
  EXPECT_NEAR(turning_duty(0.5f, 0.02625f), straight, 15);
  EXPECT_GT(turning_duty(0.0f, 0.02625f), straight + 100);
  EXPECT_LT(turning_duty(0.5f, 0.0f), straight - 100);
  // A bias of 0.5 rad/s is taken off, also for the 25 ms of standstill until the reported duty was
  // computed: 0.5 * 0.075 s less the 0.02625 rad that the gyro shows.
  EXPECT_NEAR(turning_duty(0.5f, 0.0f, 0.5f), turning_duty(0.0f, 0.01125f), 15);
}

}  // namespace
}  // namespace tp100::firmware
