// replug [CYCLES]: unplugs the emulated robot again and again while it drives; a client of the page
// starts it again each time. Prints rows of JSON: how soon the loss was detected and the link was
// restored, whether anything grew, and a verdict. Exits with 1 if a cycle failed, the robot moved
// unasked, commands jumped, or memory, descriptors or threads grew. Times are printed but not
// judged, because the machine may be busy.

#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "../programs/process.h"
#include "../server/web_client.h"
#include "../support/temporary_folder.h"
#include "../support/weight.h"
#include "core/statistics.h"

namespace tp100 {
namespace {

using namespace std::chrono_literals;
using messages::Channel;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kStart = 1;
// The interval is not a multiple of the loop's period, so that every phase of the loop occurs.
constexpr double kFirstS = 4.0, kEveryS = 2.0013, kAwayS = 0.05;
// The accelerations of the robot's drive and of its turns on the spot. A command that exceeds the
// one before it by more than this acceleration allows, plus kJump, counts as a jump.
constexpr double kMaxMps2 = 0.6, kJumpMps = 0.01;
constexpr double kMaxRadps2 = 1.5, kJumpRadps = 0.05;
// The desired yaw may move away from the estimated yaw at most at the highest yaw rate.
constexpr double kMaxRadps = 1.5, kJumpRad = 0.02;
// A cycle may be late by up to kLatestS; a longer gap means a new start from standstill.
constexpr double kPeriodS = 0.005, kLatestS = 0.15;
constexpr int kSettled = 10;
// Tolerance for the allocator's own variation, as in scripts/soak.
constexpr long kGrowthKib = 8192;

double unix_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Publication time and text of a message.
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

/// The number after `"key":` in a message; 0 if there is none.
double number(const std::string& json, const std::string& key) {
  const std::string before = '"' + key + "\":";
  const std::size_t at = json.find(before);
  return at == std::string::npos ? 0.0 : std::strtod(json.c_str() + at + before.size(), nullptr);
}

/// How much further from zero `now` is than `before`; if the sign changed, all of `now` counts.
double step_up(double now, double before) {
  return std::abs(now) - (now * before > 0.0 ? std::abs(before) : 0.0);
}

/// The motion that a command requests from the robot.
struct Asked {
  double speed_mps = 0.0, yaw_rate_radps = 0.0;
  double turn_rad = 0.0;  ///< desired yaw minus estimated yaw
};

/// Largest increases between two consecutive commands, beyond what the drive's limits allow in the
/// time between them.
class CommandWatch {
 public:
  explicit CommandWatch(const std::string& port) : viewer_(port) {
    viewer_.subscribe(Channel::kCommand);
    thread_ = std::jthread([this](const std::stop_token& over) {
      for (; !over.stop_requested(); std::this_thread::sleep_for(20ms)) look();
    });
  }
  Asked largest() const {
    const std::lock_guard lock(mutex_);
    return largest_;
  }

 private:
  void look() {
    for (const std::string& frame : viewer_.take()) {
      if (frame.find("\"speed_mps\":") == std::string::npos) continue;
      const Message message = parse(frame);
      const double passed_s = message.unix_s - before_s_;
      compare({number(message.json, "speed_mps"), number(message.json, "yaw_rate_radps"),
               number(message.json, "desired_yaw_rad") - number(message.json, "yaw_rad")},
              passed_s < kLatestS ? passed_s : kPeriodS);
      before_s_ = message.unix_s;
    }
  }
  void compare(const Asked& now, double later_s) {
    const std::lock_guard lock(mutex_);
    largest_.speed_mps = std::max(largest_.speed_mps,
                                  step_up(now.speed_mps, before_.speed_mps) - kMaxMps2 * later_s);
    largest_.yaw_rate_radps =
        std::max(largest_.yaw_rate_radps,
                 step_up(now.yaw_rate_radps, before_.yaw_rate_radps) - kMaxRadps2 * later_s);
    largest_.turn_rad =
        std::max(largest_.turn_rad, step_up(now.turn_rad, before_.turn_rad) - kMaxRadps * later_s);
    before_ = now;
  }
  server::WebClient viewer_;
  Asked before_{};
  double before_s_ = 0.0;
  mutable std::mutex mutex_;
  Asked largest_{};
  std::jthread thread_;
};

std::string tail(const std::string& text) {
  constexpr std::size_t kMax = 4000;
  return text.size() < kMax ? text : text.substr(text.size() - kMax);
}

void print(const char* what, std::vector<double>& values_ms) {
  std::printf("{\"what\":\"%s [ms]\",\"count\":%zu,\"p50\":%.2f,\"p99\":%.2f,\"max\":%.2f}\n", what,
              values_ms.size(), percentile(values_ms, 0.5), percentile(values_ms, 0.99),
              percentile(values_ms, 1.0));
}

void print(const char* what, double value) {
  std::printf("{\"what\":\"%s\",\"to\":%.4g}\n", what, value);
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
      // The output is drained here; another test covers a pipe that nobody reads.
      static_cast<void>(daemon_.output());
      if (i == kSettled) settled_ = weigh();
    }
    return report();
  }

