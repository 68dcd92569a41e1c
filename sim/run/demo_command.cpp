#include "sim/run/demo_command.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/error.h"
#include "sim/run/child.h"
#include "sim/run/course_command.h"

namespace tp100::sim {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// A folder of its own, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "tp100-demo-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
      throw SetupError(pattern + ": cannot create a folder; check $TMPDIR");
    path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void wait_for(const fs::path& link, Child& robot) {
  for (int i = 0; i < 100; ++i) {
    if (fs::exists(link)) return;
    if (!robot.running()) break;
    std::this_thread::sleep_for(50ms);
  }
  throw SetupError("tp100-sim robot did not come up within 5 s; run it by hand to see why");
}

/// Address of the page that a daemon serves, from its figures; empty: it serves none.
std::string page_of(const fs::path& stats, Child& daemon) {
  for (int i = 0; i < 100 && daemon.running(); ++i) {
    std::ifstream file(stats);
    const auto json = nlohmann::json::parse(file, nullptr, false);
    if (json.is_object()) return json.value("page", "");
    std::this_thread::sleep_for(50ms);
  }
  return {};
}

}  // namespace

int run_demo(const DemoCommand& command) {
  const course::Course course = load_course(command.course);
  const Loaded loaded = load(command.options);
  const fs::path programs = fs::read_symlink("/proc/self/exe").parent_path();
  const std::string daemon = (programs / "tp100d").string();
  if (!fs::exists(daemon)) throw SetupError(daemon + ": not there; build the target tp100d");

  const TemporaryFolder folder;
  const std::string link = (folder.path() / "tp100").string();
  const std::string robot_name =
      command.options.robot.empty() ? loaded.robot.name : command.options.robot;
  std::printf("demo: an emulated %s TP100 and the daemon, joined by a serial line, drive %s\n",
              loaded.robot.name.c_str(), course.name.c_str());
  std::fflush(stdout);
  Child robot({(programs / "tp100-sim").string(), "robot", "--link", link, "--robot", robot_name,
               "--board", command.options.board, "--course", command.course, "--seed",
               std::to_string(command.options.seed)},
              command.headless);
  wait_for(link, robot);
  const fs::path stats = folder.path() / "stats.json";
  Child bridge({daemon, "run", "--port", link, "--course", command.course, "--robot", robot_name,
                "--stats", stats.string()},
               command.headless);
  const std::string page = page_of(stats, bridge);
  if (!page.empty()) std::printf("demo: watch it at %s\n", page.c_str());
  std::fflush(stdout);
  const int status = bridge.wait();
  std::printf("demo: live run %s\n\n", status == 0 ? "completed" : "failed");
  std::printf(
      "demo: the same course, robot and seed in virtual time, scored against exact truth\n");
  std::fflush(stdout);
  CourseCommand scored;
  scored.options = command.options;
  scored.course = command.course;
  const int scored_status = run_course(scored);
  return status == 0 && scored_status == 0 ? 0 : 1;
}

}  // namespace tp100::sim
