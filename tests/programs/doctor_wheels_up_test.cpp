// `tp100d doctor --wheels-up` on emulated robots with defects.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "doctor_rig.h"
#include "support/paths.h"

namespace tp100::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// The guided test, whose prompts are answered through a pipe.
class WheelsUp : public Doctor {
 protected:
  void SetUp() override {
    ASSERT_EQ(::mkfifo(fifo().c_str(), 0600), 0);
    answers_.open(fifo(), std::ios::in | std::ios::out);
  }
  std::string fifo() const { return folder_.file("answers"); }
  std::unique_ptr<Process> start(const std::string& robot = "end-loaded") const {
    return std::make_unique<Process>(std::vector<std::string>{
        "/bin/sh", "-c",
        "exec " + build_path("bin/tp100d") + " doctor --wheels-up --link-test 0" + " --port " +
            port() + " --robot " + robot + " < " + fifo()});
  }
  void answer(const std::string& line) { answers_ << line << std::endl; }
  /// A robot file in which the Boolean `key` is true, as for a robot that is wired that way.
  std::string miswired(const std::string& key) const {
    std::string text = read_bytes(source_path("config/robots/end-loaded.toml"));
    const std::size_t at = text.find("\n" + key + " = false");
    EXPECT_NE(at, std::string::npos) << key;
    text.replace(at, key.size() + 9, "\n" + key + " = true");
    write_bytes(folder_.file("miswired.toml"), text);
    return folder_.file("miswired.toml");
  }
  /// Output of the doctor for a robot on the floor whose robot file has `key` set wrongly.
  std::string verdict_of(const std::string& key) {
    start_robot({});
    const auto doctor = start(miswired(key));
    EXPECT_TRUE(doctor->wait_for("Press Enter to start")) << doctor->output();
    answer("");
    EXPECT_EQ(doctor->wait(), 1);
    return doctor->output();
  }

  /// Output of the doctor for a robot that fails before the end of the test.
  std::string broken_off() {
    const auto doctor = start();
    EXPECT_TRUE(doctor->wait_for("Press Enter to start")) << doctor->output();
    answer("");
    EXPECT_EQ(doctor->wait(), 1);
    EXPECT_THAT(doctor->output(), HasSubstr("error    wheels-up"));
    return doctor->output();
  }

  std::fstream answers_;
};

TEST_F(WheelsUp, MovesNothingBeforeEnterAndFindsAGoodRobotWell) {
  start_robot({});
  const auto doctor = start();
  ASSERT_TRUE(doctor->wait_for("Press Enter to start")) << doctor->output();
  expect_motors_never_on();
  answer("");
  EXPECT_EQ(doctor->wait(), 0) << doctor->output();
  EXPECT_THAT(doctor->output(),
              AllOf(HasSubstr("ok       left-track"), HasSubstr("ok       right-track"),
                    HasSubstr("ok       gyro")));
  EXPECT_TRUE(robot_->wait_for("motors off: disarm")) << robot_->output();
}

TEST_F(WheelsUp, NamesTheKeyOfAnEncoderThatCountsBackwards) {
  EXPECT_THAT(verdict_of("invert_left_encoder"),
              AllOf(HasSubstr("left encoder counts backwards"),
                    HasSubstr("set drive.invert_left_encoder = false")));
}

TEST_F(WheelsUp, NamesTheKeyOfAMotorThatRunsBackwards) {
  start_robot({});
  const auto doctor = start(miswired("invert_right_motor"));
  ASSERT_TRUE(doctor->wait_for("Press Enter to start")) << doctor->output();
  answer("");
  // When both tracks run forward, the robot does not turn: the operator has to say which track ran.
  ASSERT_TRUE(doctor->wait_for("What ran?")) << doctor->output();
  answer("");
  ASSERT_TRUE(doctor->wait_for("What ran?")) << doctor->output();
  answer("b");
  ASSERT_TRUE(doctor->wait_for("Hold the robot")) << doctor->output();
  answer("\n");
  EXPECT_EQ(doctor->wait(), 1);
  EXPECT_THAT(doctor->output(), AllOf(HasSubstr("right motor runs backwards"),
                                      HasSubstr("set drive.invert_right_motor = false")));
}

TEST_F(WheelsUp, NamesTheKeyOfTracksThatAreSwapped) {
  EXPECT_THAT(verdict_of("swap_tracks"), HasSubstr("set drive.swap_tracks = false"));
}

TEST_F(WheelsUp, OnAStandAsksWhatRanAndForATurnByHand) {
  start_robot({"--setup", "stand"});
  const auto doctor = start();
  ASSERT_TRUE(doctor->wait_for("Press Enter to start")) << doctor->output();
  answer("");
  ASSERT_TRUE(doctor->wait_for("What ran?")) << doctor->output();
  answer("perhaps");
  ASSERT_TRUE(doctor->wait_for("What ran?")) << doctor->output();
  answer("o");
  ASSERT_TRUE(doctor->wait_for("What ran?")) << doctor->output();
  answer("");
  ASSERT_TRUE(doctor->wait_for("Hold the robot")) << doctor->output();
  answer("\n");
  EXPECT_EQ(doctor->wait(), 1);
  // The robot is not turned by hand.
  EXPECT_THAT(doctor->output(),
              AllOf(HasSubstr("error    left-track"), HasSubstr("set drive.swap_tracks = true"),
                    HasSubstr("ok       right-track"), HasSubstr("error    gyro")));
}

