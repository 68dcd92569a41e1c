#pragma once
// Runs `tp100d run` against a scripted robot on a pty, both in this process.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "../support/temporary_folder.h"
#include "app/commands.h"
#include "core/error.h"
#include "live_command.h"
#include "pty_robot.h"

namespace tp100::live {

class Run : public ::testing::Test {
 protected:
  Run() {
    robot_ = std::make_unique<PtyRobot>(port());
    // Scheduling is ordinary because other tests run on the machine at the same time.
    std::ofstream(folder_.path() / "config.toml")
        << "[loop]\npriority = 0\nlock_memory = false\nspin_us = 0\n"
           "[link]\nfirst_frame_timeout_ms = 700\n"
           "[server]\nlisten = \"127.0.0.1:0\"\n"
           "[record]\nblack_box_directory = \""
        << folder_.file("boxes") << "\"\n";
    options_.config = folder_.file("config.toml");
    options_.port = port().string();
    options_.stats = stats_path().string();
    options_.duration_s = 60.0;
  }
  ~Run() override { robot_.reset(); }

  std::filesystem::path port() const { return folder_.path() / "robot"; }
  std::filesystem::path stats_path() const { return folder_.path() / "stats.json"; }

  // Runs the command while `script` runs in parallel; afterwards SIGTERM ends the command.
  int run(const std::function<void()>& script = {}) {
    testing::internal::CaptureStderr();
    std::thread beside([&] {
      if (!script) return;
      script();
      ::kill(::getpid(), SIGTERM);
    });
    int status = -1;
    try {
      status = app::run_run(options_);
    } catch (const SetupError& error) {
      message_ = error.what();
    }
    beside.join();
    log_ = testing::internal::GetCapturedStderr();
    return status;
  }
  /// The command's log so far; call within the script of `run`.
  static std::string log_so_far() { return content_of("/proc/self/fd/2"); }
  std::string stats() const { return content_of(stats_path().string()); }
  // Port of the page; waits until it is served.
  std::string page() const {
    std::string served = page_of(stats_path().string());
    if (served.empty()) throw std::runtime_error("no page is served");
    return served;
  }
  // Expects that the statistics file contains `word`.
  void says_of_itself(const std::string& word) const {
    EXPECT_TRUE(soon([&] { return stats().find(word) != std::string::npos; }))
        << word << " is not in " << stats();
  }
  bool eventually(const std::function<bool(const ScriptedRobot&)>& condition) {
    const bool happened = soon([&] { return robot_->with(condition); });
    EXPECT_TRUE(happened) << "the condition did not become true";
    return happened;
  }
  /// Waits until the robot has received `more` further commands, so that a forbidden reaction would
  /// be seen.
  void commanded_again(std::size_t more) {
    const std::size_t before =
        robot_->with([](const ScriptedRobot& robot) { return robot.received.commands.size(); });
    eventually([&](const ScriptedRobot& robot) {
      return robot.received.commands.size() >= before + more;
    });
  }
  /// Number of recordings. Expects that each repeats its run bit for bit.
  int replayed_recordings() const {
    int replayed = 0;
    for (const auto& run : std::filesystem::directory_iterator(options_.record)) {
      testing::internal::CaptureStdout();
      EXPECT_EQ(
          app::run_replay(
              {.in = run.path(), .out = folder_.file("poses.csv"), .config = {}, .model = {}}),
          0);
      EXPECT_THAT(testing::internal::GetCapturedStdout(), ::testing::HasSubstr("bit for bit"));
      ++replayed;
    }
    return replayed;
  }
  static bool commanded(const ScriptedRobot& robot) { return robot.received.commands.size() > 20; }

  static bool driven(const ScriptedRobot& robot) {
    return commanded(robot) && robot.received.commands.back().speed_mps > 0.0F;
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<PtyRobot> robot_;
  app::RunOptions options_;
  std::string message_;
  std::string log_;
};

}  // namespace tp100::live
