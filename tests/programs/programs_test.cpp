// The two real programs as separate processes, connected by a real pseudo-terminal: what signals,
// kills, pauses and clients of these processes do. What the daemon does with a robot is tested in
// tests/live.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
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
    return joined({"tp100d", "run", "--port", port(), "--course", "1-curve", "--stats", stats()},
                  more);
  }
  /// Starts a robot and a daemon; returns when the daemon drives.
  void drive(const Words& more = {}) {
    robot_ = start_robot(port(), {"--course", "1-curve"});
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
  std::unique_ptr<Process> robot_, bridge_;
};

TEST_F(Programs, DriveACourseInRealTimeAndBothEndCleanly) {
  drive({"--verbose"});
  EXPECT_EQ(bridge_->wait(), 0) << bridge_->output();
  EXPECT_THAT(bridge_->output(), HasSubstr("state: running -> finished"));
  EXPECT_THAT(bridge_->output(), HasSubstr("loop, p50/p99/max us: lateness "));
  EXPECT_TRUE(robot_->wait_for("motors off: disarm")) << robot_->output();
  for (const char* name :
       {"reconnects", "lateness_us", "compute_us", "write_us", "sample_wire_us", "sample_wait_us"})
    EXPECT_THAT(read_bytes(stats()), HasSubstr("\"" + std::string(name) + "\""));
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
  // The robot file can be identified again from the recordings.
  const Finished again =
      run({"tp100d", "identify", runs + "/01-ahead-samples.csv", runs + "/02-left-samples.csv",
           runs + "/03-right-samples.csv", "--measured", runs + "/measured.csv", "--out",
           folder_.file("again.toml")});
  EXPECT_EQ(again.status, 0) << again.output;
  EXPECT_EQ(read_bytes(folder_.file("again.toml")), read_bytes(folder_.file("mine.toml")));
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

// Both on a killed robot and on one whose plug was pulled for a moment.
TEST_F(Programs, ALostRobotLeavesTheDaemonWaitingAndDisarmedUntilANewStart) {
  drive();
  // The killed robot leaves its link, whose pseudo-terminal may become another test's.
  std::filesystem::remove(port());
  robot_->signal(SIGKILL);
  robot_->wait();
  ASSERT_TRUE(bridge_->wait_for("state: running -> aborted")) << bridge_->output();
  robot_ = start_robot(port(), {"--fault", "unplug:0.3@2"});
  ASSERT_TRUE(bridge_->wait_for("state: syncing -> ready")) << bridge_->output();
  ASSERT_TRUE(robot_->wait_for("unplugged for 0.3 s")) << robot_->output();
  ASSERT_TRUE(bridge_->wait_for("port is gone")) << bridge_->output();
  ASSERT_TRUE(robot_->wait_for("plugged in again, on ")) << robot_->output();
  ASSERT_TRUE(bridge_->wait_for("state: syncing -> ready")) << bridge_->output();
  ASSERT_TRUE(goes_on(stats()));
  EXPECT_EQ(bridge_->output().rfind("-> arming"), bridge_->output().find("-> arming"))
      << "it must not arm again without a start: " << bridge_->output();
  bridge_->signal(SIGTERM);
  EXPECT_EQ(bridge_->wait(), 1) << bridge_->output();
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

TEST_F(Programs, AThousandClientsDisturbNoRun) {
  rlimit files{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &files), 0);
  files.rlim_cur = std::min<rlim_t>(files.rlim_max, 2048);
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &files), 0);
  drive({"--listen", "127.0.0.1:0"});
  const std::string before = "page: http://127.0.0.1:";
  const std::size_t at = bridge_->output().find(before);
  ASSERT_NE(at, std::string::npos) << bridge_->output();
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port =
      htons(static_cast<std::uint16_t>(std::stoi(bridge_->output().substr(at + before.size()))));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);

  // Some clients send nothing, some an incomplete request, some a complete request to subscribe.
  const std::array<std::string, 3> words{
      "", "GET / HT",
      "GET / HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
      "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
      "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n"};
  std::vector<int> clients;
  for (std::size_t i = 0; i < 1000; ++i) {
    const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    ASSERT_GE(fd, 0) << i;
    // On a slow machine the run may end first, and with it the daemon.
    if (::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
      ::close(fd);
      break;
    }
    clients.push_back(fd);
    const std::string& word = words[i % words.size()];
    if (!word.empty()) ::send(fd, word.data(), word.size(), MSG_NOSIGNAL);
  }
  EXPECT_GT(clients.size(), 300u) << "the run ended too soon: " << bridge_->output();
  EXPECT_EQ(bridge_->wait(), 0) << bridge_->output();
  EXPECT_THAT(bridge_->output(), HasSubstr("state: running -> finished"));
  // Clients that were served have received an answer; the connections of the others are closed.
  std::size_t answered = 0, ended = 0;
  for (const int fd : clients) {
    char text[16];
    const ssize_t n = ::recv(fd, text, sizeof text, MSG_DONTWAIT);
    answered += n > 0 ? 1U : 0U;
    ended += n == 0 || (n < 0 && errno != EAGAIN) ? 1U : 0U;
    ::close(fd);
  }
  EXPECT_EQ(answered + ended, clients.size());
  EXPECT_GT(answered, 0u);
  EXPECT_GT(ended, clients.size() / 2);
}

TEST_F(Programs, OneSeedPrintsOneJsonButForTimings) {
  const std::regex timings(
      R"re("(realtime_factor|[a-z_]*time[a-z_]*)":[-0-9.e+]+|"loop":\{[^}]*\})re");
  const auto json = [&](const char* seed) {
    const Finished finished = run({"tp100-sim", "course", "1-sharp", "--json", "--seed", seed});
    EXPECT_EQ(finished.status, 0) << finished.output;
    return std::regex_replace(finished.output, timings, "");
  };
  EXPECT_EQ(json("4"), json("4"));
  EXPECT_NE(json("4"), json("5"));
}

TEST_F(Programs, ARobotWhoseMachineStoodStillKeepsItsPriority) {
  robot_ = start_robot(port());
  const auto priority = [&] {
    return std::pair(::sched_getscheduler(robot_->pid()),
                     ::getpriority(PRIO_PROCESS, id_t(robot_->pid())));
  };
  const auto before = priority();
  // The pause is longer than the emulator catches up with.
  robot_->signal(SIGSTOP);
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  robot_->signal(SIGCONT);
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(priority(), before);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

}  // namespace
}  // namespace tp100::test
