// stop_bench [ROUNDS [RUNS]]: measures how soon STOP is on the wire while the disk of the
// recordings is frozen, and while 40 clients read a folder of RUNS runs in a loop; and the longest
// time in which the service manager receives no watchdog message. Prints rows of JSON [ms]. Needs
// root and a loop device for the disk.

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "../live/pty_robot.h"
#include "../programs/process.h"
#include "../server/web_client.h"
#include "../support/frozen_disk.h"
#include "../support/temporary_folder.h"
#include "core/statistics.h"

namespace tp100 {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kStart = 1, kStop = 3, kRecordStop = 5;
constexpr int kReaders = 40;

double ms_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

void print(const std::string& what, std::vector<double> values_ms) {
  std::printf("{\"what\":\"%s\",\"count\":%zu,\"p50\":%.2f,\"max\":%.2f}\n", what.c_str(),
              values_ms.size(), percentile(values_ms, 0.5), percentile(values_ms, 1.0));
  std::fflush(stdout);
}

/// A service manager that measures the longest time without WATCHDOG=1.
class Manager {
 public:
  Manager() : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    const std::string name = "@tp100-stop-bench-" + std::to_string(::getpid());
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::copy(name.begin() + 1, name.end(), address.sun_path + 1);
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    if (::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size) != 0)
      throw std::runtime_error("no notify socket");
    ::setenv("NOTIFY_SOCKET", name.c_str(), 1);
    ::setenv("WATCHDOG_USEC", "2000000", 1);
  }
  ~Manager() { ::close(socket_); }
  Manager(const Manager&) = delete;
  Manager& operator=(const Manager&) = delete;

  /// The longest time without WATCHDOG=1 during `time`.
  double longest_silence_ms(std::chrono::milliseconds time) const {
    char text[4096];
    while (::recv(socket_, text, sizeof text, MSG_DONTWAIT) > 0) {
    }
    double longest = 0.0;
    const auto begin = Clock::now();
    auto last = begin;
    while (Clock::now() < begin + time) {
      const ssize_t n = ::recv(socket_, text, sizeof text, MSG_DONTWAIT);
      if (n > 0 && std::string(text, static_cast<std::size_t>(n)) == "WATCHDOG=1")
        last = Clock::now();
      longest = std::max(longest, ms_since(last));
      std::this_thread::sleep_for(1ms);
    }
    return longest;
  }

 private:
  int socket_;
};

/// A driving robot with its daemon.
class Drive {
 public:
  explicit Drive(const std::string& runs, int keyboard, const std::vector<std::string>& more = {})
      : link_(folder_.file("robot")), robot_(link_) {
    robot_.plug_in();
    std::vector<std::string> arguments = {"tp100d",     "run",      "--port",     link_,
                                          "--wait",     "--stay",   "--go",       "--course",
                                          "1-straight", "--listen", "127.0.0.1:0"};
    if (!runs.empty()) arguments.insert(arguments.end(), {"--record", runs});
    arguments.insert(arguments.end(), more.begin(), more.end());
    daemon_ = std::make_unique<test::Process>(arguments, keyboard);
    const std::string before = "http://127.0.0.1:";
    if (!daemon_->wait_for(before)) throw std::runtime_error("no page: " + last_line());
    daemon_->wait_for("/");
    const std::string& output = daemon_->output();
    const std::size_t at = output.find(before) + before.size();
    port_ = output.substr(at, output.find('/', at) - at);
    viewer_ = std::make_unique<server::WebClient>(port_);
  }

  const std::string& port() const { return port_; }
  server::WebClient& viewer() { return *viewer_; }
  test::Process& daemon() { return *daemon_; }

