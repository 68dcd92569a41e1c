#include "runs/report_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "core/error.h"

namespace tp100::runs {
namespace {

constexpr std::size_t kMaxKept = 4096;
constexpr std::size_t kMaxLine = 300;

/// The state in which the program begins: standard error into `errors`, standard output into a
/// file, no other files, no blocked signals.
class Beginning {
 public:
  Beginning(int errors, const std::string& output) {
    ::posix_spawn_file_actions_init(&files_);
    ::posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, output.c_str(),
                                       O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::posix_spawn_file_actions_adddup2(&files_, errors, STDERR_FILENO);
    ::posix_spawn_file_actions_addclosefrom_np(&files_, STDERR_FILENO + 1);
    ::posix_spawnattr_init(&attributes_);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~Beginning() {
    ::posix_spawnattr_destroy(&attributes_);
    ::posix_spawn_file_actions_destroy(&files_);
  }
  Beginning(const Beginning&) = delete;
  Beginning& operator=(const Beginning&) = delete;

  /// 0 or an errno.
  int spawn(const std::vector<std::string>& arguments, pid_t& pid) const {
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (const std::string& each : arguments) argv.push_back(const_cast<char*>(each.c_str()));
    argv.push_back(nullptr);
    return ::posix_spawn(&pid, argv[0], &files_, &attributes_, argv.data(), environ);
  }

 private:
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

/// Reads until all writers have closed the pipe, and keeps the last part; false: `until` came
/// first.
bool read_all(int from, std::chrono::steady_clock::time_point until, std::string& kept) {
  std::array<char, 1024> part{};
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        until - std::chrono::steady_clock::now());
    pollfd ready{.fd = from, .events = POLLIN, .revents = 0};
    if (left.count() <= 0 || ::poll(&ready, 1, static_cast<int>(left.count())) == 0) return false;
    const ssize_t got = ::read(from, part.data(), part.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return true;
    kept.append(part.data(), static_cast<std::size_t>(got));
    if (kept.size() > kMaxKept) kept.erase(0, kept.size() - kMaxKept);
  }
}

std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return one_line(text.substr(text.rfind('\n') + 1), kMaxLine);
}

}  // namespace

std::string ReportProcess::run(const std::vector<std::string>& arguments,
                               std::chrono::milliseconds limit, const std::string& output) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::string("no pipe: ") + std::strerror(errno);
  pid_t pid = 0;
  int error = 0;
  {
    const std::lock_guard lock(mutex_);
    error = stopped_ ? ECANCELED : Beginning(ends[1], output).spawn(arguments, pid);
    if (error == 0) pid_ = pid;
  }
  ::close(ends[1]);
  if (error != 0) {
    ::close(ends[0]);
    return arguments[0] + ": cannot be started: " + std::strerror(error);
  }
  // Every other thread of the machine has priority. posix_spawn() cannot set this; if it is
  // refused, the program works all the same.
  const sched_param priority{};
  ::sched_setscheduler(pid, SCHED_IDLE, &priority);
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(pid), 19);
  std::string written;
  const bool in_time = read_all(ends[0], std::chrono::steady_clock::now() + limit, written);
  ::close(ends[0]);
  if (!in_time) ::kill(pid, SIGKILL);
  // The process is reaped only after pid_ is cleared, so that stop() cannot kill another process.
  siginfo_t ended{};
  while (::waitid(P_PID, static_cast<id_t>(pid), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
  }
  int status = 0;
  const std::lock_guard lock(mutex_);
  pid_ = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (stopped_) return "the daemon is shutting down";
  if (!in_time)
    return "not done after " + std::to_string(limit.count() / 1000) + " s; run it by hand";
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  std::string line = last_line(std::move(written));
  if (!line.empty()) return line;
  return WIFSIGNALED(status) ? std::string("killed: ") + strsignal(WTERMSIG(status))
                             : "it ended with status " + std::to_string(WEXITSTATUS(status));
}

void ReportProcess::stop() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

}  // namespace tp100::runs
