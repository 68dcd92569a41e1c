// Measures the cost of the pure step on course 3 with the overhead camera: feeds the recorded
// inputs of an emulated run to a new step. Prints rows of JSON.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <vector>

#include "bridge/step.h"
#include "core/statistics.h"
#include "kept_run.h"

namespace tp100 {
namespace {

using Clock = std::chrono::steady_clock;

// This is more than the private caches of a processor core.
constexpr std::size_t kOthersBytes = 4U << 20U;
constexpr std::size_t kLine = 64;
// Each step is measured this often. The median excludes interruptions by the rest of the machine.
constexpr std::size_t kPasses = 5;

/// Replaces the content of the caches, as the rest of the machine does between two steps.
class Others {
 public:
  void use() {
    for (std::size_t i = 0; i < bytes_.size(); i += kLine)
      bytes_[i] = static_cast<char>(bytes_[i] + 1);
  }

 private:
  std::vector<char> bytes_ = std::vector<char>(kOthersBytes);
};

using Passes = std::array<double, kPasses>;

/// Times of each step [us].
std::vector<Passes> times(const test::KeptRun& run, bool cold) {
  std::vector<Passes> all(run.records.size());
  Others others;
  for (std::size_t pass = 0; pass < kPasses; ++pass) {
    bridge::Step step(run.parameters, run.course);
    for (std::size_t i = 0; i < run.records.size(); ++i) {
      const StepRecord& record = run.records[i];
      if (cold) others.use();
      const Clock::time_point began = Clock::now();
      step(record.inputs, record.now_ns);
      all[i][pass] = std::chrono::duration<double, std::micro>(Clock::now() - began).count();
    }
  }
  return all;
}

double median(Passes of) {
  std::nth_element(of.begin(), of.begin() + kPasses / 2, of.end());
  return of[kPasses / 2];
}

void print(const char* setup, const char* which, bool cold, std::vector<double> us) {
  if (us.empty()) return;
  std::printf(
      "{\"setup\":\"%s\",\"which\":\"%s\",\"caches\":\"%s\",\"steps\":%zu,\"p50_us\":%.3f,"
      "\"p99_us\":%.3f,\"p999_us\":%.3f,\"max_us\":%.3f}\n",
      setup, which, cold ? "cold" : "warm", us.size(), percentile(us, 0.5), percentile(us, 0.99),
      percentile(us, 0.999), percentile(us, 1.0));
  std::fflush(stdout);
}

void bench(bridge::Setup setup) {
  const test::KeptRun run = test::keep_course_3(setup);
  for (const bool cold : {false, true}) {
    const std::vector<Passes> us = times(run, cold);
    std::vector<double> running, with_camera;
    for (std::size_t i = 0; i < us.size(); ++i) {
      const StepRecord& record = run.records[i];
      if (record.snapshot.run_state != RunState::kRunning) continue;
      running.push_back(median(us[i]));
      if (!record.inputs.camera.empty()) with_camera.push_back(running.back());
    }
    const char* name = bridge::to_string(setup);
    print(name, "all while it drives", cold, running);
    print(name, "with a camera pose", cold, with_camera);
  }
}

}  // namespace
}  // namespace tp100

int main() {
  tp100::bench(tp100::bridge::Setup::kFlat);
  tp100::bench(tp100::bridge::Setup::kTerrain);
  return 0;
}
