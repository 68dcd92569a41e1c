// The two real programs as separate processes, connected by a real pseudo-terminal: what signals,
// kills, pauses and clients of these processes do. What the daemon does with a robot is tested in
// tests/live.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>
#include <utility>

#include "process.h"
#include "support/paths.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;

class Programs : public testing::Test {
 protected:
  std::string port() const { return folder_.file("tp100"); }
  std::string stats() const { return folder_.file("stats.json"); }
  Words daemon(const Words& more = {}) const {
    return joined({"tp100d", "run", "--port", port(), "--course", course_, "--stats", stats()},
                  more);
  }
  /// Starts a robot and a daemon; returns when the daemon drives.
  void drive(const Words& more = {}) {
    robot_ = start_robot(port(), {"--course", course_});
    bridge_ = std::make_unique<Process>(daemon(more));
    ASSERT_TRUE(bridge_->wait_for("state: arming -> running")) << bridge_->output();
  }
  /// Board time of the first line that contains `text`. [s]
  static double time_of(const std::string& output, const std::string& text) {
    const std::size_t at = output.find(text);
    if (at == std::string::npos) return -1.0;
    double seconds = -1.0;
    std::sscanf(output.c_str() + output.rfind('\n', at) + 1, "robot: %lf s:", &seconds);
    return seconds;
  }

  TemporaryFolder folder_;
  std::string course_ = "1-curve";
  std::unique_ptr<Process> robot_, bridge_;
};

TEST_F(Programs, DriveACourseInRealTimeAndBothEndCleanly) {
  course_ = short_course(folder_);
  drive();
  EXPECT_EQ(bridge_->wait(), 0) << bridge_->output();
  EXPECT_THAT(bridge_->output(), HasSubstr("state: running -> finished"));
  EXPECT_TRUE(robot_->wait_for("motors off: disarm")) << robot_->output();
  for (const char* name :
       {"reconnects", "lateness_us", "compute_us", "write_us", "sample_wire_us", "sample_wait_us"})
    EXPECT_THAT(read_bytes(stats()), HasSubstr("\"" + std::string(name) + "\""));
}

// Who looks for the thread that waits, or takes a processor, finds it on the page.
TEST_F(Programs, ThreadsAreThoseOfThePage) {
  drive({"--record", folder_.file("runs")});
  std::set<std::string> running, listed;
  const std::string tasks = "/proc/" + std::to_string(bridge_->pid()) + "/task";
  for (const auto& task : std::filesystem::directory_iterator(tasks)) {
    std::string name = read_bytes(task.path() / "comm");
    name.pop_back();
    running.insert(name);
  }
  std::istringstream page(read_bytes(source_path("daemon/ARCHITECTURE.md")));
  std::string line;
  while (std::getline(page, line) && line != "## Threads") {
  }
  while (std::getline(page, line) && !line.starts_with("## "))
    if (line.starts_with("| `")) listed.insert(line.substr(3, line.find('`', 3) - 3));
  for (const char* only_if_configured : {"world files", "ros2"})
    EXPECT_EQ(listed.erase(only_if_configured), 1U) << only_if_configured;
  EXPECT_EQ(running, listed);
}

TEST_F(Programs, IdentifyDrivesAsksForWhatNoCameraSawAndWritesARobot) {
  const std::string runs = folder_.file("mine-runs");
  const std::string fifo = folder_.file("answers");
  for (const auto& [name, segment] : {std::pair{"ahead", "type = \"line\"\nlength_m = 0.2"},
                                      {"left", "type = \"pivot\"\nangle_deg = 90.0"},
                                      {"right", "type = \"pivot\"\nangle_deg = -90.0"}})
    std::ofstream(folder_.file(std::string(name) + ".toml"))
        << "[[segment]]\n"
        << segment << "\n[fence]\nmin_x_m = -0.5\nmax_x_m = 0.5\nmin_y_m = -0.5\nmax_y_m = 0.5\n";
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  std::fstream answers(fifo, std::ios::in | std::ios::out);
  robot_ = start_robot(port());
  Process identify({"/bin/sh", "-c",
                    "exec " + build_path("bin/tp100d") + " identify --drive --repeats 1 --port " +
                        port() + " --course " + folder_.file("ahead.toml") + " " +
                        folder_.file("left.toml") + " " + folder_.file("right.toml") + " --out " +
                        folder_.file("mine.toml") + " < " + fifo});
  for (const char* const turned : {"0", "90", "-90"}) {
    ASSERT_TRUE(identify.wait_for("straight-line distance from start to end [m]:"))
        << identify.output();
    answers << (*turned == '0' ? "0.2" : "") << std::endl;
    ASSERT_TRUE(identify.wait_for("whole turns [deg]:")) << identify.output();
    answers << turned << std::endl;
  }
  EXPECT_EQ(identify.wait(), 0) << identify.output();
  EXPECT_THAT(identify.output(), HasSubstr("3 recordings in " + runs));
  const Finished check = run({"tp100d", "check", folder_.file("mine.toml")});
  EXPECT_EQ(check.status, 0) << check.output;
}

