#include "process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "support/paths.h"

namespace tp100::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

}  // namespace

Process::Process(std::vector<std::string> arguments, int input) {
  if (!arguments[0].starts_with('/')) {
    arguments[0] = build_path("bin/" + arguments[0]);
  }
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe2 failed");
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) {
    // A test that is killed leaves no program behind.
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != parent) _exit(127);
    dup2(input >= 0 ? input : open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(ends[1], STDOUT_FILENO);
    dup2(ends[1], STDERR_FILENO);
    execv(argv[0], argv.data());
    _exit(127);
  }
  ::close(ends[1]);
  pipe_ = ends[0];
  fcntl(pipe_, F_SETFL, O_NONBLOCK);
  if (pid_ < 0) throw std::runtime_error("cannot start " + arguments[0]);
}

Process::~Process() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  ::close(pipe_);
}

bool Process::read_some(std::chrono::milliseconds patience) {
  pollfd descriptor{pipe_, POLLIN, 0};
  poll(&descriptor, 1, static_cast<int>(patience.count()));
  std::array<char, 4096> buffer;
  const ssize_t n = ::read(pipe_, buffer.data(), buffer.size());
  if (n > 0) output_.append(buffer.data(), static_cast<std::size_t>(n));
  return n != 0;
}

bool Process::wait_for(const std::string& text) {
  const auto deadline = Clock::now() + 60s;
  while (Clock::now() < deadline) {
    const std::size_t at = output_.find(text, searched_);
    if (at != std::string::npos) {
      searched_ = at + text.size();
      return true;
    }
    if (!read_some(50ms)) return output_.find(text, searched_) != std::string::npos;
  }
  return false;
}

std::string Process::line_after(const std::string& text) {
  const bool found = wait_for(text);
  const std::size_t at = searched_;
  if (!found || !wait_for("\n")) throw std::runtime_error("no line " + text + ": " + output());
  return output_.substr(at, searched_ - 1 - at);
}

void Process::signal(int number) {
  signalled_ = true;
  // A pid of -1 would mean every process.
  if (pid_ > 0) kill(pid_, number);
}

bool Process::asks_to_start_again() const {
  const std::size_t aborted = output_.find("-> aborted");
  return aborted != std::string::npos && output_.find("type go", aborted) != std::string::npos;
}

int Process::wait() {
  const auto deadline = Clock::now() + 120s;
  while (pid_ > 0 && Clock::now() < deadline) {
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == pid_) {
      pid_ = -1;
      status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      break;
    }
    if (!signalled_ && asks_to_start_again()) break;
    read_some(10ms);
  }
  output();
  return status_;
}

const std::string& Process::output() {
  std::size_t before = 0;
  do {
    before = output_.size();
    read_some(0ms);
  } while (output_.size() != before);
  return output_;
}

Words joined(Words first, const Words& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

Finished run(std::vector<std::string> arguments) {
  Process process(std::move(arguments));
  const int status = process.wait();
  return {status, process.output()};
}

std::unique_ptr<Process> start_robot(const std::string& link, const Words& more) {
  auto robot = std::make_unique<Process>(joined({"tp100-sim", "robot", "--link", link}, more));
  if (!robot->wait_for("linked from")) throw std::runtime_error("no robot: " + robot->output());
  return robot;
}

std::string page_port(Process& daemon) {
  const std::string line = daemon.line_after("page: http://127.0.0.1:");
  return line.substr(0, line.find('/'));
}

double figure(const std::string& stats, const std::string& name) {
  const std::string text = read_bytes(stats), key = "\"" + name + "\": ";
  const std::size_t at = text.find(key);
  return at == std::string::npos ? -1.0 : std::stod(text.substr(at + key.size()));
}

std::string short_course(const TemporaryFolder& folder, double length_m) {
  std::ofstream(folder.file("short.toml"))
      << "[[segment]]\ntype = \"line\"\nlength_m = " << length_m
      << "\n[fence]\nmin_x_m = -0.1\nmax_x_m = 1\n"
         "min_y_m = -0.5\nmax_y_m = 0.5\n";
  return folder.file("short.toml");
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace tp100::test