 private:
  std::vector<std::string> robot_arguments() const {
    std::vector<std::string> arguments = {"tp100-sim", "robot", "--link", link_};
    char text[64];
    // Extra faults are planned, because on a busy machine a start may take longer than the time to
    // the next fault.
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
    const std::string& output = daemon_.output();
    const std::size_t at = output.find(before) + before.size();
    return output.substr(at, output.find('/', at) - at);
  }

  /// The next event that contains `text`.
  Message event(const std::string& text) { return parse(events_.read_until(text)); }

  /// Requests a start until the robot drives.
  void started() {
    for (const auto give_up = Clock::now() + 60s; Clock::now() < give_up;) {
      events_.call(kStart);
      for (int i = 0; i < 100; ++i) {
        std::this_thread::sleep_for(10ms);
        for (const std::string& message : events_.take()) {
          if (message.find("-> running") != std::string::npos) return;
          // On a busy machine the robot may be unplugged again before it drives; this does not
          // count as a cycle.
          if (message.find("-> closed") != std::string::npos) robot_.wait_for("unplugged for");
        }
      }
    }
    throw std::runtime_error("it does not start");
  }

  bool cycle() try {
    if (!robot_.wait_for("unplugged for")) return fail("the robot is not unplugged");
    const double unplugged_s = unix_s();
    noticed_ms_.push_back(1e3 * (event("ready -> closed").unix_s - unplugged_s));
    ready_ms_.push_back(1e3 * (event("-> ready").unix_s - unplugged_s));
    // This is long enough to detect a start that this program did not request.
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

  test::Weight weigh() const { return test::weigh(std::to_string(daemon_.pid())); }

  int report() {
    const test::Weight now = weigh();
    const Asked jump = commands_.largest();
    std::fprintf(stderr, "replug: %d cycles, back to running each time, armed only when started\n",
                 cycles_);
    print("unplugged until noticed", noticed_ms_);
    std::printf("{\"what\":\"of these within a period of the loop\",\"count\":%td}\n",
                std::count_if(noticed_ms_.begin(), noticed_ms_.end(),
                              [](double ms) { return ms <= 1e3 * kPeriodS; }));
    print("unplugged for 50 ms until ready", ready_ms_);
    print("largest jump of the speed sent [m/s]", jump.speed_mps);
    print("largest jump of the turn rate sent [rad/s]", jump.yaw_rate_radps);
    print("largest jump of the turn asked [rad]", jump.turn_rad);
    print("descriptors", static_cast<double>(settled_.descriptors),
          static_cast<double>(now.descriptors));
    print("threads", static_cast<double>(settled_.threads), static_cast<double>(now.threads));
    print("memory [MiB]", static_cast<double>(settled_.resident_kib) / 1024.0,
          static_cast<double>(now.resident_kib) / 1024.0);
    return verdict(now, jump);
  }
  int verdict(const test::Weight& now, const Asked& jump) const {
    std::string wrong;
    const auto add = [&wrong](bool bad, const char* what) {
      if (bad) wrong += (wrong.empty() ? "" : ", ") + std::string(what);
    };
    add(jump.speed_mps > kJumpMps, "the speed jumped");
    add(jump.yaw_rate_radps > kJumpRadps, "the turn rate jumped");
    add(jump.turn_rad > kJumpRad, "the turn asked jumped");
    if (cycles_ > kSettled) {
      add(now.descriptors > settled_.descriptors, "descriptors grew");
      add(now.threads > settled_.threads, "threads grew");
      add(now.resident_kib - settled_.resident_kib > kGrowthKib, "memory grew");
    }
    std::printf("{\"what\":\"verdict: %s\",\"count\":%d}\n",
                wrong.empty() ? "nothing grew, nothing jumped" : wrong.c_str(), cycles_);
    return wrong.empty() ? 0 : 1;
  }

  int cycles_;
  test::TemporaryFolder folder_;
  std::string link_ = folder_.file("robot");
  test::Process robot_;
  bool linked_;
  test::Process daemon_;
  std::string port_;
  server::WebClient events_;
  CommandWatch commands_;
  test::Weight settled_{};
  std::vector<double> noticed_ms_, ready_ms_;
  std::string problem_;
};

}  // namespace
}  // namespace tp100

int main(int argc, char** argv) try {
  // A thread that is scheduled late would measure its own delay.
  const sched_param fifo{.sched_priority = 5};
  ::sched_setscheduler(0, SCHED_FIFO, &fifo);
  return tp100::Replug(argc > 1 ? std::atoi(argv[1]) : 1000).run();
} catch (const std::exception& error) {
  std::fprintf(stderr, "replug: %s\n", error.what());
  return 1;
}
