#include "bridge/cycle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "../link/scripted_robot.h"
#include "core/arithmetic.h"
#include "core/faults.h"
#include "course/course.h"
#include "firmware/track_monitor.h"
#include "model/track_model.h"

namespace tp100::bridge {
namespace {

class CycleRig {
 public:
  explicit CycleRig(const bridge::Parameters& parameters = {})
      : cycle(session_settings(parameters), parameters, nullptr) {
    cycle.session().open(now);
  }
  void run(int ms) {
    for (int i = 0; i < ms; ++i) {
      now += kNsPerMs;
      robot.tick(now);
      cycle.session().receive(robot.take(), now);
      if (i % 5 == 0) cycle.step(now);
      robot.receive(cycle.session().output(), now);
      cycle.session().written(cycle.session().output().size());
      cycle.session().take_events();
    }
  }
  HostNs now = kNsPerS;
  ScriptedRobot robot;
  Cycle cycle;
};

TEST(Cycle, SendsEachOfTheRobotsValuesInItsUnit) {
  bridge::Parameters parameters;
  parameters.model = {.slip_left = 0.17,
                      .slip_right = 0.11,
                      .wheelbase_m = 0.29,
                      .wheelbase_medium_m = 0.31,
                      .wheelbase_spin_m = 0.36,
                      .gyro_scale = 1.02};
  parameters.drive = {.counts_per_metre = 9000,
                      .max_track_mps = 0.21,
                      .max_track_mps2 = 0.7,
                      .feed_forward = 3.5,
                      .dead_band = 0.13,
                      .speed_kp = 4.5,
                      .speed_ki = 31,
                      .yaw_kp = 3.75,
                      .max_yaw_radps = 1.25,
                      .battery_cutoff_v = 6.25,
                      .stall_duty = 0.55,
                      .stall_s = 1.5,
                      .invert_left_encoder = true,
                      .swap_tracks = true};
  parameters.control.turn_slip_share = 0.07;
  CycleRig rig(parameters);
  rig.run(100);
  ASSERT_EQ(rig.robot.received.parameters.size(), 1u);
  const wire::Parameters& sent = rig.robot.received.parameters[0];
  EXPECT_EQ(sent.counts_per_metre, 9000.0F);
  EXPECT_EQ(sent.wheelbase_m, 0.31F) << "of medium arcs";
  EXPECT_EQ(sent.wheelbase_tight_m, 0.36F) << "as on the spot, if it is not given";
  EXPECT_EQ(sent.wheelbase_spin_m, 0.36F);
  EXPECT_EQ(sent.turn_slip_share, 0.07F);
  EXPECT_EQ(sent.slip_left, 0.17F);
  EXPECT_EQ(sent.slip_right, 0.11F);
  EXPECT_EQ(sent.max_track_mps, 0.21F);
  EXPECT_EQ(sent.max_track_mps2, 0.7F);
  EXPECT_EQ(sent.feed_forward, 3.5F);
  EXPECT_EQ(sent.dead_band, 0.13F);
  EXPECT_EQ(sent.speed_kp, 4.5F);
  EXPECT_EQ(sent.speed_ki, 31.0F);
  EXPECT_EQ(sent.yaw_kp, 3.75F);
  EXPECT_EQ(sent.max_yaw_radps, 1.25F);
  EXPECT_FLOAT_EQ(sent.gyro_z_radps_per_lsb, static_cast<float>(1.02 * kRadPerDeg / 32.8));
  EXPECT_EQ(sent.battery_cutoff_mv, 6250);
  EXPECT_EQ(sent.stall_duty, 550);
  EXPECT_EQ(sent.stall_ms, 1500);
  EXPECT_EQ(sent.command_life_ms, 200);
  EXPECT_EQ(sent.yaw_window_ms, 200);
  EXPECT_EQ(sent.flags, wire::kUseGyro | wire::kInvertLeftEncoder | wire::kSwapTracks);
  EXPECT_EQ(parameter_name(3), "wheelbase_m") << "a robot that refuses one says its number";
  EXPECT_EQ(parameter_name(99), "unknown");
  parameters.drive = {
      .invert_left_motor = true, .invert_right_motor = true, .invert_right_encoder = true};
  parameters.setup = bridge::Setup::kStand;
  course::Course course;
  course.identifies = true;
  const wire::Parameters other = session_settings(parameters, &course).parameters;
  EXPECT_EQ(other.flags,
            wire::kInvertRightEncoder | wire::kInvertLeftMotor | wire::kInvertRightMotor)
      << "on a stand the gyro does not steer";
  EXPECT_EQ(other.turn_slip_share, 1.0F) << "turns are unknown until they are identified";
}

/// The firmware's verdict within three metres of its outer track, while the gyro measures the yaw
/// rate of the model for these track speeds and the left track counts that share of its edges.
firmware::TurnMonitor::Verdict found_in_turn(double left_mps, double right_mps, double counted) {
  bridge::Parameters parameters;
  parameters.model.wheelbase_m = 0.40;
  parameters.model.wheelbase_tight_m = 0.44;
  parameters.model.wheelbase_spin_m = 0.50;
  const wire::Parameters sent = session_settings(parameters).parameters;
  const double yaw_rate_radps =
      body_twist(parameters.model, model::Mode::kExtended, left_mps, right_mps, {}).yaw_rate_radps;
  const auto gyro_lsb = static_cast<std::int16_t>(
      std::lround(yaw_rate_radps / static_cast<double>(sent.gyro_z_radps_per_lsb)));
  firmware::TurnMonitor monitor;
  firmware::TurnHistory history;
  const double per_m = parameters.drive.counts_per_metre;
  const double duration_s = 3.0 / std::max(std::abs(left_mps), std::abs(right_mps));
  for (int i = 0; i * 0.005 < duration_s; ++i) {
    const double at_s = i * 0.005;
    history.add(static_cast<std::uint16_t>(i), static_cast<std::uint32_t>(i) * 5000U, gyro_lsb,
                static_cast<std::int32_t>(std::lround(left_mps * at_s * per_m * counted)),
                static_cast<std::int32_t>(std::lround(right_mps * at_s * per_m)));
    const auto verdict =
        monitor.update(history.newest(), 0, 0.0F, firmware::MonitorValues(sent), sent);
    if (verdict != firmware::TurnMonitor::kGood) return verdict;
  }
  return firmware::TurnMonitor::kGood;
}

TEST(Cycle, TheFirmwareKnowsTurnsAsTheModelDoesAndFindsLostCountsInThem) {
  for (const double right_mps : {0.04, 0.1, 0.2, -0.1}) {
    for (double ratio = -1.0; ratio <= 1.0; ratio += 0.05) {
      const double left_mps = right_mps * ratio;
      EXPECT_EQ(found_in_turn(left_mps, right_mps, 1.0), firmware::TurnMonitor::kGood)
          << left_mps << ' ' << right_mps;
      if (std::abs(ratio) < 0.7) continue;
      EXPECT_EQ(found_in_turn(left_mps, right_mps, 0.5), firmware::TurnMonitor::kLeftShort)
          << left_mps << ' ' << right_mps;
    }
  }
}

TEST(Cycle, AnswersSamplesWithCommandsAndAStopIsNeverCrowdedOut) {
  CycleRig rig;
  rig.run(600);
  ASSERT_GT(rig.robot.received.commands.size(), 50u);
  const wire::Command& command = rig.robot.received.commands.back();
  EXPECT_EQ(command.speed_mps, 0.0F);
  EXPECT_LE(static_cast<std::uint16_t>(rig.robot.sequence - command.answers), 4u);
  for (int i = 0; i < 40; ++i) rig.cycle.request(OperatorRequest::kHold);
  rig.cycle.request(OperatorRequest::kStop);
  rig.run(50);
  EXPECT_EQ(rig.robot.received.stops.size(), 1u);
}

std::shared_ptr<const course::Course> short_line(const std::string& name) {
  return std::make_shared<const course::Course>(course::parse_course(
      "speed_mps = 0.1\n[start]\nx_m = 0.5\n[[segment]]\ntype = \"line\"\nlength_m = 0.3\n"
      "[fence]\nmin_x_m = -1\nmax_x_m = 2\nmin_y_m = -1\nmax_y_m = 1\n",
      name));
}

TEST(Cycle, PlacesARobotThatStandsStillAndChangesTheCourseInTheSameSession) {
  CycleRig rig;
  rig.run(2000);
  SetupChange place{.place = Pose{.x_m = 0.2, .y_m = -0.5, .yaw_rad = 7.0}};
  ASSERT_TRUE(rig.cycle.change_setup(place, rig.now));
  rig.run(1000);
  EXPECT_EQ(rig.cycle.outputs().snapshot.start_refusal, StartRefusal::kNoCourse);
  for (const PoseSource source : kPoseSources) {
    const Pose& pose = rig.cycle.outputs().snapshot.estimates[source].pose;
    EXPECT_NEAR(pose.x_m, 0.2, 1e-6);
    EXPECT_NEAR(pose.y_m, -0.5, 1e-6);
    EXPECT_NEAR(pose.yaw_rad, 7.0, 1e-3) << "with all its turns";
  }
  SetupChange change;
  change.step.emplace(Parameters{}, short_line("a.toml"));
  ASSERT_TRUE(rig.cycle.change_setup(change, rig.now));
  rig.run(5);
  EXPECT_EQ(rig.cycle.inputs().restart.size(), 1u) << "a recording may begin here";
  rig.run(1000);
  EXPECT_EQ(rig.cycle.session().session_number(), 1u);
  EXPECT_EQ(rig.robot.received.parameters.size(), 1u);
  const Snapshot& snapshot = rig.cycle.outputs().snapshot;
  EXPECT_EQ(snapshot.start_refusal, StartRefusal::kNone);
  EXPECT_NEAR(snapshot.world.x_m, 0.2, 1e-6);
  rig.cycle.request(OperatorRequest::kStartPlaced);
  rig.run(300);
  EXPECT_EQ(snapshot.run_state, RunState::kRunning);
}

TEST(Cycle, ChangesNothingDuringARunOrWhileTheRobotMoves) {
  CycleRig rig;
  rig.run(2000);
  SetupChange change;
  change.step.emplace(Parameters{}, short_line("a.toml"));
  ASSERT_TRUE(rig.cycle.change_setup(change, rig.now));
  rig.run(1000);
  rig.cycle.request(OperatorRequest::kStartPlaced);
  SetupChange next{.place = Pose{}};
  rig.run(10);
  EXPECT_FALSE(rig.cycle.change_setup(next, rig.now)) << "arming";
  rig.run(500);
  ASSERT_EQ(rig.cycle.outputs().snapshot.run_state, RunState::kRunning);
  EXPECT_FALSE(rig.cycle.change_setup(next, rig.now)) << "running";
  rig.cycle.request(OperatorRequest::kHold);
  rig.robot.metres_per_s = 0.1;
  rig.run(1000);
  EXPECT_FALSE(rig.cycle.change_setup(next, rig.now)) << "pushed by hand";
  rig.robot.metres_per_s = 0.0;
  rig.run(1500);
  EXPECT_TRUE(rig.cycle.change_setup(next, rig.now));
}

TEST(Cycle, AnotherRobotsParametersReachTheRobotAndEndNothingThatIsLatched) {
  CycleRig rig;
  rig.run(2000);
  rig.cycle.request(OperatorRequest::kStop);
  rig.run(1000);
  Parameters other;
  other.model.wheelbase_m = 0.77;
  SetupChange change{.parameters = session_settings(other).parameters};
  change.step.emplace(other, nullptr);
  ASSERT_TRUE(rig.cycle.change_setup(change, rig.now));
  rig.run(1000);
  EXPECT_EQ(rig.cycle.session().state(), SessionState::kReady);
  ASSERT_EQ(rig.robot.received.parameters.size(), 2u);
  EXPECT_FLOAT_EQ(rig.robot.received.parameters[1].wheelbase_m, 0.77F);
  EXPECT_EQ(rig.cycle.outputs().snapshot.run_state, RunState::kAborted);
  EXPECT_NE(rig.cycle.outputs().snapshot.faults & fault_bit(Fault::stop_requested), 0u);
}

}  // namespace
}  // namespace tp100::bridge