TEST_F(Programs, AKilledDaemonLeavesTheMotorsOffWithinTwoHundredMilliseconds) {
  drive();
  ASSERT_TRUE(eventually([&] { return figure(stats(), "progress_m") > 0.02; }));
  bridge_->signal(SIGKILL);
  bridge_->wait();
  ASSERT_TRUE(robot_->wait_for("port closed")) << robot_->output();
  // On a busy machine the port of a killed program is closed only after the commands' timeout.
  const std::string off = "motors off: command_timeout";
  ASSERT_TRUE(robot_->output().find(off) != std::string::npos || robot_->wait_for(off))
      << robot_->output();
  // Both times are on the board's clock; the tolerance is one loop and one physics step.
  EXPECT_LE(time_of(robot_->output(), off) - time_of(robot_->output(), "port closed"), 0.210)
      << robot_->output();

  // The robot keeps running after its client has gone: the next client finds it again.
  Process next(daemon());
  EXPECT_TRUE(next.wait_for("state: syncing -> ready")) << next.output();
}

// However impatient the service manager or the person is, and also when a terminal is closed.
TEST_F(Programs, SignalsThatEndTheDaemonDisarmFirst) {
  for (const std::vector<int>& signals : {std::vector{SIGTERM, SIGTERM, SIGINT}, {SIGHUP}}) {
    drive();
    for (const int signal : signals) bridge_->signal(signal);
    EXPECT_EQ(bridge_->wait(), 1) << bridge_->output();
    EXPECT_TRUE(robot_->wait_for("motors off: disarm")) << robot_->output();
    robot_->signal(SIGTERM);
    robot_->wait();
  }
}

TEST_F(Programs, TheRobotRemovesItsLinkWhenItIsEnded) {
  for (const int signal : {SIGTERM, SIGHUP}) {
    robot_ = start_robot(port());
    robot_->signal(signal);
    EXPECT_EQ(robot_->wait(), 0);
    EXPECT_FALSE(std::filesystem::is_symlink(port()));
  }
}

// The daemon is stopped, as on a machine that gives the program no time.
TEST_F(Programs, AStarvedLoopLeavesTheMotorsOffAndSaysWhy) {
  drive();
  bridge_->signal(SIGSTOP);
  ASSERT_TRUE(robot_->wait_for("motors off: command_timeout")) << robot_->output();
  bridge_->signal(SIGCONT);
  EXPECT_EQ(bridge_->wait(), 1) << bridge_->output();
  EXPECT_THAT(bridge_->output(), HasSubstr("cycles of the loop that started late"));
  EXPECT_THAT(bridge_->output(), HasSubstr("command_timeout: no fresh valid command"));
}

#ifdef TP100_HAS_WALL_CLOCK
TEST_F(Programs, AStepOfTheWallClockChangesNothing) {
  robot_ = start_robot(port());
  Process bridge({"/usr/bin/env",
                  "LD_PRELOAD=" + build_path("tests/programs/libtp100_wall_clock.so"),
                  build_path("bin/tp100d"), "run", "--port", port(), "--course",
                  short_course(folder_), "--record", folder_.file("runs")});
  EXPECT_EQ(bridge.wait(), 0) << bridge.output();
  EXPECT_THAT(bridge.output(), HasSubstr("state: running -> finished"));
  // The times in the log show the clock's steps: an hour ahead, then back to an hour behind.
  std::vector<int> minutes;
  std::istringstream lines(bridge.output());
  for (std::string line; std::getline(lines, line);) {
    int hour = 0, minute = 0, second = 0;
    if (std::sscanf(line.c_str(), "%d:%d:%d.", &hour, &minute, &second) == 3)
      minutes.push_back(hour * 60 + minute);
  }
  ASSERT_GT(minutes.size(), 3u) << bridge.output();
  EXPECT_GT(std::abs(minutes.front() - minutes.back()), 30)
      << "the clock did not step: " << bridge.output();
}
#endif

}  // namespace
}  // namespace tp100::test
