// Driving an emulated robot by hand in lockstep, from a viewer's request to the wire.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/commands.h"
#include "dead_man.h"
#include "fence_runs.h"
#include "record/recording.h"
#include "sim/robot/lockstep_recorder.h"
#include "support/temporary_folder.h"

namespace tp100::sim {
namespace {

using ::testing::HasSubstr;

constexpr std::uint32_t kA = 1;

class HandDriveTest : public ::testing::Test {
 protected:
  /// The robot is driven forwards by viewer A for a while.
  std::string drive_off(HandDriven& drive, double speed_mps = 0.1) {
    EXPECT_TRUE(drive.wait_until_ready());
    const std::string token = drive.take(kA);
    EXPECT_EQ(drive.state(), RunState::kDriving) << token;
    drive.before_step = [&drive, token, speed_mps](HostNs) {
      drive.drive(kA, token, speed_mps, 0.0);
    };
    drive.step_for(1.0);
    return token;
  }
};

/// A person at the terminal of a robot on a port, who is told of each change.
class AtTheTerminal : public HandDriven {
 public:
  using HandDriven::HandDriven;
  void type(const std::string& line) { terminal_.take(line, now()); }
  std::string told;

 private:
  void said(const std::string& line) override { told = line; }
  void happened(const live::LiveEvent& event) override {
    if (const auto* change = std::get_if<live::RunChange>(&event)) terminal_.follow(change->to);
    if (const auto* report = std::get_if<live::SessionReport>(&event))
      if (const auto* changed = link::as<link::StateChanged>(report->event))
        terminal_.follow(changed->to);
    terminal_.ask(now());
  }
};

// Whoever presses Enter to stop a robot that has just stopped by itself must not start it again.
TEST(Terminal, AfterTheFirstRunEnterIsSTOPAndOnlyTheWordStarts) {
  const auto course = std::make_shared<const course::Course>(load_course("1-straight"));
  AtTheTerminal person({.loaded = load({}), .course = course});
  person.type("");
  EXPECT_THAT(person.told, HasSubstr("no robot is connected"));
  ASSERT_TRUE(person.wait_until_ready());
  EXPECT_EQ(person.state(), RunState::kIdle) << "what was typed before the robot came";
  const auto runs = [&] { return person.state() == RunState::kRunning; };
  person.type("");
  EXPECT_TRUE(person.step_until(runs, 5.0)) << person.told;
  person.request(OperatorRequest::kHold);
  person.step_for(1.0);
  const std::uint64_t stops = person.controls().stop_count();
  person.type("");
  EXPECT_EQ(person.controls().stop_count(), stops + 1);
  EXPECT_FALSE(person.step_until(runs, 3.0));
  person.type("go");
  EXPECT_TRUE(person.step_until(runs, 5.0)) << person.told;
}

// Neither an input without the lease, nor one that bypasses all earlier checks, nor velocities that
// are streamed.
TEST_F(HandDriveTest, AnInputAloneNeverArms) {
  HandDriven drive({.loaded = load({})});
  ASSERT_TRUE(drive.wait_until_ready());
  EXPECT_TRUE(drive.drive(kA, "", 0.1, 0.0).contains("refused"));
  EXPECT_TRUE(drive.drive(kA, "0123", 0.1, 0.0).contains("refused"));
  drive.before_step = [&](HostNs) {
    static_cast<void>(drive.controls().drive({"", 0.1, 0.0, 0.0}, drive.now()));
    drive.receive_velocity(0.1, 0.2);
  };
  drive.step_for(1.0);
  EXPECT_EQ(drive.state(), RunState::kIdle);
  EXPECT_FALSE(motors_on(drive.record().snapshot.sample));
  EXPECT_THAT(drive.take_messages(), HasSubstr("send true on /tp100/drive"));
}

TEST_F(HandDriveTest, ARunIsNotTakenOverAndGoesOnOnlyFromNearWhereItEnded) {
  const auto course = std::make_shared<const course::Course>(load_course("1-straight"));
  HandDriven drive({.loaded = load({}), .course = course});
  ASSERT_TRUE(drive.wait_until_ready());
  drive.request(OperatorRequest::kStart);
  drive.step_until([&] { return drive.record().snapshot.progress_m > 0.05; }, 5.0);
  EXPECT_EQ(drive.call(kA, "drive_take").value("refused", ""),
            std::string(to_string(StartRefusal::kUnderWay)));
  drive.call(kA, "hold");
  drive.step_for(0.5);
  const std::string token = drive_off(drive, -0.02);
  drive.disconnect(kA);
  drive.before_step = {};
  drive.step_for(3.0);
  const auto places = [&] { return drive.record().snapshot.start_places; };
  EXPECT_EQ(places().unsaid, StartRefusal::kWhere) << "driven by hand";
  EXPECT_EQ(places().here, StartRefusal::kNone) << "still on its path";
  EXPECT_NEAR(drive.record().snapshot.onward_m, drive.record().snapshot.world.x_m, 1e-6);
  const std::string again = drive_off(drive, 0.0);
  drive.before_step = [&](HostNs) { drive.drive(kA, again, 0.0, 1.0); };
  drive.step_for(2.0);
  drive.before_step = [&](HostNs) { drive.drive(kA, again, 0.15, 0.0); };
  drive.step_for(3.0);
  drive.disconnect(kA);
  drive.before_step = {};
  drive.step_for(3.0);
  EXPECT_EQ(places().here, StartRefusal::kOffPath) << "too far from its path";
}

class DeadMan : public ::testing::TestWithParam<
                    std::tuple<std::pair<Client, const char*>, std::pair<Loss, const char*>>> {};

TEST_P(DeadMan, StopsTheRobotAtOnceOrWhenTheLastInputIsOld) {
  const Loss loss = std::get<1>(GetParam()).first;
  const LossTimes times = lose_driver(loss, 10, 1, std::get<0>(GetParam()).first);
  EXPECT_EQ(times.wrong, "");
  ASSERT_EQ(times.command_ms.size(), 10U);
  // At most eight steps lie between two inputs.
  EXPECT_LE(*std::max_element(times.command_ms.begin(), times.command_ms.end()),
            is_heard(loss) ? 50.0 : 160.0);
}

INSTANTIATE_TEST_SUITE_P(Losses, DeadMan,
                         ::testing::Combine(::testing::ValuesIn(kClients),
                                            ::testing::ValuesIn(kLosses)),
                         [](const auto& tested) {
                           std::string name = std::string(std::get<0>(tested.param).second) + "_" +
                                              std::get<1>(tested.param).second;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

TEST_F(HandDriveTest, ASecondWriterOfVelocitiesIsIgnored) {
  HandDriven drive({.loaded = load({})});
  ASSERT_TRUE(drive.wait_until_ready());
  drive.take_by_ros2();
  drive.before_step = [&](HostNs) {
    drive.receive_velocity(0.1, 0.0, 0.0, 1);
    drive.receive_velocity(-0.1, 0.0, 0.0, 2);
    drive.receive_velocity(-0.1, 0.0, 0.0, 1, true);
  };
  drive.after_step = [&](const StepRecord& record) {
    EXPECT_GE(record.snapshot.command.speed_mps, 0.0);
  };
  drive.step_for(0.5);
  EXPECT_GT(drive.record().snapshot.command.speed_mps, 0.0);
  EXPECT_THAT(drive.take_messages(), HasSubstr("second writer"));
  // It does not continue for the first driver either, which is lost.
  drive.before_step = [&](HostNs) { drive.receive_velocity(0.1, 0.0, 0.0, 2); };
  drive.step_for(0.3);
  EXPECT_TRUE(asks_for_standstill(drive.record()));
}

TEST_F(HandDriveTest, NoSequenceOfCommandsTakesTheCentreOutOfTheFence) {
  double driven_m = 0.0, at_fence_s = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const FenceRun run = drive_in_fence(seed, 12.0);
    EXPECT_LE(run.outside_m, 0.03) << "seed " << seed << ", " << run.what;
    EXPECT_LE(run.estimated_outside_m, 0.0) << "seed " << seed << ", " << run.what;
    EXPECT_EQ(run.end, RunState::kDriving) << "seed " << seed << ", " << run.what;
    driven_m += run.driven_m;
    at_fence_s += run.at_fence_s;
  }
  EXPECT_GT(driven_m, 4.0) << "the robot must really be driven";
  EXPECT_GT(at_fence_s, 6.0) << "... and against the fence";
}

// Nav2 turns a robot for hours; it would stop for ever after 159 turns one way.
TEST_F(HandDriveTest, ARobotThatHasTurnedOftenIsDrivenAsEver) {
  auto course = std::make_shared<course::Course>(load_course("1-straight"));
  for (const double yaw_rad : {0.0, 98.0, 998.0, 5e4}) {
    for (const double sign : {-1.0, 1.0}) {
      course->start.yaw_rad = sign * yaw_rad;
      HandDriven drive({.loaded = load({}), .course = course});
      const std::string token = drive_off(drive, 0.0);
      const double from_rad = drive.robot().truth().pose.yaw_rad;
      drive.before_step = [&](HostNs) { drive.drive(kA, token, 0.0, sign * 0.8); };
      drive.step_for(6.0);
      EXPECT_EQ(drive.state(), RunState::kDriving);
      EXPECT_NEAR(drive.robot().truth().pose.yaw_rad - from_rad, sign * 4.5, 0.5) << sign * yaw_rad;
    }
  }
}

// Its path and its end: whole_runs_test.
TEST_F(HandDriveTest, APausedRunStandsArmedForTwoMinutesAtMost) {
  const auto course = std::make_shared<const course::Course>(load_course("1-curve"));
  HandDriven drive({.loaded = load({}), .course = course});
  ASSERT_TRUE(drive.wait_until_ready());
  drive.request(OperatorRequest::kPause);
  drive.step_for(0.1);
  drive.request(OperatorRequest::kStart);
  ASSERT_TRUE(drive.step_until([&] { return drive.record().snapshot.progress_m > 0.2; }, 20.0));
  EXPECT_EQ(drive.record().snapshot.pause_left_s, 0.0) << "a pause needs a run";
  drive.request(OperatorRequest::kPause);
  double last_mps = drive.record().snapshot.command.speed_mps;
  drive.after_step = [&](const StepRecord& record) {
    EXPECT_NEAR(record.snapshot.command.speed_mps, last_mps, 0.01) << "a ramp";
    last_mps = record.snapshot.command.speed_mps;
  };
  drive.step_for(2.0);
  EXPECT_EQ(last_mps, 0.0);
  drive.step_for(117.0);
  EXPECT_EQ(drive.state(), RunState::kRunning);
  EXPECT_EQ(drive.record().snapshot.sample.state, RobotState::kRunning) << "armed";
  EXPECT_NEAR(drive.record().snapshot.pause_left_s, 1.0, 0.1);
  drive.step_for(2.0);
  EXPECT_EQ(drive.state(), RunState::kIdle);
  EXPECT_FALSE(motors_on(drive.record().snapshot.sample));
}

TEST_F(HandDriveTest, ADriveAndAPausedRunReplayBitForBit) {
  const test::TemporaryFolder folder;
  Loaded loaded = load({});
  loaded.files.course = course::read_bundled(course::Bundled::kCourses, "1-curve");
  const config::RunSetup run = config::parse_run(loaded.files);
  LockstepRecorder recorder(folder.path().string(), loaded, 1);
  HandDriven drive({.loaded = loaded, .course = run.course, .sink = &recorder});
  const std::string token = drive_off(drive);
  drive.before_step = [&](HostNs) { drive.drive(kA, token, -0.07, 0.4); };
  drive.step_for(4.0);
  drive.disconnect(kA);
  drive.before_step = {};
  drive.step_for(3.0);
  ASSERT_TRUE(drive.wait_until_ready());
  drive.request(OperatorRequest::kStartPlaced);
  drive.step_until([&] { return drive.record().snapshot.progress_m > 0.2; }, 20.0);
  drive.request(OperatorRequest::kPause);
  drive.step_for(3.0);
  drive.request(OperatorRequest::kResume);
  drive.step_for(3.0);
  recorder.finish();

  const record::Recording recording(recorder.path());
  std::size_t inputs = 0, driven = 0, paused = 0, running = 0;
  const app::Replayed replayed =
      app::replay_steps(recording, run.parameters, run.course, true, [&](const StepRecord& record) {
        inputs += record.inputs.velocities.size();
        driven += record.snapshot.run_state == RunState::kDriving ? 1 : 0;
        running += record.snapshot.run_state == RunState::kRunning ? 1 : 0;
        paused += record.snapshot.pause_left_s > 0.0 ? 1 : 0;
      });
  EXPECT_FALSE(replayed.differs_at) << *replayed.differs_at << " " << replayed.difference.field;
  EXPECT_GT(inputs, 500U);
  EXPECT_GT(driven, 600U);
  EXPECT_NEAR(static_cast<double>(paused), 600.0, 5.0);
  EXPECT_GT(running, 1200U);
}

}  // namespace
}  // namespace tp100::sim
