// replug [CYCLES]: unplugs the emulated robot again and again while it drives; a client of the page
// starts it again each time. Prints rows of JSON: how soon the loss was detected and the link was
// restored, whether anything grew, and a verdict. Exits with 1 if a cycle failed, the robot moved
// unasked, or memory, descriptors or threads grew. Times are printed but not judged, because the
// machine may be busy.

#include <sched.h>

#include <algorithm>
#include <cstdlib>
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
constexpr double kPeriodMs = 5.0;
constexpr int kSettled = 10;
// Tolerance for the allocator's own variation, as in scripts/soak.
constexpr long kGrowthKib = 8192;

double unix_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// When a message was published.
double published_s(const std::string& frame) {
  std::uint64_t ns = 0;
  for (std::size_t i = 12; i >= 5; --i) ns = ns << 8U | static_cast<std::uint8_t>(frame[i]);
  return static_cast<double>(ns) * 1e-9;
}

class Replug {
 public:
  explicit Replug(int cycles)
      : cycles_(cycles),
        robot_(robot_arguments()),
        linked_(robot_.wait_for("linked from")),
        daemon_(link_, {"--course", "1-curve"}),
        events_(daemon_.port()) {
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

  double time_of_event(const std::string& text) { return published_s(events_.read_until(text)); }
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
    print("unplugged until noticed [ms]", noticed_ms_);
    std::printf("{\"what\":\"of these within a period of the loop\",\"count\":%td}\n",
                std::count_if(noticed_ms_.begin(), noticed_ms_.end(),
                              [](double ms) { return ms <= kPeriodMs; }));
    print("unplugged for 50 ms until ready [ms]", ready_ms_);
    grown("descriptors", static_cast<long>(settled_.descriptors),
          static_cast<long>(now.descriptors), 0);
    grown("threads", static_cast<long>(settled_.threads), static_cast<long>(now.threads), 0);
    grown("memory [KiB]", settled_.resident_kib, now.resident_kib, kGrowthKib);
    std::printf("{\"what\":\"verdict: %s\",\"count\":%d}\n",
                wrong.empty() ? "nothing grew" : wrong.c_str() + 2, cycles_);
    return wrong.empty() ? 0 : 1;
  }

  int cycles_;
  test::TemporaryFolder folder_;
  std::string link_ = folder_.file("robot");
  test::Process robot_;
  bool linked_;
  Daemon daemon_;
  server::WebClient events_;
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
