// `tp100d doctor` on emulated robots with defects: the real programs, connected by a
// pseudo-terminal.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "process.h"
#include "support/paths.h"

namespace tp100::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Doctor : public testing::Test {
 protected:
  std::string port() const { return folder_.file("tp100"); }
  /// Starts a robot with the further arguments `more`.
  void start_robot(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"tp100-sim", "robot", "--link", port()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    robot_ = std::make_unique<Process>(arguments);
    ASSERT_TRUE(robot_->wait_for("linked from")) << robot_->output();
  }
  void expect_motors_never_on() {
    EXPECT_THAT(robot_->output(), Not(AnyOf(HasSubstr("motors on"), HasSubstr("motors off"))));
  }
  /// Result of the doctor. `status` is -1 if it printed no JSON.
  struct Examined {
    int status = -1;
    json report;
    /// The first finding of that name; null if there is none.
    json finding(const std::string& name) const {
      for (const json& row : report.at("findings")) {
        if (row.at("name") == name) return row;
      }
      return nullptr;
    }
    /// "SEVERITY NAME: SEEN; FIX".
    std::string line(const std::string& name) const {
      const json row = finding(name);
      if (row.is_null()) return report.dump();
      return row.at("severity").get<std::string>() + " " + name + ": " +
             row.at("seen").get<std::string>() + "; " + row.at("fix").get<std::string>();
    }
  };
  Examined examine(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"tp100d", "doctor", "--json", "--port", port()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished finished = run(arguments);
    const json report = json::parse(finished.output, nullptr, false);
    EXPECT_FALSE(report.is_discarded()) << finished.output;
    return {report.is_discarded() ? -1 : finished.status, report};
  }

  TemporaryFolder folder_;
  std::unique_ptr<Process> robot_;
};

TEST_F(Doctor, FindsNothingThatKeepsAGoodRobotFromDriving) {
  start_robot({});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 0) << examined.report.dump();
  EXPECT_EQ(examined.report.at("errors"), 0);
  EXPECT_THAT(examined.line("firmware"),
              HasSubstr("ok firmware: an emulated board, firmware 0.1.0"));
  const Finished here = run({"tp100d", "doctor", "--port", std::filesystem::relative(port())});
  EXPECT_EQ(here.status, 0) << "the port's relative path must work: " << here.output;
  for (const char* name :
       {"device", "permission", "battery", "imu", "link", "clock", "real-time", "governor", "disk"})
    EXPECT_FALSE(examined.finding(name).is_null()) << name;
  const json& link = examined.report.at("link");
  EXPECT_GT(link.at("samples"), 0);
  EXPECT_GT(link.at("commands_confirmed"), 0);
  EXPECT_GT(link.at("round_trip_us").at("p50"), 0.0);
  EXPECT_LE(link.at("age_us").at("p50"), link.at("age_us").at("p99"));
  expect_motors_never_on();
}

TEST_F(Doctor, PrintsATableWithTheCountsAtItsEnd) {
  start_robot({});
  const Finished finished = run({"tp100d", "doctor", "--port", port(), "--link-test", "0"});
  EXPECT_EQ(finished.status, 0) << finished.output;
  EXPECT_THAT(finished.output, AllOf(HasSubstr("ok       firmware"), HasSubstr("0 errors, ")));
}

TEST_F(Doctor, MissesAPortThatIsNotThere) {
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("device"), HasSubstr("no such port; plug the robot in"));
}

TEST_F(Doctor, NamesWhoHoldsThePort) {
  start_robot({});
  Process holder({"tp100d", "run", "--port", port(), "--listen", "off"});
  ASSERT_TRUE(holder.wait_for("-> ready")) << holder.output();
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("open"), AllOf(HasSubstr("error open"), HasSubstr("port is busy")));
}

TEST_F(Doctor, HearsThatARobotIsSilent) {
  start_robot({"--fault", "cut:to-host"});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("firmware"), HasSubstr("error firmware: " + port() + ": silent"));
}

TEST_F(Doctor, AsksForFlashingAFirmwareOfAnotherProtocol) {
  start_robot({"--fault", "version:9"});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("firmware"),
              AllOf(HasSubstr("error"), HasSubstr("protocol 9"), HasSubstr("scripts/flash")));
}

TEST_F(Doctor, CountsRestartsOfABoard) {
  start_robot({"--fault", "reboot-loop:0.3"});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("reboots"), HasSubstr("error reboots: the board restarted"));
}

TEST_F(Doctor, FindsEmptyCells) {
  start_robot({"--fault", "battery:5.5"});
  EXPECT_THAT(examine().line("battery"),
              AllOf(HasSubstr("error battery: 5.5 V"), HasSubstr("charge the battery")));
}

TEST_F(Doctor, FindsAMissingGyro) {
  start_robot({"--fault", "imu-missing"});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("fault"), HasSubstr("error fault: imu_missing"));
}

