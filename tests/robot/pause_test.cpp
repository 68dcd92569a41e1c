// Runs that a viewer pauses and resumes, in lockstep.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hand_driven.h"

namespace tp100::sim {
namespace {

/// A run on a course that is paused and resumed.
class PauseTest : public testing::Test {
 protected:
  PauseTest() {
    loaded_ = load({});
    loaded_.files.course = course::read_bundled(course::Bundled::kCourses, "1-curve");
    run_ = config::parse_run(loaded_.files);
  }
  void begin(HandDriven& drive) {
    ASSERT_TRUE(drive.wait_until_ready());
    drive.request(OperatorRequest::kStart);
    drive.step_until([&] { return drive.record().snapshot.progress_m > 0.2; }, 20.0);
    ASSERT_EQ(drive.state(), RunState::kRunning);
  }
  static double speed_mps(HandDriven& drive) { return drive.record().snapshot.command.speed_mps; }

  Loaded loaded_;
  config::RunSetup run_;
};

TEST_F(PauseTest, TheRobotSlowsDownOnThePathStandsArmedAndGoesOnToTheEnd) {
  HandDriven drive({.loaded = loaded_, .course = run_.course});
  begin(drive);
  drive.request(OperatorRequest::kPause);
  double last_mps = speed_mps(drive), largest_step_mps = 0.0;
  drive.after_step = [&](const StepRecord& record) {
    largest_step_mps =
        std::max(largest_step_mps, std::abs(last_mps - record.snapshot.command.speed_mps));
    last_mps = record.snapshot.command.speed_mps;
  };
  drive.step_for(2.0);
  drive.after_step = {};
  EXPECT_EQ(last_mps, 0.0);
  EXPECT_LT(largest_step_mps, 0.01) << "a ramp";
  const double stood_m = drive.record().snapshot.progress_m;
  drive.step_for(30.0);
  EXPECT_EQ(drive.state(), RunState::kRunning);
  EXPECT_EQ(drive.record().snapshot.sample.state, RobotState::kRunning) << "armed";
  EXPECT_NEAR(drive.record().snapshot.progress_m, stood_m, 0.002);
  EXPECT_NEAR(drive.record().snapshot.pause_left_s, 120.0 - 32.0, 0.1);
  drive.request(OperatorRequest::kResume);
  drive.step_until([&] { return drive.state() != RunState::kRunning; }, 120.0);
  EXPECT_EQ(drive.state(), RunState::kFinished) << "its time is without the pause";
  EXPECT_LT(std::abs(drive.record().snapshot.cross_track_m), 0.01);
}

TEST_F(PauseTest, ALongPauseEndsTheRunOnItsWay) {
  HandDriven drive({.loaded = loaded_, .course = run_.course});
  begin(drive);
  drive.request(OperatorRequest::kPause);
  drive.step_for(119.0);
  EXPECT_EQ(drive.state(), RunState::kRunning);
  drive.step_for(2.0);
  EXPECT_EQ(drive.state(), RunState::kIdle);
  EXPECT_FALSE(motors_on(drive.record().snapshot.sample));
  EXPECT_TRUE(may_go_on(drive.state(), drive.record().snapshot.progress_m, 10.0));
}

TEST_F(PauseTest, StopEndsAPausedRunAndNoResumeGoesOnWithIt) {
  HandDriven drive({.loaded = loaded_, .course = run_.course});
  drive.request(OperatorRequest::kPause);
  begin(drive);
  EXPECT_EQ(drive.record().snapshot.pause_left_s, 0.0) << "a pause needs a run";
  drive.request(OperatorRequest::kPause);
  drive.step_for(2.0);
  drive.request(OperatorRequest::kStop);
  drive.step_for(0.5);
  EXPECT_EQ(drive.state(), RunState::kAborted);
  drive.request(OperatorRequest::kResume);
  drive.step_for(0.5);
  EXPECT_EQ(drive.state(), RunState::kAborted);
  EXPECT_FALSE(motors_on(drive.record().snapshot.sample));
}

TEST_F(PauseTest, ATurnOnTheSpotIsPausedAndCompletedAfterwards) {
  loaded_.files.course.text =
      "[[segment]]\ntype = \"line\"\nlength_m = 0.21\n[[segment]]\ntype = \"pivot\"\n"
      "angle_deg = 90.0\n[[segment]]\ntype = \"line\"\nlength_m = 0.2\n"
      "[fence]\nmin_x_m = -1\nmax_x_m = 1\nmin_y_m = -1\nmax_y_m = 1\n";
  run_ = config::parse_run(loaded_.files);
  HandDriven drive({.loaded = loaded_, .course = run_.course});
  begin(drive);
  drive.step_until([&] { return drive.record().snapshot.world.yaw_rad > 0.5; }, 20.0);
  drive.request(OperatorRequest::kPause);
  drive.step_for(1.0);
  const double yaw_rad = drive.robot().truth().pose.yaw_rad;
  EXPECT_LT(yaw_rad, 1.2);
  drive.step_for(5.0);
  EXPECT_NEAR(drive.robot().truth().pose.yaw_rad, yaw_rad, 0.02);
  drive.request(OperatorRequest::kResume);
  drive.step_until([&] { return drive.state() != RunState::kRunning; }, 30.0);
  EXPECT_EQ(drive.state(), RunState::kFinished);
  EXPECT_NEAR(drive.robot().truth().pose.yaw_rad, 1.5708, 0.1);
}

}  // namespace
}  // namespace tp100::sim
