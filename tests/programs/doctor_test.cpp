// `tp100d doctor` on emulated robots with defects: the real programs, connected by a
// pseudo-terminal. What it says of a defect is tested in tests/doctor.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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
  void start_robot(const Words& more = {}) {
    if (robot_ != nullptr) end_robot();
    robot_ = test::start_robot(port(), more);
  }
  void end_robot() {
    robot_->signal(SIGTERM);
    robot_->wait();
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
  Examined examine(const Words& more = {}) const {
    const Finished finished = run(joined({"tp100d", "doctor", "--json", "--port", port()}, more));
    const json report = json::parse(finished.output, nullptr, false);
    EXPECT_FALSE(report.is_discarded()) << finished.output;
    return {report.is_discarded() ? -1 : finished.status, report};
  }

  TemporaryFolder folder_;
  std::unique_ptr<Process> robot_;
};

TEST_F(Doctor, FindsNothingThatKeepsAGoodRobotFromDriving) {
  start_robot();
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 0) << examined.report.dump();
  EXPECT_EQ(examined.report.at("errors"), 0);
  EXPECT_THAT(examined.line("firmware"),
              HasSubstr("ok firmware: an emulated board, firmware 0.1.0"));
  for (const char* name : {"device", "permission", "battery", "imu", "link", "clock", "real-time",
                           "governor", "load", "page-port", "disk"})
    EXPECT_FALSE(examined.finding(name).is_null()) << name;
  const json& link = examined.report.at("link");
  EXPECT_GT(link.at("samples"), 0);
  EXPECT_GT(link.at("commands_confirmed"), 0);
  EXPECT_GT(link.at("round_trip_us").at("p50"), 0.0);
  EXPECT_LE(link.at("age_us").at("p50"), link.at("age_us").at("p99"));
  // Without --json it prints a table, with the counts at its end; the path may be relative.
  const Finished table = run({"tp100d", "doctor", "--link-test", "0", "--port",
                              std::filesystem::relative(port()).string()});
  EXPECT_EQ(table.status, 0) << table.output;
  EXPECT_THAT(table.output, AllOf(HasSubstr("ok       firmware"), HasSubstr("0 errors, ")));
  expect_motors_never_on();
}

TEST_F(Doctor, FindsEachDefectAndSaysWhatToDo) {
  struct Defect {
    Words robot;
    int status;  // negative: any
    const char *finding, *line, *fix;
  };
  const Defect defects[] = {
      {{"--fault=cut:to-host"}, 1, "firmware", "error firmware: /", "reset"},
      {{"--fault=version:9"}, 1, "firmware", "protocol 9", "scripts/flash"},
      {{"--fault=reboot-loop:0.3"}, 1, "reboots", "error reboots: ", ""},
      {{"--fault=battery:5.5"}, 1, "battery", "error battery: 5.5 V", "charge"},
      {{"--fault=imu-missing"}, 1, "fault", "error fault: imu_missing", ""},
      {{"--fault=flip:0.002"}, -1, "link", "warning link: ", "short cable"},
#ifdef TP100_HAS_IMAGE
      {{"--board=avr"}, 0, "firmware", "ok firmware: a Mega 2560", ""},
      {{"--board=avr", "--blank"}, 1, "bootloader", "only the bootloader", "flash"},
#endif
  };
  for (const Defect& defect : defects) {
    SCOPED_TRACE(defect.robot.back());
    start_robot(defect.robot);
    const Examined examined = examine();
    if (defect.status >= 0) {
      EXPECT_EQ(examined.status, defect.status) << examined.report.dump();
    }
    EXPECT_THAT(examined.line(defect.finding),
                AllOf(HasSubstr(defect.line), HasSubstr(defect.fix)));
  }
}

TEST_F(Doctor, TriesTheFolderOfTheRecordings) {
  write_bytes(folder_.file("disk.toml"), "[record]\ndirectory = \"/proc/self/runs\"\n");
  EXPECT_THAT(examine({"--config", folder_.file("disk.toml")}).line("disk"),
              AllOf(HasSubstr("warning disk: /proc/"), HasSubstr("cannot be written")));
}

using Dialogue = std::vector<std::pair<std::string, std::string>>;  // prompts and their answers

