// The recordings and statistics of `tp100d run`, also on a disk that stands still.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include "../support/frozen_disk.h"
#include "../support/notify_socket.h"
#include "run_rig.h"

namespace tp100::live {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using namespace std::chrono_literals;

TEST_F(Run, AViewerEndsARecordingAndBeginsAnother) {
  options_.record = folder_.file("runs");
  robot_->plug_in();
  EXPECT_EQ(run([&] {
              eventually(commanded);
              server::WebClient viewer(page());
              viewer.call(server::Service::kRecordStart);
              EXPECT_THAT(viewer.read_until("serviceCallFailure"), HasSubstr("running already"));
              viewer.call(server::Service::kRecordStop);
              EXPECT_THAT(viewer.read_until("\"bytes\""), HasSubstr("-poses"));
              viewer.call(server::Service::kRecordStart);
              EXPECT_THAT(viewer.read_until("\"run\""), HasSubstr("-poses"));
            }),
            1);
  // The second recording begins in the middle of the run.
  EXPECT_EQ(replayed_recordings(options_.record).size(), 2U);
}

// Records on a disk that a test can freeze.
class RunBesideADisk : public Run {
 protected:
  void SetUp() override {
    if (!disk_.available()) GTEST_SKIP() << "no file system can be frozen here (root, loop device)";
    std::filesystem::create_directory(disk_.path() + "/runs");
    options_.record = disk_.path() + "/runs";
    options_.course = "1-straight";
    options_.daemon.stay = true;
    robot_->plug_in();
  }
  void drives_and_records(server::WebClient& viewer) {
    EXPECT_TRUE(start(viewer));
    says_of_itself("\"active\": true");
  }
  /// STOP reaches the robot and the watchdog is fed although the disk stands still.
  void stops_in_time(server::WebClient& viewer, const test::NotifySocket& manager) {
    viewer.call(server::Service::kStop);
    eventually(stopped);
    manager.received();
    EXPECT_TRUE(manager.hears("WATCHDOG=1", 60s));
  }

  test::FrozenDisk disk_;
};

TEST_F(RunBesideADisk, StopAndWatchdogDoNotWaitForADiskThatStandsStill) {
  const std::string name = "@tp100-run-test-" + std::to_string(::getpid());
  const test::NotifySocket manager(name);
  ::setenv("NOTIFY_SOCKET", name.c_str(), 1);
  ::setenv("WATCHDOG_USEC", "2000000", 1);
  EXPECT_THAT(run([&] {
                server::WebClient viewer(page());
                drives_and_records(viewer);
                forget();
                ASSERT_TRUE(disk_.freeze());
                viewer.call(server::Service::kRecordStop);
                // STOP overtakes all requests: this one has arrived once the next is answered.
                viewer.write_text(R"({"op":"getParameters","parameterNames":[],"id":"after"})");
                viewer.read_until("\"after\"");
                stops_in_time(viewer, manager);
                // The same must hold during another run, whose recording also waits for the disk.
                forget();
                EXPECT_TRUE(start(viewer));
                stops_in_time(viewer, manager);
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
  EXPECT_GE(replayed_recordings(options_.record).size(), 2U);
}

TEST_F(RunBesideADisk, SigtermDisarmsWhileADiskStandsStill) {
  std::thread thaw;
  EXPECT_EQ(run([&] {
              server::WebClient viewer(page());
              drives_and_records(viewer);
              forget();
              ASSERT_TRUE(disk_.freeze());
              thaw = std::thread([&] {
                eventually(disarmed);
                disk_.thaw();
              });
            }),
            1);
  if (thaw.joinable()) thaw.join();
  EXPECT_GE(replayed_recordings(options_.record).size(), 1U)
      << "the recording must contain the end of the run";
}

TEST_F(Run, ItsFiguresHoldUpNobodyWhereTheyCannotBeWritten) {
  ASSERT_EQ(::mkfifo(options_.daemon.stats_path.c_str(), 0600), 0);
  robot_->plug_in();
  // The first statistics are read, so that the run begins; the next writer blocks in open().
  std::thread first([this] { stats(); });
  std::atomic<bool> over{false};
  std::thread reader;
  EXPECT_EQ(run([&] {
              eventually(commanded);
              std::this_thread::sleep_for(1500ms);
              reader = std::thread([&] {
                eventually(disarmed);
                const int pipe =
                    ::open(options_.daemon.stats_path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
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
