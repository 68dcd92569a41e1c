#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "core/error.h"
#include "sim/robot/commands.h"

namespace tp100::sim {
namespace {

/// A child process. Terminated and waited for when it goes out of scope, and terminated when this
/// program ends for any reason.
class Child {
 public:
  struct Ways {
    bool quiet = false;  ///< its standard output is discarded
    bool apart = false;  ///< the terminal's Ctrl-C does not reach it
  };
  /// Starts arguments[0]. Throws UserError; if the program cannot be executed, the child prints
  /// the error and ends with status 127.
  Child(const std::vector<std::string>& arguments, Ways ways);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Waits for the end; returns the exit status, 128 + signal if it was killed.
  int wait();
  /// True while it runs.
  bool running();

 private:
  pid_t pid_ = -1;
  int status_ = 0;
};

int exit_status(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

Child::Child(const std::vector<std::string>& arguments, Ways ways) {
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ < 0) throw UserError(arguments[0] + ": cannot start: " + std::strerror(errno));
  if (pid_ > 0) return;
  // The parent may have ended before the signal was requested.
  if (prctl(PR_SET_PDEATHSIG, SIGTERM) != 0 || getppid() != parent) _exit(127);
  if (ways.apart) setpgid(0, 0);
  if (ways.quiet) dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
  execv(argv[0], argv.data());
  std::perror(argv[0]);
  _exit(127);
}

Child::~Child() {
  if (!running()) return;
  kill(pid_, SIGTERM);
  wait();
}

bool Child::running() {
  if (pid_ < 0) return false;
  if (waitpid(pid_, &status_, WNOHANG) == 0) return true;
  pid_ = -1;
  return false;
}

int Child::wait() {
  if (pid_ >= 0) {
    while (waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
  }
  return exit_status(status_);
}

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// A folder of its own, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "tp100-demo-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
      throw UserError(pattern + ": cannot create a folder; check $TMPDIR");
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
  throw UserError("tp100-sim robot did not come up within 5 s; run it by hand to see why");
}

/// Address of the page that a daemon serves, from its figures; empty: no page.
std::string page_of(const fs::path& stats, Child& daemon) {
  for (int i = 0; i < 100 && daemon.running(); ++i) {
    // There is no file at first.
    std::ifstream file(stats);
    const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
    if (json.is_object()) return json.value("page", "");
    std::this_thread::sleep_for(50ms);
  }
  return {};
}

/// Opens the page in the user's browser, if there is a screen.
void show(const std::string& page) {
  const bool screen =
      std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
  const char* const opener = "/usr/bin/xdg-open";
  if (page.empty() || !screen || !fs::exists(opener)) return;
  Child browser({opener, page}, {.quiet = true, .apart = true});
  browser.wait();
}

/// Drives it live. Returns the daemon's exit status.
int drive(const DemoCommand& command, const fs::path& programs, const std::string& robot_name) {
  const TemporaryFolder folder;
  const std::string link = (folder.path() / "tp100").string();
  const fs::path stats = folder.path() / "stats.json";
  Child robot({(programs / "tp100-sim").string(), "robot", "--link", link, "--robot", robot_name,
               "--board", command.options.board, "--course", command.course, "--seed",
               std::to_string(command.options.seed)},
              {.quiet = command.headless, .apart = true});
  wait_for(link, robot);
  // Without --go the daemon waits for the user after a broken link.
  std::vector<std::string> arguments = {(programs / "tp100d").string(),
                                        "run",
                                        "--port",
                                        link,
                                        "--course",
                                        command.course,
                                        "--robot",
                                        robot_name,
                                        "--stats",
                                        stats.string(),
                                        "--go"};
  if (!command.headless)
    for (const std::string& each :
         {std::string("--stay"), std::string("--record"), (folder.path() / "runs").string()})
      arguments.push_back(each);
  Child bridge(arguments, {.quiet = command.headless});
  const std::string page = page_of(stats, bridge);
  if (!page.empty()) std::printf("demo: watch it at %s\n", page.c_str());
  if (!command.headless) {
    // Ctrl-C ends the daemon, which disarms first.
    std::signal(SIGINT, SIG_IGN);
    show(page);
    std::printf(
        "demo: keeps running after the run. To drive again, press Start on the page, or type go "
        "start "
        "and press Enter here; Enter alone is STOP; Ctrl-C ends the demo, and removes its "
        "recordings\n");
  }
  std::fflush(stdout);
  return bridge.wait();
}

int run_scored(const DemoCommand& command) {
  std::printf("demo: this course, robot and seed in virtual time, scored against exact truth\n");
  std::fflush(stdout);
  CourseCommand scored;
  scored.options = command.options;
  scored.course = command.course;
  return run_course(scored);
}

}  // namespace

int run_demo(const DemoCommand& command) {
  const course::Course course = load_course(command.course);
  const Loaded loaded = load(command.options);
  const fs::path programs = fs::read_symlink("/proc/self/exe").parent_path();
  const std::string daemon = (programs / "tp100d").string();
  if (!fs::exists(daemon)) throw UserError(daemon + ": not there; build the target tp100d");

  const std::string robot_name =
      command.options.robot.empty() ? loaded.robot.name : command.options.robot;
  std::printf("demo: an emulated %s TP100 and the daemon, joined by a serial line, drive %s\n",
              loaded.robot.name.c_str(), course.name.c_str());
  std::fflush(stdout);
  int scored_status = 0;
  if (!command.headless) scored_status = run_scored(command);
  const int live_status = drive(command, programs, robot_name);
  if (command.headless) {
    std::printf("demo: live run %s\n\n", live_status == 0 ? "completed" : "failed");
    scored_status = run_scored(command);
  }
  return live_status == 0 && scored_status == 0 ? 0 : 1;
}

}  // namespace tp100::sim
