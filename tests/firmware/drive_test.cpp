// Tests speed and yaw of an armed robot.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "rig.h"

namespace tp100::firmware {
namespace {

using wire::State;

struct Mean {
  double left = 0.0;
  double right = 0.0;
};

Mean mean_over(Rig& rig, int ms) {
  Mean mean;
  for (int i = 0; i < ms; ++i) {
    rig.run(1);
    mean.left += rig.left_mps / ms;
    mean.right += rig.right_mps / ms;
  }
  return mean;
}

TEST(Drive, ReachesTheSpeedThatEquationsOneAndFiveAsk) {
  for (const float speed : {0.03f, 0.1f, 0.14f, -0.08f}) {
    Rig rig;
    rig.parameters.yaw_kp = 0.0f;
    rig.tracks_follow = true;
    rig.drive(speed);
    rig.run(1500);
    const Mean mean = mean_over(rig, 500);
    const double wanted = static_cast<double>(speed);
    EXPECT_NEAR(mean.left, wanted / 0.84, 0.03 * std::abs(wanted)) << speed;
    EXPECT_NEAR(mean.right, wanted / 0.90, 0.03 * std::abs(wanted)) << speed;
    EXPECT_EQ(rig.program.faults(), 0);
  }
}

TEST(Drive, TurnsOnTheSpotAtTheRateAsked) {
  Rig rig;
  rig.parameters.yaw_kp = 0.0f;
  rig.tracks_follow = true;
  rig.yaw_rate_radps = 0.6f;
  rig.drive(0.0f);
  rig.run(1500);
  const double before = rig.true_yaw_rad;
  rig.run(1000);
  EXPECT_NEAR(rig.true_yaw_rad - before, 0.6, 0.03);
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

TEST(Drive, ATrackThatWasHeldDoesNotShootAhead) {
  Rig rig;
  rig.parameters.stall_duty = 0;
  rig.parameters.yaw_kp = 0.0f;
  rig.tracks_follow = true;
  rig.left_blocked = true;
  rig.drive(0.08f);
  rig.run(3000);
  rig.left_blocked = false;
  double fastest = 0.0;
  double ahead_m = 0.0;
  for (int i = 0; i < 2000; ++i) {
    rig.run(1);
    fastest = std::max(fastest, rig.left_mps);
    ahead_m += (rig.left_mps - 0.08 / 0.84) * 1e-3;
  }
  EXPECT_LT(fastest, 0.16) << "a lag of 2 cm may raise the speed for a moment";
  EXPECT_LT(ahead_m, 0.025) << "only a little of the missed 24 cm may be made up";
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

TEST(Drive, ADutyIsNeverMoreThanFull) {
  Rig rig;
  rig.parameters.stall_duty = 0;
  rig.tracks_follow = true;
  rig.left_blocked = rig.right_blocked = true;
  rig.drive(0.2f);
  int most = 0;
  for (int ms = 0; ms < 1000; ++ms) {
    rig.run(1);
    most = std::max(most, std::abs(int{rig.hal.duties.left}));
  }
  EXPECT_EQ(most, wire::kFullDuty);
}

TEST(SpeedLoop, ASaturatedMotorDoesNotWindUp) {
  wire::Parameters p = test::good_parameters();
  p.speed_ki = 1.0f;
  SpeedLoop loop;
  for (int i = 0; i < 100; ++i) {
    loop.measure(0, 5000, p);
    EXPECT_FLOAT_EQ(loop.update(0.2f, 5e-3f, p), 1.0f);
  }
  EXPECT_EQ(loop.lag_m(), 0.0f);
}

TEST(SpeedLoop, NorDoesItBackwards) {
  wire::Parameters p = test::good_parameters();
  p.speed_ki = 1.0f;
  SpeedLoop loop;
  for (int i = 0; i < 100; ++i) {
    loop.measure(0, 5000, p);
    EXPECT_FLOAT_EQ(loop.update(-0.2f, 5e-3f, p), -1.0f);
  }
  EXPECT_EQ(loop.lag_m(), 0.0f);
}

TEST(SpeedLoop, TheLagOfATrackThatDoesNotFollowIsBounded) {
  wire::Parameters p = test::good_parameters();
  p.speed_kp = 0.0f;
  p.speed_ki = 10.0f;
  SpeedLoop loop;
  float duty = 0.0f;
  for (int i = 0; i < 2000; ++i) {
    loop.measure(0, 5000, p);
    duty = loop.update(0.02f, 5e-3f, p);
  }
  EXPECT_FLOAT_EQ(loop.lag_m(), 0.02f);
  EXPECT_NEAR(duty, 0.15f + 4.0f * 0.02f + 0.2f, 1e-4f);
}

TEST(SpeedLoop, TheDeadBandIsBlendedIn) {
  wire::Parameters p = test::good_parameters();
  p.speed_ki = 0.0f;
  SpeedLoop loop;
  float last = 0.0f;
  for (float target = 0.0006f; target < 0.02f; target += 0.0001f) {
    loop.measure(0, 5000, p);
    const float duty = loop.update(target, 5e-3f, p);
    EXPECT_GT(duty, last);
    EXPECT_LT(duty - last, 0.03f);
    last = duty;
  }
}

// Right minus left duty, 30 ms after a command that answers a sample 50 ms old. The gyro reads
// `rate_radps` until the command arrives.
int turning_duty(float rate_radps, float desired_yaw_rad) {
  Rig rig;
  rig.parameters.max_track_mps2 = 20.0f;
  rig.connect();
  rig.streams = true;
  rig.run(100);
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
}

TEST(Drive, TheGyroBiasIsTakenOff) {
  wire::Parameters p = test::good_parameters();
  TurnHistory history;
  const auto raw = static_cast<std::int16_t>(0.1f / test::kGyroRadpsPerLsb);
  std::uint32_t us = 0xFFFFFFFFU - 50'000U;  // the clock wraps during the test
  for (std::uint16_t i = 65'520; i != 20; ++i) {
    history.add(i, us, raw, 0, 0);
    us += 5000;
  }
  const TurnMark* then = history.find(65'530);
  ASSERT_NE(then, nullptr);
  const float span_s = 25 * 5e-3f;
  EXPECT_NEAR(turned(*then, history.newest(), true, 0.0f, p), 0.1f * span_s, 1e-4f);
  EXPECT_NEAR(turned(*then, history.newest(), true, 0.1f, p), 0.0f, 1e-4f);
}

TEST(Drive, WithoutTheGyroTheTracksCarryTheYaw) {
  wire::Parameters p = test::good_parameters();
  TurnHistory history;
  for (std::uint16_t i = 0; i < 30; ++i) {
    history.add(i, i * 5000U, 12'000, -i * 10, i * 10);
  }
  const TurnMark* then = history.find(9);
  ASSERT_NE(then, nullptr);
  const float arc_m = 200.0f / 11140.0f * (0.90f + 0.84f);
  EXPECT_NEAR(turned(*then, history.newest(), false, 0.5f, p), arc_m / 0.274f, 1e-5f);
}

TEST(Drive, UnknownSamplesAreNotFound) {
  TurnHistory history;
  EXPECT_EQ(history.find(0), nullptr);
  for (std::uint16_t i = 100; i < 300; ++i) history.add(i, i * 5000U, 0, 0, 0);
  EXPECT_NE(history.find(299), nullptr);
  EXPECT_NE(history.find(299 - 41), nullptr) << "the history must hold 200 ms";
  EXPECT_EQ(history.find(300), nullptr);
  EXPECT_EQ(history.find(100), nullptr);
  EXPECT_EQ(history.find(299 + 32'768), nullptr);
  history.clear();
  EXPECT_EQ(history.find(299), nullptr);
}

TEST(Drive, YawErrorIsClosedByTheGyroBetweenCommands) {
  Rig rig;
  rig.tracks_follow = true;
  rig.connect();
  rig.streams = true;
  rig.run(50);
  rig.arm();
  // The host knows the true yaw of each sample and requests 0.4 rad to the left.
  rig.speed_mps = 0.08f;
  for (int i = 0; i < 500; ++i) {
    rig.yaw_rad = static_cast<float>(rig.true_yaw_rad);
    rig.desired_yaw_rad = 0.4f;
    rig.run(5);
  }
  EXPECT_NEAR(rig.true_yaw_rad, 0.4, 0.02);
}

TEST(Drive, TheShortWayRoundIsTaken) {
  const wire::Parameters p = test::good_parameters();
  EXPECT_GT(turn_rate(6.0f - 12.5663706f * 2.0f, 0.0f, p), -p.max_yaw_radps - 1e-6f);
  EXPECT_LT(turn_rate(6.0f, 0.0f, p), 0.0f);
  EXPECT_GT(turn_rate(-6.0f, 0.0f, p), 0.0f);
  EXPECT_NEAR(turn_rate(0.1f + 50 * 6.28318531f, 0.0f, p), 0.4f, 1e-3f);
  EXPECT_FLOAT_EQ(turn_rate(3.0f, 0.0f, p), p.max_yaw_radps);
  EXPECT_FLOAT_EQ(turn_rate(0.0f, -0.3f, p), -0.3f);
}

TEST(TrackSpeeds, InvertEquationsOneAndFive) {
  const wire::Parameters p = test::good_parameters();
  const TrackSpeeds tracks = track_speeds(0.1f, 0.2f, p);
  const float left = tracks.left * (1.0f - p.slip_left);
  const float right = tracks.right * (1.0f - p.slip_right);
  EXPECT_NEAR((left + right) / 2.0f, 0.1f, 1e-6f);
  EXPECT_NEAR((right - left) / p.wheelbase_m, 0.2f, 1e-5f);
}

TEST(TrackSpeeds, SaturationKeepsTheTurnAndCutsTheSpeed) {
  const wire::Parameters p = test::good_parameters();
  for (const float speed : {0.2f, 0.5f, 2.0f, -2.0f}) {
    const TrackSpeeds tracks = track_speeds(speed, 0.5f, p);
    EXPECT_LE(std::max(std::abs(tracks.left), std::abs(tracks.right)), p.max_track_mps + 1e-6f);
    const float left = tracks.left * (1.0f - p.slip_left);
    const float right = tracks.right * (1.0f - p.slip_right);
    EXPECT_NEAR((right - left) / p.wheelbase_m, 0.5f, 1e-5f) << speed;
  }
}

TEST(TrackSpeeds, ATurnBeyondTheLimitTurnsOnTheSpot) {
  const wire::Parameters p = test::good_parameters();
  const TrackSpeeds tracks = track_speeds(0.2f, 5.0f, p);
  EXPECT_FLOAT_EQ(tracks.right, p.max_track_mps);
  EXPECT_FLOAT_EQ(tracks.left, -p.max_track_mps);
}

}  // namespace
}  // namespace tp100::firmware