  /// Requests a start until the robot drives, then waits until a recording has begun.
  void start() {
    robot_.with([](ScriptedRobot& robot) { robot.received = {}; });
    for (int i = 0; i < 600 && !drives(); ++i) {
      if (i % 10 == 0) viewer_->call(kStart);
      std::this_thread::sleep_for(20ms);
    }
    if (!drives()) throw std::runtime_error("it does not drive: " + last_line());
    std::this_thread::sleep_for(200ms);
    robot_.with([](ScriptedRobot& robot) { robot.received = {}; });
    viewer_->drain();
    static_cast<void>(daemon_->output());
  }
  /// Time from `press` until the robot has received a STOP, or the disarm at the end of a run.
  double pressed(const std::function<void()>& press) {
    const auto begin = Clock::now();
    press();
    for (;;) {
      const bool received = robot_.with([](ScriptedRobot& robot) {
        return !robot.received.stops.empty() || !robot.received.disarms.empty();
      });
      if (received || ms_since(begin) > 20'000) return ms_since(begin);
      std::this_thread::sleep_for(200us);
    }
  }

 private:
  std::string last_line() {
    const std::string& output = daemon_->output();
    const std::size_t end = output.find_last_not_of('\n');
    return output.substr(output.rfind('\n', end) + 1);
  }
  bool drives() {
    return robot_.with([](ScriptedRobot& robot) {
      return !robot.received.commands.empty() && robot.received.commands.back().speed_mps > 0.0F;
    });
  }

  test::TemporaryFolder folder_;
  std::string link_;
  PtyRobot robot_;
  std::unique_ptr<test::Process> daemon_;
  std::string port_;
  std::unique_ptr<server::WebClient> viewer_;
};

void beside_a_frozen_disk(int rounds) {
  test::FrozenDisk disk;
  if (!disk.available()) {
    std::fprintf(stderr, "stop_bench: no file system can be frozen here (root, loop device)\n");
    return;
  }
  const Manager manager;
  const std::string runs = disk.path() + "/runs";
  int keyboard[2];
  if (::pipe2(keyboard, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  const auto enter = [&] {
    if (::write(keyboard[1], "\n", 1) != 1) std::perror("enter");
  };
  std::vector<double> silence;
  {
    Drive drive(runs, keyboard[0]);
    for (const bool page : {true, false}) {
      std::vector<double> took;
      for (int i = 0; i < rounds; ++i) {
        drive.start();
        disk.freeze();
        std::this_thread::sleep_for(100ms);
        // A client ends the recording, which blocks on the disk, and then STOP is pressed.
        if (page) drive.viewer().call(kRecordStop);
        took.push_back(drive.pressed([&] { page ? drive.viewer().call(kStop) : enter(); }));
        silence.push_back(manager.longest_silence_ms(3s));
        disk.thaw();
        std::this_thread::sleep_for(1500ms);
      }
      print(page ? "frozen disk: STOP of the page" : "frozen disk: Enter", took);
    }
  }
  for (const int signal : {SIGINT, SIGTERM}) {
    std::vector<double> took;
    for (int i = 0; i < rounds; ++i) {
      Drive drive(runs, keyboard[0]);
      drive.start();
      disk.freeze();
      std::this_thread::sleep_for(100ms);
      took.push_back(drive.pressed([&] { drive.daemon().signal(signal); }));
      silence.push_back(manager.longest_silence_ms(3s));
      disk.thaw();
      drive.daemon().wait();
    }
    print(signal == SIGINT ? "frozen disk: Ctrl-C" : "frozen disk: SIGTERM", took);
  }
  print("frozen disk: longest silence of the watchdog in 3 s", silence);
  ::unsetenv("NOTIFY_SOCKET");
}

void give_up() {
  const test::TemporaryFolder folder;
  const std::string pipe = folder.file("stats");
  if (::mkfifo(pipe.c_str(), 0600) != 0) return;
  // Only the first figures are read; writing the next ones blocks forever.
  std::thread first([&] { std::ifstream(pipe).ignore(1 << 20); });
  Drive drive({}, -1, {"--stats", pipe});
  first.join();
  drive.start();
  std::this_thread::sleep_for(1100ms);
  drive.daemon().signal(SIGTERM);
  const auto begin = Clock::now();
  const int status = drive.daemon().wait();
  print("stats never written: to the end, with status " + std::to_string(status),
        {ms_since(begin)});
}

void beside_readers(int rounds, int runs) {
  const test::TemporaryFolder folder;
  for (int i = 0; i < runs; ++i) {
    const std::string run = folder.file("run-" + std::to_string(i));
    std::filesystem::create_directory(run);
    std::ofstream(run + "/run.mcap") << std::string(i < kReaders ? 1'000'000 : 1, 'x');
  }
  Drive drive(folder.path(), -1);
  std::atomic<bool> over{false};
  std::atomic<int> answers{0};
  std::vector<std::thread> readers;
  for (int i = 0; i < kReaders; ++i)
    readers.emplace_back([&, i] {
      const std::string file = "/runs/run-" + std::to_string(i) + "/run.mcap";
      while (!over) {
        for (const std::string& target :
             {std::string("/api/runs"), std::string("/"), std::string("/healthz"), file}) {
          try {
            server::http_get(drive.port(),
                             "GET " + target + " HTTP/1.0\r\nHost: localhost\r\n\r\n");
            ++answers;
          } catch (const std::runtime_error&) {
          }
        }
      }
    });
  std::vector<double> took;
  for (int i = 0; i < rounds; ++i) {
    drive.start();
    took.push_back(drive.pressed([&] { drive.viewer().call(kStop); }));
    std::this_thread::sleep_for(300ms);
  }
  over = true;
  for (std::thread& reader : readers) reader.join();
  print(std::to_string(kReaders) + " readers of " + std::to_string(runs) + " runs, " +
            std::to_string(answers) + " answers: STOP of the page",
        took);
}

}  // namespace
}  // namespace tp100

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 5;
  const int runs = argc > 2 ? std::atoi(argv[2]) : 5000;
  try {
    tp100::beside_a_frozen_disk(rounds);
    tp100::give_up();
    tp100::beside_readers(rounds, runs);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stop_bench: %s\n", error.what());
    return 1;
  }
  return 0;
}
