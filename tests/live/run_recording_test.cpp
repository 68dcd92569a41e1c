// The recordings and statistics of `tp100d run`, also on a disk that stands still.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "../server/web_client.h"
#include "../support/frozen_disk.h"
#include "../support/notify_socket.h"
#include "../support/paths.h"
#include "run_rig.h"
#include "server/services.h"

namespace tp100::live {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using namespace std::chrono_literals;

TEST_F(Run, AViewerEndsARecordingAndBeginsAnother) {
  options_.record = folder_.file("runs");
  robot_->plug_in();
  std::string refused, ended, began, runs;
  EXPECT_EQ(run([&] {
              eventually(commanded);
              const std::string port = page();
              server::WebClient viewer(port);
              viewer.call(server::Service::kRecordStart);
              refused = viewer.read_until("serviceCallFailure");
              viewer.call(server::Service::kRecordStop);
              ended = viewer.read_until("\"bytes\"");
              viewer.call(server::Service::kRecordStart);
              began = viewer.read_until("\"run\"");
              runs = server::http_get(port, "GET /api/runs HTTP/1.0\r\nHost: localhost\r\n\r\n");
            }),
            1);
  EXPECT_THAT(refused, HasSubstr("running already"));
  EXPECT_THAT(ended, HasSubstr("-poses"));
  EXPECT_THAT(began, HasSubstr("-poses"));
  EXPECT_THAT(runs, HasSubstr("\"kind\":\"recording\""));
  EXPECT_THAT(runs, HasSubstr("\"active\":true"));
  EXPECT_THAT(runs, HasSubstr("\"active\":false"));
  // The second recording begins in the middle of the run.
  EXPECT_EQ(replayed_recordings(), 2);
}

TEST_F(Run, WhoStaysRecordsRunByRun) {
  options_.course = "1-straight";
  options_.stay = true;
  options_.record = folder_.file("runs");
  robot_->plug_in();
  EXPECT_THAT(run([&] {
                eventually(driven);
                server::WebClient viewer(page());
                says_of_itself("\"active\": true");
                viewer.call(server::Service::kStop);
                says_of_itself("\"active\": false");
                robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
                EXPECT_TRUE(soon([&] {
                  viewer.call(server::Service::kStart);
                  std::this_thread::sleep_for(100ms);
                  viewer.drain();
                  return robot_->with(driven);
                }));
                says_of_itself("\"active\": true");
              }),
              ::testing::AnyOf(0, 1))
      << message_;
  EXPECT_EQ(replayed_recordings(), 2);
}

// What killed programs leave would fill the disk, one kill after the other.
TEST_F(Run, WhatAKilledProgramLeftIsGoneAfterTheNextStart) {
  options_.record = folder_.file("runs");
  const std::vector<std::string> left = {"runs/.tp100-abcdef", "runs/a/.tp100-ABCDEF",
                                         "runs/.tp100-report/page.html", ".tp100-000000"};
  for (const std::string& name : left) {
    std::filesystem::create_directories(std::filesystem::path(folder_.file(name)).parent_path());
    test::write_bytes(folder_.file(name), "x");
  }
  robot_->plug_in();
  run([&] {
    EXPECT_TRUE(soon([&] {
      return std::ranges::none_of(left, [&](const std::string& name) {
        return std::filesystem::exists(folder_.file(name));
      });
    }));
    page();  // earlier, a signal would end this program
  });
}

// A run whose course has a name of a person's choice would be in no list, and no quota would count
// it.
TEST_F(Run, ARunIsListedWhateverItsCourseIsCalled) {
  options_.record = folder_.file("runs");
  options_.course = folder_.file("Prüf strecke (Kopie).toml");
  std::filesystem::copy_file(source_path("config/courses/1-straight.toml"), options_.course);
  robot_->plug_in();
  std::string runs;
  run([&] {
    says_of_itself("\"active\": true");
    runs = server::http_get(page(), "GET /api/runs HTTP/1.0\r\nHost: localhost\r\n\r\n");
  });
  EXPECT_THAT(runs, HasSubstr("-Pruef-strecke-Kopie\""));
}

// Records on a disk that a test can freeze.
class RunBesideADisk : public Run {
 protected:
  void SetUp() override {
    if (!disk_.available()) GTEST_SKIP() << "no file system can be frozen here (root, loop device)";
    std::filesystem::create_directory(disk_.path() + "/runs");
    options_.record = disk_.path() + "/runs";
    options_.course = "1-straight";
    options_.stay = true;
    robot_->plug_in();
  }
  // On a busy machine the link may be lost before a run has begun; then the start is repeated.
  void drives(server::WebClient& viewer) {
    EXPECT_TRUE(soon([&] {
      viewer.call(server::Service::kStart);
      std::this_thread::sleep_for(100ms);
      viewer.drain();
      return robot_->with(driven);
    }));
  }
  void drives_and_records(server::WebClient& viewer) {
    drives(viewer);
    says_of_itself("\"active\": true");
  }

