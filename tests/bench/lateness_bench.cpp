// lateness_bench RATE_HZ SPIN_US SECONDS [CPU]: runs the daemon's loop with its usual privileges
// and no work. Prints one JSON object with a histogram of the lateness of its cycles.

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/clock.h"
#include "core/error.h"
#include "loop/fixed_rate_loop.h"

namespace tp100 {
namespace {

class Idle : public loop::LoopClient {
 public:
  void opened(HostNs) override {}
  void closed(HostNs) override {}
  bool received(std::span<const std::uint8_t>, HostNs) override { return false; }
  void step(HostNs) override {}
  void after_write(HostNs) override {}
  std::span<const std::uint8_t> output() override { return {}; }
  void written(std::size_t) override {}
  void drop_output() override {}
  bool expects_reply(HostNs) override { return false; }
  bool take_port_drop() override { return false; }
  bool shut_down(HostNs) override { return true; }
};

constexpr std::uint64_t kGrainNs = 100;

void print_buckets(const Histogram& lateness) {
  std::printf("\"buckets\":[");
  const char* comma = "";
  std::uint64_t below = 0;
  for (std::uint64_t ns = kGrainNs; below < lateness.count(); ns += kGrainNs) {
    // count_below() may leave out the largest value, so the total is used beyond it.
    const std::uint64_t now = ns > lateness.max() ? lateness.count() : lateness.count_below(ns);
    if (now == below) continue;
    std::printf("%s[%.1f,%llu]", comma, static_cast<double>(ns) * 1e-3,
                static_cast<unsigned long long>(now - below));
    comma = ",";
    below = now;
  }
  std::printf("]");
}

void print_refused(const std::vector<loop::Privilege>& process,
                   const std::vector<loop::Privilege>& thread) {
  std::printf("\"refused\":[");
  const char* comma = "";
  for (const auto* privileges : {&process, &thread}) {
    for (const loop::Privilege& privilege : *privileges) {
      if (privilege.granted) continue;
      std::printf("%s\"%s\"", comma, privilege.what.c_str());
      comma = ",";
    }
  }
  std::printf("]");
}

void measure(double rate_hz, double spin_us, double seconds, int cpu) {
  const loop::RealTimeProcess process({});
  Idle idle;
  loop::LoopSettings settings;
  settings.period_ns = static_cast<HostNs>(std::llround(1e9 / rate_hz));
  settings.spin_ns = static_cast<HostNs>(std::llround(spin_us * 1e3));
  settings.thread.cpu = cpu;
  loop::FixedRateLoop loop(settings, idle);
  loop.start();
  loop::sleep_until(monotonic_now() + from_s(seconds));
  loop.request_stop();
  loop.join();
  std::printf("{");
  print_buckets(loop.statistics().lateness);
  std::printf(",");
  print_refused(process.privileges(), loop.privileges());
  std::printf("}\n");
}

}  // namespace
}  // namespace tp100

int main(int argc, char** argv) {
  if (argc != 4 && argc != 5) {
    std::fprintf(stderr, "usage: lateness_bench RATE_HZ SPIN_US SECONDS [CPU]\n");
    return 2;
  }
  try {
    tp100::measure(std::atof(argv[1]), std::atof(argv[2]), std::atof(argv[3]),
                   argc == 5 ? std::atoi(argv[4]) : -1);
    return 0;
  } catch (const tp100::SetupError& error) {
    std::fprintf(stderr, "lateness_bench: %s\n", error.what());
    return 2;
  }
}
