// `tp100d run` from its beginning to its end. Robots that behave oddly: tests/oddities.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "link/transport.h"
#include "run_rig.h"

namespace tp100::live {
namespace {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

TEST_F(Run, EndsWithStatus1WhenItsTimeIsOver) {
  options_.duration_s = 0.5;
  robot_->plug_in();
  EXPECT_EQ(run(), 1);
  EXPECT_THAT(stats(), HasSubstr("\"result\": \"duration\""));
}

TEST_F(Run, SigtermEndsItInEveryStateAndDisarms) {
  // There is no robot, or a silent one.
  options_.wait = true;
  for (const bool silent : {false, true}) {
    if (silent) robot_->plug_in();
    robot_->with([&](ScriptedRobot& robot) { robot.silent = silent; });
    std::filesystem::remove(options_.stats);
    EXPECT_EQ(run([&] { says_of_itself(silent ? "\"listening\"" : "\"closed\""); }), 1);
    EXPECT_FALSE(logged("-> ready")) << log_;
  }
  robot_->with([](ScriptedRobot& robot) { robot.silent = false; });
  // The daemon is ready.
  EXPECT_EQ(run([&] { eventually(commanded); }), 1);
  EXPECT_EQ(arms(), 0U);
  EXPECT_TRUE(robot_->with(disarmed));
  // The daemon is arming; the robot has not answered yet.
  options_.course = "1-straight";
  forget();
  robot_->with([](ScriptedRobot& robot) { robot.answers_requests = false; });
  EXPECT_EQ(run([&] {
              eventually([](const ScriptedRobot& robot) { return !robot.received.arms.empty(); });
              robot_->with([](ScriptedRobot& robot) { robot.answers_requests = true; });
            }),
            1);
  EXPECT_TRUE(robot_->with(disarmed));
  EXPECT_EQ(state(), wire::State::kDisarmed);
  // A run is under way, or has ended and the daemon waits for the next one.
  for (const bool stays : {false, true}) {
    options_.stay = stays;
    forget();
    EXPECT_EQ(run([&] {
                eventually(driven);
                if (!stays) return;
                eventually([](const ScriptedRobot& robot) {
                  return robot.received.commands.back().speed_mps == 0.0F;
                });
              }),
              1);
    EXPECT_TRUE(robot_->with(disarmed));
    EXPECT_EQ(state(), wire::State::kDisarmed);
    EXPECT_TRUE(!stays || logged("state: running -> aborted")) << log_;
  }
}

TEST_F(Run, APortThatComesLaterOrIsBusyForAWhileIsTaken) {
  options_.wait = true;
  EXPECT_EQ(run([&] {
              says_of_itself("\"closed\"");
              robot_->plug_in();
              eventually(commanded);
            }),
            1);
  EXPECT_TRUE(logged("state: closed -> listening") && logged("state: syncing -> ready")) << log_;
  forget();
  auto held = std::make_unique<link::Port>(link::open_port(port(), {}));
  EXPECT_EQ(run([&] {
              EXPECT_TRUE(soon([&] {
                return test::read_bytes("/proc/self/fd/2").find("port is busy") !=
                       std::string::npos;
              }));
              // The daemon tries again after 50, 150 and 350 ms.
              std::this_thread::sleep_for(500ms);
              held.reset();
              eventually(commanded);
            }),
            1);
  EXPECT_TRUE(logged("port is busy"));
  EXPECT_EQ(log_.find("port is busy"), log_.rfind("port is busy")) << "said once: " << log_;
}

TEST_F(Run, AStartThatCannotBeginIsRefusedAndNotKeptAndEndsARunWithGo) {
  options_.course = "1-straight";
  const auto carry = [&](double mps) {
    robot_->with([&](ScriptedRobot& robot) { robot.metres_per_s = mps; });
  };
  carry(0.1);
  robot_->plug_in();
  EXPECT_EQ(run([&] {
              says_of_itself("\"run\": \"arming\"");
              says_of_itself("\"run\": \"idle\"");
              carry(0.0);
              after_commands(400);
            }),
            1);
  EXPECT_TRUE(logged("start refused: the gyro is not still")) << log_;
  EXPECT_TRUE(logged("state: arming -> idle")) << log_;
  EXPECT_EQ(arms(), 0U);
  options_.go = true;
  carry(0.1);
  EXPECT_EQ(run(), 1) << "with --go it must not wait";
  EXPECT_THAT(stats(), HasSubstr("\"result\": \"refused\""));
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
              forget();
              viewer.call(server::Service::kStop);
              stopped = viewer.read_until("\"acknowledged\"");
              viewer.subscribe(messages::Channel::kState);
              viewer.read_until("\"can\":{\"start\":true");
              after_commands(40);
              // Commands alone never arm the robot again; only a start does.
              EXPECT_FALSE(received().stops.empty());
              EXPECT_EQ(arms(), 0U);
              viewer.call(server::Service::kStart);
              started = viewer.read_until("\"accepted\"");
              eventually([](const ScriptedRobot& robot) { return !robot.received.arms.empty(); });
            }),
            1);
  EXPECT_THAT(pose, HasSubstr("\"world\""));
  EXPECT_THAT(stopped, HasSubstr("\"acknowledged\":true"));
  EXPECT_THAT(started, HasSubstr("true"));
  EXPECT_TRUE(logged("stop acknowledged")) << log_;
}

}  // namespace
}  // namespace tp100::live
