// Errors at the start of `tp100d run`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "link/transport.h"
#include "run_rig.h"

namespace tp100::live {
namespace {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

TEST_F(Run, AMissingPortIsAnErrorOfOneLine) {
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("robot: no such port"));
  EXPECT_EQ(log_, "");
  EXPECT_FALSE(std::filesystem::exists(stats_path()));
}

TEST_F(Run, ABusyPortIsAnErrorOfOneLine) {
  robot_->plug_in();
  const link::Port held = link::open_port(port().string(), {});
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("port is busy"));
}

TEST_F(Run, ASilentPortIsAnErrorUnlessAskedToWait) {
  robot_->plug_in();
  robot_->with([](ScriptedRobot& robot) { robot.silent = true; });
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("no answer from a TP100"));
}

TEST_F(Run, FramesWithoutAHelloAreAnErrorUnlessAskedToWait) {
  robot_->plug_in();
  robot_->with([](ScriptedRobot& robot) { robot.silent = true; });
  std::atomic<bool> over{false};
  std::thread chatter([&] {
    while (!over) {
      robot_->with([](ScriptedRobot& robot) { robot.send(wire::Log{}); });
      std::this_thread::sleep_for(10ms);
    }
  });
  EXPECT_EQ(run(), -1);
  over = true;
  chatter.join();
  EXPECT_THAT(message_, HasSubstr("but no hello"));
}

TEST_F(Run, ARobotThatSpeaksAndHearsNothingIsAnErrorUnlessAskedToWait) {
  robot_->plug_in();
  robot_->with([](ScriptedRobot& robot) { robot.answers_parameters = false; });
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("sends hello but receives nothing; check cable"));
  options_.wait = true;
  EXPECT_EQ(run([&] {
              says_of_itself("\"unanswered\": 1");
              robot_->with([](ScriptedRobot& robot) { robot.answers_parameters = true; });
              eventually(commanded);
            }),
            1);
  EXPECT_THAT(log_, HasSubstr("no answer from the robot (state parameters)"));
}

TEST_F(Run, AWrongVersionIsRefusedWithBothVersions) {
  robot_->plug_in();
  robot_->with([](ScriptedRobot& robot) { robot.protocol = 77; });
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("robot has protocol 77"));
  EXPECT_THAT(message_, HasSubstr("needs protocol 1"));
  EXPECT_THAT(message_, HasSubstr("flash"));
  EXPECT_TRUE(robot_->with([](ScriptedRobot& robot) { return robot.received.types.empty(); }));
}

TEST_F(Run, AHelloWithoutABootNumberIsAnErrorOfOneLine) {
  robot_->plug_in();
  robot_->with([](ScriptedRobot& robot) { robot.boot_nonce = 0; });
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("its boot number is 0; flash the board"));
}

TEST_F(Run, APageThatCannotBeServedIsAnErrorOfOneLine) {
  robot_->plug_in();
  options_.listen = "203.0.113.1:8765";
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("--listen 203.0.113.1:8765"));
}

TEST_F(Run, AStatsFileThatCannotBeWrittenIsAnError) {
  robot_->plug_in();
  options_.stats = (folder_.path() / "none" / "stats.json").string();
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("stats.json: cannot be written"));
}

TEST_F(Run, BadOptionsAreErrors) {
  options_.setup = "moon";
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("use stand, flat or terrain"));
  options_.setup = "stand";
  options_.course = "no-such";
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("no such course"));
}

}  // namespace
}  // namespace tp100::live