  test::FrozenDisk disk_;
};

TEST_F(RunBesideADisk, StopAndWatchdogDoNotWaitForADiskThatStandsStill) {
  const std::string name = "@tp100-run-test-" + std::to_string(::getpid());
  const test::NotifySocket manager(name);
  ::setenv("NOTIFY_SOCKET", name.c_str(), 1);
  ::setenv("WATCHDOG_USEC", "2000000", 1);
  EXPECT_THAT(
      run([&] {
        server::WebClient viewer(page());
        drives_and_records(viewer);
        robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
        ASSERT_TRUE(disk_.freeze());
        viewer.call(server::Service::kRecordStop);
        viewer.call(server::Service::kStop);
        eventually([](const ScriptedRobot& robot) { return !robot.received.stops.empty(); });
        manager.received();
        EXPECT_TRUE(manager.hears("WATCHDOG=1", 60s));
        // The same must hold during another run, whose recording also waits for the disk.
        robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
        drives(viewer);
        viewer.call(server::Service::kStop);
        eventually([](const ScriptedRobot& robot) { return !robot.received.stops.empty(); });
        manager.received();
        EXPECT_TRUE(manager.hears("WATCHDOG=1", 60s));
        viewer.drain();
        for (const std::string& message : viewer.take())
          EXPECT_THAT(message, Not(HasSubstr("\"bytes\"")));
        ASSERT_TRUE(disk_.thaw());
        EXPECT_THAT(viewer.read_until("\"bytes\""), HasSubstr("-1-straight"));
      }),
      ::testing::AnyOf(0, 1))
      << message_;
  ::unsetenv("NOTIFY_SOCKET");
  ::unsetenv("WATCHDOG_USEC");
  EXPECT_GE(replayed_recordings(), 2);
}

TEST_F(RunBesideADisk, SigtermDisarmsWhileADiskStandsStill) {
  std::thread thaw;
  EXPECT_EQ(
      run([&] {
        server::WebClient viewer(page());
        drives_and_records(viewer);
        robot_->with([](ScriptedRobot& robot) { robot.received = {}; });
        ASSERT_TRUE(disk_.freeze());
        thaw = std::thread([&] {
          eventually([](const ScriptedRobot& robot) { return !robot.received.disarms.empty(); });
          disk_.thaw();
        });
      }),
      1);
  if (thaw.joinable()) thaw.join();
  EXPECT_GE(replayed_recordings(), 1) << "the recording must contain the end of the run";
}

TEST_F(Run, ItsFiguresHoldUpNobodyWhereTheyCannotBeWritten) {
  ASSERT_EQ(::mkfifo(stats_path().c_str(), 0600), 0);
  robot_->plug_in();
  // The first statistics are read, so that the run begins; the next writer blocks in open().
  std::thread first([this] { stats(); });
  std::atomic<bool> over{false};
  std::thread reader;
  EXPECT_EQ(
      run([&] {
        eventually(commanded);
        std::this_thread::sleep_for(1500ms);
        reader = std::thread([&] {
          eventually([](const ScriptedRobot& robot) { return !robot.received.disarms.empty(); });
          const int pipe = ::open(stats_path().c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
          char text[4096];
          while (!over)
            if (::read(pipe, text, sizeof text) <= 0) std::this_thread::sleep_for(1ms);
          ::close(pipe);
        });
      }),
      1);
  over = true;
  first.join();
  if (reader.joinable()) reader.join();
}

}  // namespace
}  // namespace tp100::live
