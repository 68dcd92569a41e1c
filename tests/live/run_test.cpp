// Tests of `tp100d run` against a scripted robot on a pty, both in this process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "../server/web_client.h"
#include "link/transport.h"
#include "run_rig.h"
#include "server/services.h"

namespace tp100::live {
namespace {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

TEST_F(Run, WaitsForAPortThatComesLater) {
  options_.wait = true;
  EXPECT_EQ(run([&] {
              says_of_itself("\"closed\"");
              robot_->plug_in();
              eventually(commanded);
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("state: closed -> listening"));
  EXPECT_THAT(log_, HasSubstr("state: syncing -> ready"));
}

TEST_F(Run, EndsWithStatus1WhenItsTimeIsOver) {
  options_.duration_s = 0.5;
  robot_->plug_in();
  EXPECT_EQ(run(), 1);
  EXPECT_THAT(stats(), HasSubstr("\"result\": \"duration\""));
}

TEST_F(Run, SigtermDisarmsFirst) {
  options_.course = "1-straight";
  robot_->plug_in();
  EXPECT_EQ(run([&] { eventually(driven); }), 1);
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return !robot.received.disarms.empty(); }));
  EXPECT_EQ(robot_->with([](ScriptedRobot& robot) { return robot.state; }), wire::State::kDisarmed);
  EXPECT_THAT(log_, HasSubstr("state: idle -> arming"));
  EXPECT_THAT(log_, HasSubstr("state: arming -> running"));
}

TEST_F(Run, SigtermEndsItInEveryState) {
  // There is no robot, or a silent one.
  options_.wait = true;
  for (const bool silent : {false, true}) {
    if (silent) robot_->plug_in();
    robot_->with([&](ScriptedRobot& robot) { robot.silent = silent; });
    std::filesystem::remove(stats_path());
    EXPECT_EQ(run([&] { says_of_itself(silent ? "\"listening\"" : "\"closed\""); }), 1);
    EXPECT_EQ(log_.find("-> ready"), std::string::npos) << log_;
  }
  robot_->with([](ScriptedRobot& robot) { robot.silent = false; });
  // The daemon is ready.
  EXPECT_EQ(run([&] { eventually(commanded); }), 1);
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.received.arms.empty(); }));
  EXPECT_FALSE(robot_->with([](ScriptedRobot& robot) { return robot.received.disarms.empty(); }));
  // The daemon is arming; the robot has not answered yet.
  options_.course = "1-straight";
  robot_->with([](ScriptedRobot& robot) {
    robot.received = {};
    robot.answers_requests = false;
  });
  EXPECT_EQ(run([&] {
              eventually([](const ScriptedRobot& robot) { return !robot.received.arms.empty(); });
              robot_->with([](ScriptedRobot& robot) { robot.answers_requests = true; });
            }),
            1);
  EXPECT_FALSE(robot_->with([](ScriptedRobot& robot) { return robot.received.disarms.empty(); }));
  EXPECT_EQ(robot_->with([](ScriptedRobot& robot) { return robot.state; }), wire::State::kDisarmed);
  // A run has ended; the daemon waits for the next one.
  options_.stay = true;
  EXPECT_EQ(run([&] {
              eventually(driven);
              eventually([](const ScriptedRobot& robot) {
                return robot.received.commands.back().speed_mps == 0.0F;
              });
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("state: running -> aborted"));
  EXPECT_EQ(robot_->with([](ScriptedRobot& robot) { return robot.state; }), wire::State::kDisarmed);
}

TEST_F(Run, APortThatIsRefusedAgainAndAgainIsTakenOnceItIsFree) {
  options_.wait = true;
  robot_->plug_in();
  auto held = std::make_unique<link::Port>(link::open_port(port().string(), {}));
  EXPECT_EQ(
      run([&] {
        EXPECT_TRUE(soon([&] { return log_so_far().find("port is busy") != std::string::npos; }));
        // The daemon tries again after 50, 150 and 350 ms.
        std::this_thread::sleep_for(500ms);
        held.reset();
        eventually(commanded);
      }),
      1);
  EXPECT_THAT(log_, HasSubstr("port is busy"));
  EXPECT_EQ(log_.find("port is busy"), log_.rfind("port is busy"))
      << "the message must appear once: " << log_;
  EXPECT_THAT(log_, HasSubstr("state: syncing -> ready"));
}

TEST_F(Run, ARobotThatNeverMovesAbortsTheRun) {
  options_.course = "1-straight";
  robot_->plug_in();
  EXPECT_EQ(run(), 1);
  EXPECT_THAT(log_, HasSubstr("state: running -> aborted"));
  EXPECT_THAT(stats(), HasSubstr("\"result\": \"aborted\""));
}

TEST_F(Run, MotorsThatAreOnUnaskedAreStoppedAndEndIt) {
  robot_->plug_in();
  for (const bool obeys : {true, false}) {
    robot_->with([&](ScriptedRobot& robot) {
      robot.received = {};
      robot.answers_requests = obeys;
      if (robot.state == wire::State::kRunning) robot.state = wire::State::kDisarmed;
    });
    std::thread oddity([&] {
      eventually(commanded);
      robot_->with([](ScriptedRobot& robot) { robot.state = wire::State::kRunning; });
    });
    EXPECT_EQ(run(), 1);
    oddity.join();
    EXPECT_THAT(log_, HasSubstr("moves_unasked"));
    EXPECT_THAT(stats(), HasSubstr("moves_unasked"));
    robot_->with([](ScriptedRobot& robot) { EXPECT_FALSE(robot.received.stops.empty()); });
  }
}

TEST_F(Run, WhoStaysStopsMotorsThatComeOnAgainAndAgain) {
  options_.stay = true;
  robot_->plug_in();
  EXPECT_EQ(run([&] {
              eventually(commanded);
              // The robot acknowledges the stop but keeps its motors on.
              EXPECT_TRUE(soon([&] {
                return robot_->with([](ScriptedRobot& robot) {
                  robot.state = wire::State::kRunning;
                  return robot.received.stops.size() > 4;
                });
              }));
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("moves_unasked"));
}

TEST_F(Run, NoMotionFollowsAnArmThatWasNotAccepted) {
  options_.course = "1-straight";
  robot_->plug_in();
  for (const bool refuses : {true, false}) {
    robot_->with([&](ScriptedRobot& robot) {
      robot.received = {};
      robot.arms_anyway = true;
      robot.answers_arms = refuses;
      if (refuses) robot.arm_result = wire::Result::kOutOfRange;
    });
    EXPECT_EQ(run(), 1);
    EXPECT_THAT(log_, HasSubstr("not_acknowledged"));
    EXPECT_THAT(log_, HasSubstr(refuses ? "arm refused by the robot: its expiry is out of range"
                                        : "arm not acknowledged"));
    EXPECT_EQ(log_.find("counts_per_metre"), std::string::npos);
    EXPECT_EQ(log_.find("-> running"), std::string::npos);
    robot_->with([](ScriptedRobot& robot) {
      EXPECT_FALSE(robot.received.arms.empty());
      EXPECT_FALSE(robot.received.disarms.empty());
      EXPECT_EQ(robot.state, wire::State::kDisarmed);
      for (const wire::Command& command : robot.received.commands)
        ASSERT_EQ(command.speed_mps, 0.0F);
    });
  }
}

TEST_F(Run, AStartThatCannotBeginIsRefusedAndNotKept) {
  options_.course = "1-straight";
  // The robot is held by hand and its tracks turn.
  robot_->with([](ScriptedRobot& robot) { robot.metres_per_s = 0.1; });
  robot_->plug_in();
  EXPECT_EQ(run([&] {
              says_of_itself("\"run\": \"arming\"");
              says_of_itself("\"run\": \"idle\"");
              // The robot is put down.
              robot_->with([](ScriptedRobot& robot) { robot.metres_per_s = 0.0; });
              commanded_again(400);
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("start refused: the gyro is not still"));
  EXPECT_THAT(log_, HasSubstr("state: arming -> idle"));
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.received.arms.empty(); }));
  options_.go = true;
  robot_->with([](ScriptedRobot& robot) { robot.metres_per_s = 0.1; });
  EXPECT_EQ(run(), 1) << "with --go it must not wait";
  EXPECT_THAT(stats(), HasSubstr("\"result\": \"refused\""));
}

TEST_F(Run, ACourseIsCompletedOnceTheRobotHasConfirmedItsEnd) {
  std::ofstream(folder_.path() / "short.toml")
      << "speed_mps = 0.1\n[[segment]]\ntype = \"line\"\nlength_m = 0.1\n"
         "[fence]\nmin_x_m = -1.0\nmax_x_m = 1.0\nmin_y_m = -1.0\nmax_y_m = 1.0\n";
  options_.course = folder_.file("short.toml");
  options_.setup = "stand";
  options_.go = true;
  robot_->plug_in();
  for (const bool confirms : {true, false}) {
    int status = -1;
    // On a busy machine the robot may not be scheduled for 200 ms, which ends the run early; the
    // test then tries again.
    for (int i = 0; i < 10 && log_.find("running -> finished") == std::string::npos; ++i) {
      robot_->with([&](ScriptedRobot& robot) {
        robot.drives = true;
        robot.received = {};
        robot.answers_requests = true;
      });
      std::atomic<bool> over{false};
      std::thread deaf([&] {
        soon([&] { return over || robot_->with(driven); });
        robot_->with([&](ScriptedRobot& robot) { robot.answers_requests = confirms; });
      });
      status = run();
      over = true;
      deaf.join();
    }
    EXPECT_EQ(status, confirms ? 0 : 1) << log_;
    EXPECT_THAT(log_, HasSubstr("state: running -> finished"));
    EXPECT_THAT(stats(),
                HasSubstr(confirms ? "\"result\": \"completed\"" : "\"result\": \"aborted\""));
    EXPECT_EQ(log_.find("not_acknowledged") == std::string::npos, confirms) << log_;
    log_.clear();
  }
}

TEST_F(Run, AFaultReportBeyondTheRobotsBitsIsNotTheDaemons) {
  robot_->plug_in();
  EXPECT_EQ(
      run([&] {
        eventually(commanded);
        robot_->with([](ScriptedRobot& robot) {
          robot.received = {};
          robot.send(wire::FaultReport{.device_us = 0, .fault = 29, .faults = 0, .detail = 0});
        });
        eventually(commanded);
      }),
      1);
  EXPECT_THAT(log_, HasSubstr("robot fault unknown (29)"));
  EXPECT_EQ(log_.find("immobilised"), std::string::npos);
}

TEST_F(Run, AViewerWatchesStopsAndStartsAgain) {
  options_.course = "1-straight";
  options_.stay = true;
  robot_->plug_in();
  std::string pose, stopped, started;
  EXPECT_EQ(run([&] {
              eventually(driven);
              server::WebClient viewer(page());
              viewer.subscribe(messages::pose_channel(PoseSource::kOdometry));
              pose = viewer.read_until("\"frame_id\"");
              robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
              viewer.call(server::Service::kStop);
              stopped = viewer.read_until("\"acknowledged\"");
              viewer.subscribe(messages::Channel::kState);
              viewer.read_until("\"can\":{\"start\":true");
              commanded_again(40);
              // Commands alone never arm the robot again; only a start does.
              EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) {
                return !robot.received.stops.empty() && robot.received.arms.empty();
              }));
              viewer.call(server::Service::kStart);
              started = viewer.read_until("\"accepted\"");
              eventually([](const ScriptedRobot& robot) { return !robot.received.arms.empty(); });
            }),
            1);
  EXPECT_THAT(pose, HasSubstr("\"world\""));
  EXPECT_THAT(stopped, HasSubstr("\"acknowledged\":true"));
  EXPECT_THAT(started, HasSubstr("true"));
  EXPECT_THAT(log_, HasSubstr("stop acknowledged"));
}

}  // namespace
}  // namespace tp100::live
