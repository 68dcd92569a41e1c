// replug [CYCLES]: unplugs the emulated robot again and again while it drives; a client of the page
// starts it again each time. Prints rows of JSON: how soon the loss was detected and the link was
// restored, whether anything grew, and a verdict. Exits with 1 if a cycle failed, the robot moved
// unasked, commands jumped, or memory, descriptors or threads grew. Times are printed but not
// judged, because the machine may be busy.

#include <sched.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "../server/web_client.h"
#include "../support/temporary_folder.h"
#include "../support/weight.h"
#include "rig.h"

namespace tp100::bench {
namespace {

using namespace std::chrono_literals;
using messages::Channel;

constexpr std::uint32_t kStart = 1;
// The interval is not a multiple of the loop's period, so that every phase of the loop occurs.
constexpr double kFirstS = 4.0, kEveryS = 2.0013, kAwayS = 0.05;
// A cycle may be late by up to kLatestS; a longer gap means a new start from standstill.
constexpr double kPeriodS = 0.005, kLatestS = 0.15;
constexpr int kSettled = 10;
// Tolerance for the allocator's own variation, as in scripts/soak.
constexpr long kGrowthKib = 8192;

/// A value of the commands that must not jump: it may move away from zero by `per_s`, from the
/// acceleration of the drive or of its turns on the spot, and by `jump`.
struct Steady {
  const char* name;
  double per_s, jump;
};
constexpr std::array<Steady, 3> kSteady = {{{"speed sent [m/s]", 0.6, 0.01},
                                            {"turn rate sent [rad/s]", 1.5, 0.05},
                                            {"turn asked [rad]", 1.5, 0.02}}};
using Values = std::array<double, kSteady.size()>;

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
  Values largest() const {
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
  void compare(const Values& now, double later_s) {
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < now.size(); ++i) {
      // If the sign changed, all of the new value counts.
      const double before = now[i] * before_[i] > 0.0 ? std::abs(before_[i]) : 0.0;
      largest_[i] = std::max(largest_[i], std::abs(now[i]) - before - kSteady[i].per_s * later_s);
    }
    before_ = now;
  }
  server::WebClient viewer_;
  Values before_{};
  double before_s_ = 0.0;
  mutable std::mutex mutex_;
  Values largest_{};
  std::jthread thread_;
};

class Replug {
 public:
  explicit Replug(int cycles)
      : cycles_(cycles),
        robot_(robot_arguments()),
        linked_(robot_.wait_for("linked from")),
        daemon_(link_, {"--course", "1-curve"}),
        events_(daemon_.port()),
        commands_(daemon_.port()) {
    if (!linked_) throw std::runtime_error("no emulated robot");
    events_.subscribe(Channel::kEvent);
  }

  int run() {
    start();
    for (int i = 1; i <= cycles_; ++i) {
      try {
        cycle();
      } catch (const std::runtime_error& error) {
        throw std::runtime_error("cycle " + std::to_string(i) + ": " + error.what() + "\n" +
                                 robot_.output() + daemon_.process().output());
      }
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

  double time_of_event(const std::string& text) { return parse(events_.read_until(text)).unix_s; }
  test::Weight weigh() { return test::weigh(std::to_string(daemon_.process().pid())); }

  /// Requests a start until the robot drives.
  void start() {
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

  void cycle() {
    if (!robot_.wait_for("unplugged for")) throw std::runtime_error("the robot is not unplugged");
    const double unplugged_s = unix_s();
    noticed_ms_.push_back(1e3 * (time_of_event("ready -> closed") - unplugged_s));
    ready_ms_.push_back(1e3 * (time_of_event("-> ready") - unplugged_s));
    // This is long enough to detect a start that this program did not request.
    std::this_thread::sleep_for(200ms);
    for (const std::string& message : events_.take()) {
      if (message.find("-> arming") != std::string::npos)
        throw std::runtime_error("it armed by itself");
    }
    start();
    // The output is drained here; another test covers a pipe that nobody reads.
    static_cast<void>(daemon_.process().output());
  }

  int report() {
    std::string wrong;
    const auto grown = [&](const char* what, long from, long to, long allowed) {
      std::printf("{\"what\":\"%s\",\"from\":%ld,\"to\":%ld}\n", what, from, to);
      if (cycles_ > kSettled && to - from > allowed) wrong += std::string(", grown: ") + what;
    };
    const test::Weight now = weigh();
    const Values jumps = commands_.largest();
    print("unplugged until noticed [ms]", noticed_ms_);
    std::printf("{\"what\":\"of these within a period of the loop\",\"count\":%td}\n",
                std::count_if(noticed_ms_.begin(), noticed_ms_.end(),
                              [](double ms) { return ms <= 1e3 * kPeriodS; }));
    print("unplugged for 50 ms until ready [ms]", ready_ms_);
    for (std::size_t i = 0; i < jumps.size(); ++i) {
      std::printf("{\"what\":\"largest jump of the %s\",\"to\":%.4g}\n", kSteady[i].name, jumps[i]);
      if (jumps[i] > kSteady[i].jump) wrong += std::string(", a jump: ") + kSteady[i].name;
    }
    grown("descriptors", static_cast<long>(settled_.descriptors),
          static_cast<long>(now.descriptors), 0);
    grown("threads", static_cast<long>(settled_.threads), static_cast<long>(now.threads), 0);
    grown("memory [KiB]", settled_.resident_kib, now.resident_kib, kGrowthKib);
    std::printf("{\"what\":\"verdict: %s\",\"count\":%d}\n",
                wrong.empty() ? "nothing grew, nothing jumped" : wrong.c_str() + 2, cycles_);
    return wrong.empty() ? 0 : 1;
  }

  int cycles_;
  test::TemporaryFolder folder_;
  std::string link_ = folder_.file("robot");
  test::Process robot_;
  bool linked_;
  Daemon daemon_;
  server::WebClient events_;
  CommandWatch commands_;
  test::Weight settled_{};
  std::vector<double> noticed_ms_, ready_ms_;
};

}  // namespace
}  // namespace tp100::bench

int main(int argc, char** argv) try {
  // A thread that is scheduled late would measure its own delay.
  const sched_param fifo{.sched_priority = 5};
  ::sched_setscheduler(0, SCHED_FIFO, &fifo);
  return tp100::bench::Replug(argc > 1 ? std::atoi(argv[1]) : 1000).run();
} catch (const std::exception& error) {
  std::fprintf(stderr, "replug: %s\n", error.what());
  return 1;
}