TEST_F(WheelsUp, IsBrokenOffIfNobodyAnswers) {
  start_robot({});
  const Finished finished =
      run({"tp100d", "doctor", "--wheels-up", "--link-test", "0", "--port", port()});
  EXPECT_EQ(finished.status, 1);
  EXPECT_THAT(finished.output, HasSubstr("nobody pressed Enter, nothing moved"));
  expect_motors_never_on();
}

TEST_F(WheelsUp, IsNotTriedOnARobotWithErrors) {
  start_robot({"--fault", "battery:5.5"});
  const auto doctor = start();
  EXPECT_EQ(doctor->wait(), 1);
  EXPECT_THAT(doctor->output(), HasSubstr("note     wheels-up"));
}

TEST_F(WheelsUp, DisarmsFirstWhenItIsStopped) {
  start_robot({});
  const auto doctor = start();
  ASSERT_TRUE(doctor->wait_for("Press Enter to start")) << doctor->output();
  answer("");
  ASSERT_TRUE(robot_->wait_for("motors on")) << robot_->output();
  doctor->signal(SIGTERM);
  EXPECT_EQ(doctor->wait(), 1);
  EXPECT_THAT(doctor->output(), HasSubstr("error    wheels-up"));
  EXPECT_TRUE(robot_->wait_for("motors off: disarm")) << robot_->output();
  EXPECT_EQ(robot_->output().find("command_timeout"), std::string::npos) << robot_->output();
}

TEST_F(WheelsUp, IsBrokenOffIfTheRobotIsUnpluggedBeforeEnter) {
  start_robot({});
  const auto doctor = start();
  ASSERT_TRUE(doctor->wait_for("Press Enter to start")) << doctor->output();
  robot_->signal(SIGTERM);
  robot_->wait();
  answer("");
  EXPECT_EQ(doctor->wait(), 1);
  EXPECT_THAT(doctor->output(), HasSubstr("no such port"));
}

TEST_F(WheelsUp, IsBrokenOffIfTheRobotFellSilentBeforeEnter) {
  start_robot({});
  const auto doctor = start();
  ASSERT_TRUE(doctor->wait_for("Press Enter to start")) << doctor->output();
  robot_->signal(SIGTERM);
  robot_->wait();
  start_robot({"--fault", "cut:to-host"});
  answer("");
  EXPECT_EQ(doctor->wait(), 1);
  EXPECT_THAT(doctor->output(), HasSubstr("no session with the robot"));
}

TEST_F(WheelsUp, IsBrokenOffByAFault) {
  start_robot({"--fault", "battery:5.5@1.5"});
  EXPECT_THAT(broken_off(), AllOf(HasSubstr("the robot stopped by itself: the battery is below"),
                                  HasSubstr("fix: charge the battery")));
}

TEST_F(WheelsUp, IsBrokenOffByAFaultThatForbidsArming) {
  // The fault occurs some time after the prompt. Its time is on the board's clock, which begins
  // when the port is opened.
  start_robot({"--setup", "stand", "--fault", "battery:5.5@8.5"});
  const auto doctor = start();
  ASSERT_TRUE(doctor->wait_for("Press Enter to start")) << doctor->output();
  ASSERT_TRUE(robot_->wait_for("port closed")) << robot_->output();
  answer("");
  ASSERT_TRUE(robot_->wait_for("port opened, board resets")) << robot_->output();
  const auto opened = std::chrono::steady_clock::now();
  ASSERT_TRUE(doctor->wait_for("What ran?")) << doctor->output();
  std::this_thread::sleep_until(opened + std::chrono::milliseconds(9'500));
  answer("");
  EXPECT_EQ(doctor->wait(), 1);
  EXPECT_THAT(doctor->output(), AllOf(HasSubstr("the robot cannot be armed: the battery is below"),
                                      HasSubstr("fix: charge the battery")));
}

TEST_F(WheelsUp, IsBrokenOffIfTheRobotFallsSilent) {
  start_robot({"--fault", "cut:to-host@2"});
  EXPECT_THAT(broken_off(), HasSubstr(port() + ": the robot fell silent"));
}

TEST_F(WheelsUp, IsBrokenOffByARestartOfTheBoard) {
  start_robot({"--fault", "reboot@2"});
  EXPECT_THAT(broken_off(), HasSubstr("the board restarted while a track ran"));
}

TEST_F(WheelsUp, IsBrokenOffIfThePortGoes) {
  start_robot({"--fault", "unplug:1@2"});
  EXPECT_THAT(broken_off(), HasSubstr(port() + ": port is gone"));
}

}  // namespace
}  // namespace tp100::test
