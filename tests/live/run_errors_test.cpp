// Errors at the start of `tp100d run`: one line each, before anything moves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "link/transport.h"
#include "run_rig.h"

namespace tp100::live {
namespace {

using ::testing::HasSubstr;

TEST_F(Run, AMissingOrBusyPortIsAnErrorOfOneLine) {
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("robot: no such port"));
  EXPECT_EQ(log_, "");
  EXPECT_FALSE(std::filesystem::exists(options_.stats));
  robot_->plug_in();
  const link::Port held = link::open_port(port(), {});
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("port is busy"));
}

// Other robots that do not answer as they must: tests/oddities.
TEST_F(Run, ASilentRobotOrOneOfAnotherVersionIsAnErrorThatSaysWhatToDo) {
  robot_->with([](ScriptedRobot& robot) { robot.silent = true; });
  robot_->plug_in();
  EXPECT_EQ(run(), -1);
  EXPECT_THAT(message_, HasSubstr("no answer from a TP100"));
  robot_->with([](ScriptedRobot& robot) {
    robot.silent = false;
    robot.protocol = 77;
  });
  EXPECT_EQ(run(), -1);
  for (const char* part : {"robot has protocol 77", "needs protocol 1", "flash"})
    EXPECT_THAT(message_, HasSubstr(part));
  EXPECT_TRUE(received().types.empty());
}

TEST_F(Run, WhoIsAskedToWaitTakesARobotThatAnswersLater) {
  robot_->plug_in();
  robot_->with([](ScriptedRobot& robot) { robot.answers_parameters = false; });
  options_.wait = true;
  EXPECT_EQ(run([&] {
              says_of_itself("\"unanswered\": 1");
              robot_->with([](ScriptedRobot& robot) { robot.answers_parameters = true; });
              eventually(commanded);
            }),
            1);
  EXPECT_TRUE(logged("no answer from the robot (state parameters)")) << log_;
}

TEST_F(Run, BadOptionsAreErrors) {
  robot_->plug_in();
  const app::RunOptions good = options_;
  struct Case {
    std::string app::RunOptions::*option;
    std::string value;
    const char* says;
  };
  for (const Case& each :
       {Case{&app::RunOptions::listen, "203.0.113.1:8765", "--listen 203.0.113.1:8765"},
        {&app::RunOptions::stats, folder_.file("none/stats.json"), "stats.json: cannot be written"},
        {&app::RunOptions::setup, "moon", "use stand, flat or terrain"},
        {&app::RunOptions::course, "no-such", "no such course"}}) {
    options_ = good;
    options_.*each.option = each.value;
    EXPECT_EQ(run(), -1);
    EXPECT_THAT(message_, HasSubstr(each.says));
  }
}

}  // namespace
}  // namespace tp100::live