/// The guided test, whose prompts are answered through a pipe.
class WheelsUp : public Doctor {
 protected:
  void SetUp() override {
    ASSERT_EQ(::mkfifo(fifo().c_str(), 0600), 0);
    answers_.open(fifo(), std::ios::in | std::ios::out);
  }
  std::string fifo() const { return folder_.file("answers"); }
  /// Starts the guided test of a robot, and answers its prompts.
  void examine_robot(const Words& robot, const Dialogue& dialogue) {
    start_robot(robot);
    doctor_ = std::make_unique<Process>(Words{"/bin/sh", "-c",
                                              "exec " + build_path("bin/tp100d") +
                                                  " doctor --wheels-up --link-test 0 --port " +
                                                  port() + " < " + fifo()});
    for (const auto& [prompt, answer] : dialogue) {
      ASSERT_TRUE(doctor_->wait_for(prompt)) << doctor_->output();
      if (answer != kNotYet) this->answer(answer);
    }
  }
  void answer(const std::string& line) { answers_ << line << std::endl; }
  /// The end of a guided test that found something.
  void expect_found(const Words& texts) {
    EXPECT_EQ(doctor_->wait(), 1);
    for (const std::string& text : texts) EXPECT_THAT(doctor_->output(), HasSubstr(text));
  }
  static constexpr const char* kStart = "Press Enter to start";
  static constexpr const char* kNotYet = "(later)";
  std::fstream answers_;
  std::unique_ptr<Process> doctor_;
};

TEST_F(WheelsUp, MovesNothingBeforeEnterAndFindsAGoodRobotWell) {
  examine_robot({}, {{kStart, kNotYet}});
  expect_motors_never_on();
  answer("");
  EXPECT_EQ(doctor_->wait(), 0) << doctor_->output();
  for (const char* well : {"ok       left-track", "ok       right-track", "ok       gyro"})
    EXPECT_THAT(doctor_->output(), HasSubstr(well));
  EXPECT_TRUE(robot_->wait_for("motors off: disarm")) << robot_->output();
}

// The robot is not turned by hand, though it is asked for.
TEST_F(WheelsUp, OnAStandAsksWhatRanAndForATurnByHand) {
  examine_robot({"--setup", "stand"}, {{kStart, ""},
                                       {"What ran?", "perhaps"},
                                       {"What ran?", "o"},
                                       {"What ran?", ""},
                                       {"Hold the robot", "\n"}});
  expect_found({"error    left-track", "set drive.swap_tracks = true", "ok       right-track",
                "error    gyro"});
}

TEST_F(WheelsUp, IsBrokenOffIfNobodyAnswers) {
  start_robot();
  const Finished finished =
      run({"tp100d", "doctor", "--wheels-up", "--link-test", "0", "--port", port()});
  EXPECT_EQ(finished.status, 1);
  EXPECT_THAT(finished.output, HasSubstr("nobody pressed Enter, nothing moved"));
  expect_motors_never_on();
}

TEST_F(WheelsUp, DisarmsFirstWhenItIsStopped) {
  bool disarmed = false;
  // On a busy machine the firmware may be faster.
  for (int tries = 0; tries < 5 && !disarmed; ++tries) {
    examine_robot({}, {{kStart, ""}});
    ASSERT_TRUE(robot_->wait_for("motors on")) << robot_->output();
    doctor_->signal(SIGTERM);
    expect_found({"error    wheels-up"});
    ASSERT_TRUE(robot_->wait_for("motors off: ")) << robot_->output();
    disarmed = robot_->output().find("command_timeout") == std::string::npos;
  }
  EXPECT_TRUE(disarmed) << robot_->output();
}

TEST_F(WheelsUp, IsBrokenOffByWhatHasHappenedBeforeEnter) {
  const std::pair<std::optional<const char*>, const char*> cases[] = {
      {std::nullopt, "no such port"},
      {"cut:to-host", "no session with the robot"},
      {"battery:5.5", "the robot cannot be armed: the battery is below"}};
  for (const auto& [fault, found] : cases) {
    SCOPED_TRACE(found);
    examine_robot({}, {{kStart, kNotYet}});
    end_robot();
    if (fault) start_robot({"--fault", *fault});
    answer("");
    expect_found({found});
  }
}

TEST_F(WheelsUp, IsBrokenOffByWhatHappensWhileATrackRuns) {
  const std::pair<const char*, Words> cases[] = {
      {"battery:5.5@1.5",
       {"the robot stopped by itself: the battery is below", "fix: charge the battery"}},
      {"cut:to-host@2", {port() + ": the robot fell silent"}},
      {"reboot@2", {"the board restarted while a track ran"}},
      {"unplug:1@2", {port() + ": port is gone"}}};
  for (const auto& [fault, texts] : cases) {
    SCOPED_TRACE(fault);
    examine_robot({"--fault", fault}, {{kStart, ""}});
    expect_found(joined(texts, {"error    wheels-up"}));
  }
}

}  // namespace
}  // namespace tp100::test