TEST_F(Doctor, CountsCorruptedFrames) {
  start_robot({"--fault", "flip:0.002"});
  const Examined examined = examine();
  EXPECT_THAT(examined.line("link"), HasSubstr("use a short cable"));
  EXPECT_GT(examined.report.at("link").at("crc_errors").get<int>() +
                examined.report.at("link").at("cobs_errors").get<int>(),
            0);
}

TEST_F(Doctor, NamesWhoListensOnThePagesPort) {
  const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), size), 0);
  ASSERT_EQ(::listen(listener, 1), 0);
  ASSERT_EQ(::getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
  const std::string number = std::to_string(ntohs(address.sin_port));
  write_bytes(folder_.file("page.toml"), "[server]\nlisten = \"127.0.0.1:" + number + "\"\n");
  const Examined examined = examine({"--config", folder_.file("page.toml")});
  EXPECT_THAT(examined.line("page-port"), HasSubstr("warning page-port: TCP port " + number));
  EXPECT_THAT(examined.line("page-port"), HasSubstr("(pid " + std::to_string(getpid()) + ")"));
  ::close(listener);
}

TEST_F(Doctor, TriesTheFolderOfTheRecordings) {
  write_bytes(folder_.file("disk.toml"), "[record]\ndirectory = \"/proc/self/runs\"\n");
  EXPECT_THAT(examine({"--config", folder_.file("disk.toml")}).line("disk"),
              AllOf(HasSubstr("warning disk: /proc/"), HasSubstr("cannot be written")));
}

TEST_F(Doctor, RefusesBadUsage) {
  for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{
           {"--link-test", "-1"}, {"--robot", "no-such-robot"}, {"--config", "no-such-file"}}) {
    std::vector<std::string> arguments = {"tp100d", "doctor"};
    arguments.insert(arguments.end(), bad.begin(), bad.end());
    const Finished finished = run(arguments);
    EXPECT_EQ(finished.status, 2) << bad[0] << ": " << finished.output;
    EXPECT_EQ(lines(finished.output), 1U) << finished.output;
  }
  EXPECT_THAT(run({"tp100d", "docter"}).output, HasSubstr("did you mean 'doctor'?"));
}

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
        "exec " + std::string(TP100_BINARY_DIR) + "/bin/tp100d doctor --wheels-up --link-test 0" +
            " --port " + port() + " --robot " + robot + " < " + fifo()});
  }
  void answer(const std::string& line) { answers_ << line << std::endl; }
  /// A robot file in which the Boolean `key` is true, as for a robot that is wired that way.
  std::string miswired(const std::string& key) const {
    std::string text = read_bytes(std::string(TP100_SOURCE_DIR) + "/config/robots/end-loaded.toml");
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
    EXPECT_TRUE(doctor->wait_for("Enter starts")) << doctor->output();
    answer("");
    EXPECT_EQ(doctor->wait(), 1);
    return doctor->output();
  }

  /// Output of the doctor for a robot that fails before the end of the test.
  std::string broken_off() {
    const auto doctor = start();
    EXPECT_TRUE(doctor->wait_for("Enter starts")) << doctor->output();
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
  ASSERT_TRUE(doctor->wait_for("Enter starts")) << doctor->output();
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
  ASSERT_TRUE(doctor->wait_for("Enter starts")) << doctor->output();
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
  ASSERT_TRUE(doctor->wait_for("Enter starts")) << doctor->output();
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
  ASSERT_TRUE(doctor->wait_for("Enter starts")) << doctor->output();
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
  ASSERT_TRUE(doctor->wait_for("Enter starts")) << doctor->output();
  robot_->signal(SIGTERM);
  robot_->wait();
  answer("");
  EXPECT_EQ(doctor->wait(), 1);
  EXPECT_THAT(doctor->output(), HasSubstr("no such port"));
}

TEST_F(WheelsUp, IsBrokenOffIfTheRobotFellSilentBeforeEnter) {
  start_robot({});
  const auto doctor = start();
  ASSERT_TRUE(doctor->wait_for("Enter starts")) << doctor->output();
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
  ASSERT_TRUE(doctor->wait_for("Enter starts")) << doctor->output();
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
  EXPECT_THAT(broken_off(), HasSubstr("the board restarted as a track ran"));
}

TEST_F(WheelsUp, IsBrokenOffIfThePortGoes) {
  start_robot({"--fault", "unplug:1@2"});
  EXPECT_THAT(broken_off(), HasSubstr(port() + ": port is gone"));
}

#ifdef TP100_HAS_IMAGE
TEST_F(Doctor, ExaminesTheFirmwareItself) {
  start_robot({"--board", "avr"});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 0) << examined.report.dump();
  EXPECT_THAT(examined.line("firmware"), HasSubstr("ok firmware: a Mega 2560"));
}

TEST_F(Doctor, FindsABoardWithNothingButItsBootloader) {
  start_robot({"--board", "avr", "--blank"});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("bootloader"),
              HasSubstr("only the bootloader answers; scripts/flash --port " + port()));
}
#endif

}  // namespace
}  // namespace tp100::test
