// `tp100-sim demo`, which starts a robot and a daemon: they must not outlive it.

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "process.h"
#include "support/paths.h"

namespace tp100::test {
namespace {

/// The child of `parent` whose command line contains `word`; -1 if there is none.
pid_t child_of(pid_t parent, const std::string& word) {
  const std::string parents_line = "PPid:\t" + std::to_string(parent) + "\n";
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    if (read_bytes(entry.path() / "status").find(parents_line) != std::string::npos &&
        read_bytes(entry.path() / "cmdline").find(word) != std::string::npos)
      return std::stoi(entry.path().filename());
  }
  return -1;
}

/// Adopts programs whose parent was killed, so that their end can be waited for.
class Adoption {
 public:
  Adoption() { ::prctl(PR_SET_CHILD_SUBREAPER, 1); }
  ~Adoption() {
    ::prctl(PR_SET_CHILD_SUBREAPER, 0);
    for (const pid_t left : left_) {
      ::kill(left, SIGKILL);
      ::waitpid(left, nullptr, 0);
    }
  }
  Adoption(const Adoption&) = delete;
  Adoption& operator=(const Adoption&) = delete;

  /// Whether the orphan ends by itself; kills it at last otherwise.
  bool ends(pid_t orphan) {
    const bool over = eventually([&] { return ::waitpid(orphan, nullptr, WNOHANG) == orphan; });
    if (!over) left_.push_back(orphan);
    return over;
  }

 private:
  std::vector<pid_t> left_;
};

class Demo : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(Demo, WithoutHeadlessItStaysAndSaysHowToGoOn) {
  Process demo({"/usr/bin/env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY",
                build_path("bin/tp100-sim"), "demo", "--course", short_course(folder_)});
  ASSERT_TRUE(demo.wait_for("scored against exact truth")) << demo.output();
  ASSERT_TRUE(
      demo.wait_for("demo: keeps running after the run. To drive again, press Start on the page"))
      << demo.output();
  // On a busy machine the run may end for any reason.
  ASSERT_TRUE(demo.wait_for("running -> ")) << demo.output();
  ASSERT_TRUE(demo.wait_for("Enter alone is STOP")) << demo.output();
  // Ctrl-C goes to the demo, too, which has to wait for the daemon's disarm.
  demo.signal(SIGINT);
  const pid_t daemon = child_of(demo.pid(), "/tp100d");
  ASSERT_GT(daemon, 0) << demo.output();
  ::kill(daemon, SIGINT);
  EXPECT_GE(demo.wait(), 0);
  EXPECT_LT(demo.wait(), 128) << demo.output();
}

TEST_F(Demo, AKilledDemoTakesItsRobotAndItsDaemonWithIt) {
  Adoption adoption;
  // The temporary files of a killed program are removed with the test's folder.
  Process demo({"/usr/bin/env", "TMPDIR=" + folder_.path().string(), build_path("bin/tp100-sim"),
                "demo", "--headless", "--course", short_course(folder_)});
  ASSERT_TRUE(demo.wait_for("arming -> running")) << demo.output();
  const pid_t robot = child_of(demo.pid(), "tp100-sim");
  const pid_t daemon = child_of(demo.pid(), "/tp100d");
  ASSERT_GT(robot, 0);
  ASSERT_GT(daemon, 0);
  demo.signal(SIGKILL);
  EXPECT_EQ(demo.wait(), 128 + SIGKILL);
  EXPECT_TRUE(adoption.ends(daemon)) << demo.output();
  EXPECT_TRUE(adoption.ends(robot)) << demo.output();
  EXPECT_EQ(demo.output().find("running -> finished"), std::string::npos)
      << "the daemon must not have driven on: " << demo.output();
}

}  // namespace
}  // namespace tp100::test
