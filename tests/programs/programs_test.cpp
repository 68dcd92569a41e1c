// The two real programs as separate processes, connected by a real pseudo-terminal.

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

class Programs : public testing::Test {
 protected:
  std::string port() const { return folder_.file("tp100"); }
  std::vector<std::string> robot_arguments() const {
    return {"tp100-sim", "robot", "--link", port(), "--course", "1-curve"};
  }
  std::vector<std::string> daemon_arguments(const std::string& course = "1-curve") const {
    return {"tp100d", "run", "--port", port(), "--course", course, "--stats", stats()};
  }
  std::string stats() const { return folder_.file("stats.json"); }
  /// Board time of the first line after `from` that contains `text`. [s]
  static double time_of(const std::string& output, const std::string& text, std::size_t from = 0) {
    const std::size_t at = output.find(text, from);
    if (at == std::string::npos) return -1.0;
    const std::size_t line = output.rfind('\n', at) + 1;
    double seconds = -1.0;
    std::sscanf(output.c_str() + line, "robot: %lf s:", &seconds);
    return seconds;
  }
  TemporaryFolder folder_;
};

TEST_F(Programs, DriveACourseInRealTimeAndBothEndCleanly) {
  Process robot(robot_arguments());
  ASSERT_TRUE(robot.wait_for("linked from"));
  std::vector<std::string> arguments = daemon_arguments();
  arguments.push_back("--verbose");
  Process bridge(arguments);
  EXPECT_EQ(bridge.wait(), 0) << bridge.output();
  EXPECT_NE(bridge.output().find("state: running -> finished"), std::string::npos);
  EXPECT_NE(bridge.output().find("loop, p50/p99/max us: lateness "), std::string::npos);
  EXPECT_TRUE(robot.wait_for("motors off: disarm")) << robot.output();
  std::stringstream text;
  text << std::ifstream(stats()).rdbuf();
  EXPECT_NE(text.str().find("\"reconnects\""), std::string::npos);
  for (const char* time :
       {"lateness_us", "compute_us", "write_us", "sample_wire_us", "sample_wait_us"})
    EXPECT_NE(text.str().find(time), std::string::npos) << time;
  robot.signal(SIGTERM);
  EXPECT_EQ(robot.wait(), 0);
  EXPECT_FALSE(std::filesystem::is_symlink(port()));
}

