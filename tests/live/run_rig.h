#pragma once
// Runs `tp100d run` against a scripted robot on a pty, both in this process.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "../server/web_client.h"
#include "../support/eventually.h"
#include "../support/temporary_folder.h"
#include "app/commands.h"
#include "core/error.h"
#include "pty_robot.h"
#include "server/service.h"

namespace tp100::live {

class Run : public ::testing::Test {
 protected:
  Run() {
    configure("black_box_directory = \"" + folder_.file("boxes") + "\"");
    options_.config = folder_.file("config.toml");
    options_.port = port();
    options_.daemon.stats_path = folder_.file("stats.json");
    options_.daemon.duration_s = 300.0;
  }

  std::string port() const { return folder_.file("robot"); }
  /// Writes the configuration, with these keys of `record` and at its top. Scheduling is ordinary
  /// because other tests run on the machine at the same time.
  void configure(const std::string& record, const std::string& top = {}) const {
    test::write_bytes(folder_.file("config.toml"),
                      top + "\n[loop]\npriority = 0\nlock_memory = false\nspin_us = 0\n" +
                          "[link]\nfirst_frame_timeout_ms = 3000\n" +
                          "[server]\nlisten = \"127.0.0.1:0\"\n[record]\n" + record + "\n");
  }

  /// Runs the command while `script` runs in parallel; the end of the script ends the command with
  /// SIGTERM. Returns its status; -1: it did not begin, for the reason in `message_`.
  int run(const std::function<void()>& script = {}) {
    testing::internal::CaptureStderr();
    std::atomic<bool> over{false};
    std::thread beside([&] {
      if (!script) return;
      try {
        script();
      } catch (const std::exception& error) {
        ADD_FAILURE() << error.what();
      }
      if (!over) ::kill(::getpid(), SIGTERM);
    });
    int status = -1;
    try {
      status = app::run_run(options_);
    } catch (const UserError& error) {
      message_ = error.what();
    }
    over = true;
    beside.join();
    log_ = testing::internal::GetCapturedStderr();
    return status;
  }
  bool logged(const std::string& text) const { return log_.find(text) != std::string::npos; }
  std::string stats() const { return test::read_bytes(options_.daemon.stats_path); }
  /// Port of the page; waits until it is served.
  std::string page() const {
    static const std::string kBefore = "http://127.0.0.1:";
    std::string served;
    test::eventually([&] {
      const std::string text = stats();
      const std::size_t at = text.find(kBefore), end = text.find('/', at + kBefore.size());
      if (end == std::string::npos || at == std::string::npos) return false;
      served = text.substr(at + kBefore.size(), end - at - kBefore.size());
      return true;
    });
    if (served.empty()) throw std::runtime_error("no page is served");
    return served;
  }
  /// Expects that the statistics file soon contains `word`.
  void says_of_itself(const std::string& word) const {
    EXPECT_TRUE(test::eventually([&] { return stats().find(word) != std::string::npos; }))
        << word << " is not in " << stats();
  }

  /// What the robot has received since it was told to forget it.
  ScriptedRobot::Received received() {
    return robot_->with([](const ScriptedRobot& robot) { return robot.received; });
  }
  void forget() {
    robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
  }
  wire::State state() {
    return robot_->with([](const ScriptedRobot& robot) { return robot.state; });
  }
  std::size_t arms() { return received().arms.size(); }
  bool eventually(const std::function<bool(const ScriptedRobot&)>& condition) {
    const bool happened = test::eventually([&] { return robot_->with(condition); });
    EXPECT_TRUE(happened) << "the condition did not become true";
    return happened;
  }
  static bool commanded(const ScriptedRobot& robot) { return robot.received.commands.size() > 20; }
  static bool driven(const ScriptedRobot& robot) {
    return commanded(robot) && robot.received.commands.back().speed_mps > 0.0F;
  }
  static bool disarmed(const ScriptedRobot& robot) { return !robot.received.disarms.empty(); }
  static bool stopped(const ScriptedRobot& robot) { return !robot.received.stops.empty(); }
  /// Waits until the robot has received `more` further commands, which are sent all the time: long
  /// enough for a forbidden reaction to be seen.
  bool after_commands(std::size_t more) {
    const std::size_t until = received().commands.size() + more;
    return eventually(
        [&](const ScriptedRobot& robot) { return robot.received.commands.size() >= until; });
  }
  /// Requests a start until the robot moves. A start that comes too early is refused, and on a busy
  /// machine a run may end by itself.
  bool start(server::WebClient& viewer) {
    const auto off = [](const ScriptedRobot& robot) {
      return robot.state == wire::State::kDisarmed || robot.state == wire::State::kFaulted;
    };
    for (int i = 0; i < 400; ++i) {
      if (i % 20 == 0 && robot_->with(off)) viewer.call(server::Service::kStart);
      if (arms() > 0 && robot_->with(driven)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(25));
      viewer.drain();
    }
    return false;
  }
  /// Folders of the recordings. Expects that each repeats its run bit for bit.
  std::vector<std::string> replayed_recordings(const std::string& folder) const {
    std::vector<std::string> all;
    for (const auto& run : std::filesystem::directory_iterator(folder)) {
      testing::internal::CaptureStdout();
      EXPECT_EQ(app::run_replay({.in = run.path(), .out = folder_.file("poses.csv"), .config = {}}),
                0);
      EXPECT_THAT(testing::internal::GetCapturedStdout(), ::testing::HasSubstr("bit for bit"));
      all.push_back(run.path());
    }
    return all;
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<PtyRobot> robot_ = std::make_unique<PtyRobot>(folder_.path() / "robot");
  app::RunOptions options_;
  std::string message_;
  std::string log_;
};

}  // namespace tp100::live
