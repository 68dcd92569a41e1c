// `tp100d run` from its beginning, or an error of one line, to its end. Robots that behave oddly:
// tests/oddities.
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

TEST_F(Run, SigtermEndsItInEveryStateAndDisarms) {
  // There is no robot, or a silent one.
  options_.daemon.wait = true;
  for (const bool silent : {false, true}) {
    if (silent) robot_->plug_in();
    robot_->with([&](ScriptedRobot& robot) { robot.silent = silent; });
    std::filesystem::remove(options_.daemon.stats_path);
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
    options_.daemon.stay = stays;
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

TEST_F(Run, APortThatIsBusyForAWhileIsTaken) {
  options_.daemon.wait = true;
  robot_->plug_in();
  auto held = std::make_unique<link::Port>(link::open_port(port(), {}));
  EXPECT_EQ(run([&] {
              EXPECT_TRUE(test::eventually([&] {
                return test::read_bytes("/proc/self/fd/2").find("port is busy") !=
                       std::string::npos;
              }));
              // The daemon tries again after 50, 150 and 350 ms.
              std::this_thread::sleep_for(500ms);
              held.reset();
              eventually(commanded);
            }),
            1);
  EXPECT_EQ(log_.find("port is busy"), log_.rfind("port is busy")) << "said once: " << log_;
}

// Nobody may stand there any more who would start it again.
TEST_F(Run, WithGoAStartThatCannotBeginEndsTheRun) {
  options_.course = "1-straight";
  options_.daemon.go = true;
  robot_->with([](ScriptedRobot& robot) { robot.metres_per_s = 0.1; });
  robot_->plug_in();
  EXPECT_EQ(run(), 1);
  EXPECT_TRUE(logged("start refused: the gyro is not still")) << log_;
  EXPECT_THAT(stats(), HasSubstr("\"result\": \"refused\""));
  EXPECT_EQ(arms(), 0U);
}

TEST_F(Run, WhoIsAskedToWaitTakesARobotThatAnswersLater) {
  robot_->plug_in();
  robot_->with([](ScriptedRobot& robot) { robot.answers_parameters = false; });
  options_.daemon.wait = true;
  EXPECT_EQ(run([&] {
              says_of_itself("\"unanswered\": 1");
              robot_->with([](ScriptedRobot& robot) { robot.answers_parameters = true; });
              eventually(commanded);
            }),
            1);
  EXPECT_TRUE(logged("no answer from the robot (state parameters)")) << log_;
}

TEST_F(Run, FiguresThatCannotBeWrittenAreAnErrorAtOnce) {
  robot_->plug_in();
  options_.daemon.stats_path = folder_.file("none/stats.json");
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("stats.json: cannot be written"));
}

}  // namespace
}  // namespace tp100::live