TEST_F(Programs, IdentifyDrivesAsksForWhatNoCameraSawAndWritesARobot) {
  const auto write_course = [this](const std::string& name, const std::string& segment) {
    std::ofstream(folder_.file(name)) << "[[segment]]\n"
                                      << segment << "\n[fence]\nmin_x_m = -0.5\n"
                                      << "max_x_m = 0.5\nmin_y_m = -0.5\nmax_y_m = 0.5\n";
  };
  write_course("ahead.toml", "type = \"line\"\nlength_m = 0.2");
  write_course("left.toml", "type = \"pivot\"\nangle_deg = 90.0");
  write_course("right.toml", "type = \"pivot\"\nangle_deg = -90.0");
  const std::string fifo = folder_.file("answers");
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  std::fstream answers(fifo, std::ios::in | std::ios::out);

  Process robot({"tp100-sim", "robot", "--link", port()});
  ASSERT_TRUE(robot.wait_for("linked from"));
  Process identify({"/bin/sh", "-c",
                    "exec " + build_path("bin/tp100d") + " identify --drive --repeats 1" +
                        " --port " + port() + " --course " + folder_.file("ahead.toml") + " " +
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
  EXPECT_NE(identify.output().find("3 recordings in " + folder_.file("mine-runs")),
            std::string::npos);
  const Finished check = run({"tp100d", "check", folder_.file("mine.toml")});
  EXPECT_EQ(check.status, 0) << check.output;
  // The robot file can be identified again from the recordings.
  const std::string runs = folder_.file("mine-runs");
  const Finished again =
      run({"tp100d", "identify", runs + "/01-ahead-samples.csv", runs + "/02-left-samples.csv",
           runs + "/03-right-samples.csv", "--measured", runs + "/measured.csv", "--out",
           folder_.file("again.toml")});
  EXPECT_EQ(again.status, 0) << again.output;
  const auto text = [](const std::string& path) {
    std::stringstream all;
    all << std::ifstream(path).rdbuf();
    return all.str();
  };
  EXPECT_EQ(text(folder_.file("again.toml")), text(folder_.file("mine.toml")));
}

TEST_F(Programs, AKilledDaemonLeavesTheMotorsOffWithinTwoHundredMilliseconds) {
  Process robot(robot_arguments());
  ASSERT_TRUE(robot.wait_for("linked from"));
  Process bridge(daemon_arguments());
  ASSERT_TRUE(bridge.wait_for("state: arming -> running")) << bridge.output();
  ASSERT_TRUE(eventually([&] { return figure(stats(), "progress_m") > 0.02; }));
  bridge.signal(SIGKILL);
  bridge.wait();
  ASSERT_TRUE(robot.wait_for("port closed")) << robot.output();
  // On a busy machine the port of a killed program is closed only after the commands' timeout.
  const std::string off = "motors off: command_timeout";
  ASSERT_TRUE(robot.output().find(off) != std::string::npos || robot.wait_for(off))
      << robot.output();
  const double closed_s = time_of(robot.output(), "port closed");
  const double off_s = time_of(robot.output(), off);
  // Both times are on the board's clock; the tolerance is one loop and one physics step.
  EXPECT_LE(off_s - closed_s, 0.200 + 0.010) << robot.output();

  // The robot keeps running after its client has gone: the next client finds it again.
  Process next(daemon_arguments());
  EXPECT_EQ(next.wait_for("state: syncing -> ready"), true) << next.output();
}

TEST_F(Programs, AKilledRobotLeavesTheDaemonWaitingAndDisarmedUntilANewStart) {
  auto robot = std::make_unique<Process>(robot_arguments());
  ASSERT_TRUE(robot->wait_for("linked from"));
  Process bridge(daemon_arguments());
  ASSERT_TRUE(bridge.wait_for("state: arming -> running")) << bridge.output();
  // The killed robot leaves its link, whose pseudo-terminal may become another test's.
  std::filesystem::remove(port());
  robot->signal(SIGKILL);
  robot->wait();
  ASSERT_TRUE(bridge.wait_for("state: running -> aborted")) << bridge.output();
  robot = std::make_unique<Process>(robot_arguments());
  ASSERT_TRUE(robot->wait_for("linked from")) << robot->output();
  ASSERT_TRUE(bridge.wait_for("state: syncing -> ready")) << bridge.output();
  ASSERT_TRUE(goes_on(stats()));
  EXPECT_EQ(bridge.output().rfind("-> arming"), bridge.output().find("-> arming"))
      << "it must not arm again without a start: " << bridge.output();
  bridge.signal(SIGTERM);
  EXPECT_EQ(bridge.wait(), 1) << bridge.output();
}

TEST_F(Programs, AnUnpluggedRobotIsReadyAgainByItselfAndDisarmedUntilANewStart) {
  std::vector<std::string> arguments = robot_arguments();
  arguments.insert(arguments.end(), {"--fault", "unplug:0.3@2"});
  Process robot(arguments);
  ASSERT_TRUE(robot.wait_for("linked from"));
  Process bridge(daemon_arguments());
  ASSERT_TRUE(bridge.wait_for("state: syncing -> ready")) << bridge.output();
  ASSERT_TRUE(robot.wait_for("unplugged for 0.3 s")) << robot.output();
  ASSERT_TRUE(bridge.wait_for("port is gone")) << bridge.output();
  ASSERT_TRUE(robot.wait_for("plugged in again, on ")) << robot.output();
  ASSERT_TRUE(bridge.wait_for("state: syncing -> ready")) << bridge.output();
  ASSERT_TRUE(goes_on(stats()));
  EXPECT_EQ(bridge.output().rfind("-> arming"), bridge.output().find("-> arming"))
      << "it must not arm again without a start: " << bridge.output();
  bridge.signal(SIGTERM);
  EXPECT_EQ(bridge.wait(), 1) << bridge.output();
}

TEST_F(Programs, SigtermDisarmsFirst) {
  Process robot(robot_arguments());
  ASSERT_TRUE(robot.wait_for("linked from"));
  Process bridge(daemon_arguments());
  ASSERT_TRUE(bridge.wait_for("state: arming -> running")) << bridge.output();
  bridge.signal(SIGTERM);
  EXPECT_EQ(bridge.wait(), 1) << bridge.output();
  EXPECT_TRUE(robot.wait_for("motors off: disarm")) << robot.output();
}

TEST_F(Programs, ASecondSigtermDoesNotKeepItFromDisarming) {
  Process robot(robot_arguments());
  ASSERT_TRUE(robot.wait_for("linked from"));
  Process bridge(daemon_arguments());
  ASSERT_TRUE(bridge.wait_for("state: arming -> running")) << bridge.output();
  bridge.signal(SIGTERM);
  bridge.signal(SIGTERM);
  bridge.signal(SIGINT);
  EXPECT_EQ(bridge.wait(), 1) << bridge.output();
  EXPECT_TRUE(robot.wait_for("motors off: disarm")) << robot.output();
}

// The daemon is stopped, as on a machine that gives the program no time.
TEST_F(Programs, AStarvedLoopLeavesTheMotorsOffAndSaysWhy) {
  Process robot(robot_arguments());
  ASSERT_TRUE(robot.wait_for("linked from"));
  Process bridge(daemon_arguments());
  ASSERT_TRUE(bridge.wait_for("state: arming -> running")) << bridge.output();
  bridge.signal(SIGSTOP);
  ASSERT_TRUE(robot.wait_for("motors off: command_timeout")) << robot.output();
  bridge.signal(SIGCONT);
  EXPECT_EQ(bridge.wait(), 1) << bridge.output();
  EXPECT_NE(bridge.output().find("cycles of the loop that started late"), std::string::npos)
      << bridge.output();
  EXPECT_NE(bridge.output().find("command_timeout: no fresh valid command"), std::string::npos)
      << bridge.output();
}

#ifdef TP100_HAS_WALL_CLOCK
TEST_F(Programs, AStepOfTheWallClockChangesNothing) {
  Process robot(robot_arguments());
  ASSERT_TRUE(robot.wait_for("linked from"));
  std::vector<std::string> arguments = daemon_arguments(short_course(folder_));
  arguments[0] = build_path("bin/tp100d");
  arguments.insert(
      arguments.begin(),
      {"/usr/bin/env", "LD_PRELOAD=" + build_path("tests/programs/libtp100_wall_clock.so")});
  arguments.insert(arguments.end(), {"--record", folder_.file("runs")});
  Process bridge(arguments);
  EXPECT_EQ(bridge.wait(), 0) << bridge.output();
  EXPECT_NE(bridge.output().find("state: running -> finished"), std::string::npos);
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
  Process robot(robot_arguments());
  ASSERT_TRUE(robot.wait_for("linked from"));
  std::vector<std::string> arguments = daemon_arguments("1-curve");
  arguments.insert(arguments.end(), {"--listen", "127.0.0.1:0"});
  Process bridge(arguments);
  ASSERT_TRUE(bridge.wait_for("state: arming -> running")) << bridge.output();
  const std::string before = "page: http://127.0.0.1:";
  const std::size_t at = bridge.output().find(before);
  ASSERT_NE(at, std::string::npos) << bridge.output();
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port =
      htons(static_cast<std::uint16_t>(std::stoi(bridge.output().substr(at + before.size()))));
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
  EXPECT_GT(clients.size(), 300u) << "the run ended too soon: " << bridge.output();
  EXPECT_EQ(bridge.wait(), 0) << bridge.output();
  EXPECT_NE(bridge.output().find("state: running -> finished"), std::string::npos);
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

TEST_F(Programs, TheRobotRemovesItsLinkWhenTheTerminalIsClosed) {
  Process robot(robot_arguments());
  ASSERT_TRUE(robot.wait_for("linked from"));
  robot.signal(SIGHUP);
  EXPECT_EQ(robot.wait(), 0);
  EXPECT_FALSE(std::filesystem::is_symlink(port()));
}

TEST_F(Programs, AClosedTerminalDisarmsFirst) {
  Process robot(robot_arguments());
  ASSERT_TRUE(robot.wait_for("linked from"));
  Process bridge(daemon_arguments());
  ASSERT_TRUE(bridge.wait_for("state: arming -> running")) << bridge.output();
  bridge.signal(SIGHUP);
  EXPECT_EQ(bridge.wait(), 1) << bridge.output();
  EXPECT_TRUE(robot.wait_for("motors off: disarm")) << robot.output();
}

TEST_F(Programs, TheDaemonWaitsForARobotThatComesLater) {
  std::vector<std::string> arguments = daemon_arguments("1-straight");
  arguments.push_back("--wait");
  Process bridge(arguments);
  ASSERT_TRUE(bridge.wait_for("; waiting")) << bridge.output();
  Process robot(robot_arguments());
  ASSERT_TRUE(robot.wait_for("linked from"));
  EXPECT_TRUE(bridge.wait_for("state: arming -> running")) << bridge.output();
}

TEST_F(Programs, TheDurationLimitEndsARunWithStatusOne) {
  Process robot(robot_arguments());
  ASSERT_TRUE(robot.wait_for("linked from"));
  std::vector<std::string> arguments = daemon_arguments();
  arguments.insert(arguments.end(), {"--duration", "2"});
  EXPECT_EQ(run(arguments).status, 1);
  EXPECT_TRUE(robot.wait_for("motors off: disarm")) << robot.output();
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
  Process robot(robot_arguments());
  ASSERT_TRUE(robot.wait_for("linked from"));
  const auto priority = [&] {
    return std::pair(::sched_getscheduler(robot.pid()),
                     ::getpriority(PRIO_PROCESS, id_t(robot.pid())));
  };
  const auto before = priority();
  // The pause is longer than the emulator catches up with.
  robot.signal(SIGSTOP);
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  robot.signal(SIGCONT);
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(priority(), before);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

}  // namespace
}  // namespace tp100::test
