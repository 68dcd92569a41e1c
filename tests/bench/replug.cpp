// replug [CYCLES]: the emulated robot is unplugged again and again while it drives, and somebody at
// the page starts it anew each time. Rows of JSON: how soon that was noticed and mended, and
// whether anything grew; exits with 1 if a cycle failed, the robot moved unasked or commands
// jumped.

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "../publish/web_client.h"
#include "../run/process.h"
#include "../support/temporary_folder.h"
#include "percentile.h"

namespace tp100 {
namespace {

using namespace std::chrono_literals;
using publish::Channel;
using test::percentile;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kStart = 1;
// Not a multiple of the loop's period, so that every phase of it occurs.
constexpr double kFirstS = 4.0, kEveryS = 2.0013, kAwayS = 0.05;
// Of the robot's drive; what a command is above the one before it beyond that is a jump.
constexpr double kMaxMps2 = 0.6, kJumpMps = 0.01;
// Turns may come late; after a longer time it is another start, from standstill.
constexpr double kPeriodS = 0.005, kLatestS = 0.15;
constexpr int kSettled = 10;

double unix_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// When a message was published, and its text.
struct Message {
  double unix_s = 0.0;
  std::string json;
};

Message parse(const std::string& frame) {
  std::uint64_t ns = 0;
  for (int i = 7; i >= 0; --i)
    ns = ns << 8U | static_cast<std::uint8_t>(frame[5U + static_cast<std::size_t>(i)]);
  return {static_cast<double>(ns) * 1e-9, frame.substr(13)};
}

/// What a process holds.
struct Weight {
  long resident_kib = 0;
  std::size_t descriptors = 0, threads = 0;
};

std::size_t entries(const std::string& folder) {
  const std::filesystem::directory_iterator all(folder);
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

Weight weigh(int pid) {
  const std::string proc = "/proc/" + std::to_string(pid);
  long size = 0, resident = 0;
  std::ifstream(proc + "/statm") >> size >> resident;
  return {resident * 4, entries(proc + "/fd"), entries(proc + "/task")};
}

/// Largest step up between two speeds that were sent one after the other, beyond what the drive's
/// acceleration makes of the time between them.
class CommandWatch {
 public:
  explicit CommandWatch(const std::string& port) : viewer_(port) {
    viewer_.subscribe(Channel::kCommand);
    thread_ = std::jthread([this](const std::stop_token& over) {
      for (; !over.stop_requested(); std::this_thread::sleep_for(20ms)) look();
    });
  }
  double largest_mps() const { return largest_mps_; }

 private:
  void look() {
    for (const std::string& message : viewer_.take()) {
      const std::size_t at = message.find("\"speed_mps\":");
      if (at == std::string::npos) continue;
      const double speed_mps = std::strtod(message.c_str() + at + 12, nullptr);
      const double at_s = parse(message).unix_s;
      const double later_s = at_s - before_s_ < kLatestS ? at_s - before_s_ : kPeriodS;
      largest_mps_ = std::max(largest_mps_.load(),
                              std::abs(speed_mps) - std::abs(before_mps_) - kMaxMps2 * later_s);
      before_mps_ = speed_mps;
      before_s_ = at_s;
    }
  }
  publish::WebClient viewer_;
  double before_mps_ = 0.0, before_s_ = 0.0;
  std::atomic<double> largest_mps_ = 0.0;
  std::jthread thread_;
};

std::string tail(const std::string& text) {
  constexpr std::size_t kMost = 4000;
  return text.size() < kMost ? text : text.substr(text.size() - kMost);
}

void print(const char* what, std::vector<double>& values_ms) {
  std::printf("{\"what\":\"%s [ms]\",\"count\":%zu,\"p50\":%.2f,\"p99\":%.2f,\"max\":%.2f}\n", what,
              values_ms.size(), percentile(values_ms, 0.5), percentile(values_ms, 0.99),
              percentile(values_ms, 1.0));
}

void print(const char* what, double from, double to) {
  std::printf("{\"what\":\"%s\",\"from\":%.4g,\"to\":%.6g}\n", what, from, to);
}

class Replug {
 public:
  explicit Replug(int cycles)
      : cycles_(cycles),
        robot_(robot_arguments()),
        linked_(robot_.wait_for("linked from")),
        daemon_({"tp100d", "run", "--port", link_, "--wait", "--stay", "--course", "1-curve",
                 "--listen", "127.0.0.1:0"}),
        port_(page()),
        events_(port_),
        commands_(port_) {
    events_.subscribe(Channel::kEvent);
  }

  int run() {
    started();
    for (int i = 1; i <= cycles_; ++i) {
      if (!cycle()) {
        std::fprintf(stderr, "replug: cycle %d failed: %s\n%s\n%s\n", i, problem_.c_str(),
                     tail(robot_.output()).c_str(), tail(daemon_.output()).c_str());
        return 1;
      }
      // A pipe that nobody reads is a test of its own.
      static_cast<void>(daemon_.output());
      if (i == kSettled) settled_ = weigh(daemon_.pid());
    }
    return report();
  }

 private:
  std::vector<std::string> robot_arguments() const {
    std::vector<std::string> arguments = {"tp100-sim", "robot", "--link", link_};
    char text[64];
    // On a busy machine a start may take longer than until the next one.
    for (int i = 0; i < cycles_ + cycles_ / 20 + 5; ++i) {
      std::snprintf(text, sizeof text, "unplug:%g@%g", kAwayS, kFirstS + kEveryS * i);
      arguments.insert(arguments.end(), {"--fault", text});
    }
    return arguments;
  }

  std::string page() {
    const std::string before = "http://127.0.0.1:";
    if (!linked_ || !daemon_.wait_for(before)) throw std::runtime_error("no page is served");
    daemon_.wait_for("/");
    const std::string& said = daemon_.output();
    const std::size_t at = said.find(before) + before.size();
    return said.substr(at, said.find('/', at) - at);
  }

  /// The next event with `text`.
  Message event(const std::string& text) { return parse(events_.read_until(text)); }

  /// Presses start until it drives.
  void started() {
    for (const auto give_up = Clock::now() + 60s; Clock::now() < give_up;) {
      events_.call(kStart);
      for (int i = 0; i < 100; ++i) {
        std::this_thread::sleep_for(10ms);
        for (const std::string& message : events_.take())
          if (message.find("-> running") != std::string::npos) return;
      }
    }
    throw std::runtime_error("it does not start");
  }

  bool cycle() try {
    if (!robot_.wait_for("unplugged for")) return fail("the robot is not unplugged");
    const double unplugged_s = unix_s();
    noticed_ms_.push_back(1e3 * (event("ready -> closed").unix_s - unplugged_s));
    ready_ms_.push_back(1e3 * (event("-> ready").unix_s - unplugged_s));
    // Long enough to see that nobody starts it but us.
    std::this_thread::sleep_for(200ms);
    for (const std::string& message : events_.take()) {
      if (message.find("-> arming") != std::string::npos) return fail("it armed by itself");
    }
    started();
    return true;
  } catch (const std::runtime_error& error) {
    return fail(error.what());
  }
  bool fail(const std::string& problem) {
    problem_ = problem;
    return false;
  }

  int report() {
    const Weight now = weigh(daemon_.pid());
    const double jump_mps = commands_.largest_mps();
    std::fprintf(stderr, "replug: %d cycles, back to running each time, armed only when started\n",
                 cycles_);
    print("unplugged until noticed", noticed_ms_);
    print("unplugged for 50 ms until ready", ready_ms_);
    std::printf("{\"what\":\"largest jump of the speed sent [m/s]\",\"to\":%.4g}\n", jump_mps);
    print("descriptors", static_cast<double>(settled_.descriptors),
          static_cast<double>(now.descriptors));
    print("threads", static_cast<double>(settled_.threads), static_cast<double>(now.threads));
    print("memory [MiB]", static_cast<double>(settled_.resident_kib) / 1024.0,
          static_cast<double>(now.resident_kib) / 1024.0);
    const bool grew = cycles_ > kSettled &&
                      (now.descriptors > settled_.descriptors || now.threads > settled_.threads);
    return grew || jump_mps > kJumpMps ? 1 : 0;
  }

  int cycles_;
  test::TemporaryFolder folder_;
  std::string link_ = folder_.file("robot");
  test::Process robot_;
  bool linked_;
  test::Process daemon_;
  std::string port_;
  publish::WebClient events_;
  CommandWatch commands_;
  Weight settled_{};
  std::vector<double> noticed_ms_, ready_ms_;
  std::string problem_;
};

}  // namespace
}  // namespace tp100

int main(int argc, char** argv) try {
  // A stop watch that comes late measures itself.
  const sched_param fifo{.sched_priority = 5};
  ::sched_setscheduler(0, SCHED_FIFO, &fifo);
  return tp100::Replug(argc > 1 ? std::atoi(argv[1]) : 1000).run();
} catch (const std::exception& error) {
  std::fprintf(stderr, "replug: %s\n", error.what());
  return 1;
}
