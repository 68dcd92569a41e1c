// tp100d under a service manager: its messages, and that it stops feeding the watchdog when its
// loop hangs.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "../support/notify_socket.h"
#include "process.h"
#include "support/paths.h"

namespace tp100::test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

/// The real-time thread of tp100d, the only one that requests exact timers; 0 if it cannot be
/// determined.
pid_t loop_thread(pid_t program) {
  const std::string tasks = "/proc/" + std::to_string(program) + "/task";
  for (const auto& task : std::filesystem::directory_iterator(tasks)) {
    std::ifstream file("/proc/" + task.path().filename().string() + "/timerslack_ns");
    long slack_ns = 0;
    // Newer kernels report 0 for a thread with SCHED_FIFO.
    if (file >> slack_ns && slack_ns <= 1) return std::stoi(task.path().filename().string());
  }
  return 0;
}

/// Stops one thread of a child process during its lifetime.
class HungThread {
 public:
  explicit HungThread(pid_t thread) : thread_(thread) {
    EXPECT_EQ(::ptrace(PTRACE_SEIZE, thread_, nullptr, nullptr), 0);
    EXPECT_EQ(::ptrace(PTRACE_INTERRUPT, thread_, nullptr, nullptr), 0);
    EXPECT_EQ(::waitpid(thread_, nullptr, __WALL), thread_);
  }
  ~HungThread() { ::ptrace(PTRACE_DETACH, thread_, nullptr, nullptr); }
  HungThread(const HungThread&) = delete;
  HungThread& operator=(const HungThread&) = delete;

 private:
  pid_t thread_;
};

TEST(Service, AHungLoopStarvesTheWatchdogThoughTheRestOfTheDaemonLives) {
  const TemporaryFolder folder;
  const NotifySocket manager(folder.file("notify"));
  ::setenv("NOTIFY_SOCKET", folder.file("notify").c_str(), 1);
  ::setenv("WATCHDOG_USEC", "400000", 1);
  Process bridge({"tp100d", "run", "--wait", "--port", folder.file("none"), "--listen", "off"});
  ::unsetenv("NOTIFY_SOCKET");
  ::unsetenv("WATCHDOG_USEC");
  ASSERT_TRUE(manager.hears("READY=1", 20s)) << bridge.output();
  ASSERT_TRUE(manager.hears("WATCHDOG=1", 10s)) << bridge.output();
  const pid_t thread = loop_thread(bridge.pid());
  if (thread == 0) GTEST_SKIP() << "which thread is the loop is for root to know; run it as root";
  {
    const HungThread hung(thread);
    // One more message may be due for earlier cycles.
    manager.hears("WATCHDOG=1", 200ms);
    EXPECT_FALSE(manager.hears("WATCHDOG=1", 1s));
    bridge.signal(SIGTERM);
    EXPECT_TRUE(manager.hears("STOPPING=1", 10s)) << "the other thread must still run";
  }
  EXPECT_EQ(bridge.wait(), 1) << bridge.output();
}

// For systemd, status 1 is no failure, and status 2 is a failure that a restart cannot fix.
TEST(Service, IsNotRestartedAfterABadFile) {
  const std::string unit = read_bytes(source_path("config/systemd/tp100d@.service"));
  for (const char* line :
       {"\nRestart=on-failure\n", "\nSuccessExitStatus=1\n", "\nRestartPreventExitStatus=2\n"})
    EXPECT_THAT(unit, HasSubstr(line));
  const TemporaryFolder folder;
  write_bytes(folder.file("bad.toml"), "robto = 1\n");
  EXPECT_EQ(run({"tp100d", "run", "--wait", "--config", folder.file("bad.toml")}).status, 2);
}

TEST(Service, IsRestartedAfterWhatNoFileExplains) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer needs descriptors itself, of which there are none here";
#endif
  const std::string script = "exec 3>&- 4>&- 5>&- 6>&- 7>&- 8>&- 9>&-; ulimit -n 6; exec " +
                             build_path("bin/tp100d") + " run --wait --port none --listen off";
  const Finished starved = run({"/bin/sh", "-c", script});
  EXPECT_EQ(starved.status, 3);
  EXPECT_THAT(starved.output, HasSubstr("tp100d: stopped: "));
  EXPECT_THAT(starved.output, HasSubstr("Too many open files; start it again"));
}

}  // namespace
}  // namespace tp100::test
