// recording_bench [SECONDS]: measures the cost of recording. It passes the steps of an emulated run
// to a recorder 200 times per second in real time, and compares this with the same run without a
// recorder. Prints a row of JSON.

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>
#include <vector>

#include "config/run_setup.h"
#include "course/bundled_files.h"
#include "kept_steps.h"
#include "record/recorder.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"
#include "support/temporary_folder.h"

namespace tp100 {
namespace {

using Clock = std::chrono::steady_clock;

double cpu_s() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

long resident_kb() {
  std::ifstream status("/proc/self/statm");
  long size = 0, resident = 0;
  status >> size >> resident;
  return resident * 4;
}

struct Cost {
  double cpu_share = 0.0;
  double take_us = 0.0, longest_take_us = 0.0;
};

Cost feed(const std::vector<StepRecord>& records, int steps, record::Recorder* recorder) {
  Cost cost;
  const double before = cpu_s();
  const Clock::time_point began = Clock::now();
  for (int i = 0; i < steps; ++i) {
    std::this_thread::sleep_until(began + i * std::chrono::milliseconds(5));
    if (recorder == nullptr) continue;
    const auto index = static_cast<std::size_t>(i) % records.size();
    StepRecord record = records[index];
    record.now_ns += static_cast<HostNs>(static_cast<std::size_t>(i) - index) * 5 * kNsPerMs;
    const Clock::time_point take = Clock::now();
    recorder->take(record);
    const double us = std::chrono::duration<double, std::micro>(Clock::now() - take).count();
    cost.take_us += us / steps;
    cost.longest_take_us = std::max(cost.longest_take_us, us);
  }
  const double wall = std::chrono::duration<double>(Clock::now() - began).count();
  cost.cpu_share = (cpu_s() - before) / wall;
  return cost;
}

int run(double seconds) {
  sim::Loaded loaded = sim::load({});
  loaded.files.course = course::read_bundled(course::Bundled::kCourses, "1-curve");
  const config::RunSetup setup = config::parse_run(loaded.files);
  test::StepKeeper keeper;
  sim::run_lockstep({.course = *setup.course,
                     .robot = loaded.robot,
                     .configuration = loaded.configuration,
                     .setup = loaded.setup,
                     .sink = &keeper});
  const int steps = static_cast<int>(seconds * 200.0);
  const Cost without = feed(keeper.records, steps, nullptr);

  const test::TemporaryFolder folder;
  record::Recorder recorder({.history = record::HistorySettings{.folder = folder.path().string()}});
  recorder.begin({.path = folder.file("run.mcap")}, config::run_facts(loaded.files, setup, {}));
  const int warm_up = std::min(steps, 400);
  feed(keeper.records, warm_up, &recorder);
  const long resident = resident_kb();
  const record::RecordingStatus began = recorder.status();
  const Cost with = feed(keeper.records, steps, &recorder);
  const record::RecordingStatus ended = recorder.status();
  const long grown = resident_kb() - resident;
  recorder.end();

  const double written = static_cast<double>(ended.bytes - began.bytes) * 1e-6;
  std::printf(
      "{\"steps\":%d,\"cores\":%.5f,\"cores_without\":%.5f,\"cores_own_thread\":%.5f,"
      "\"step_us\":%.3f,\"longest_step_us\":%.1f,\"mb_per_min\":%.3f,\"grown_kb\":%ld,"
      "\"dropped\":%llu}\n",
      steps, with.cpu_share - without.cpu_share, without.cpu_share,
      (ended.cpu_s - began.cpu_s) / seconds, with.take_us, with.longest_take_us,
      written * 60.0 / seconds, grown, static_cast<unsigned long long>(ended.dropped));
  return 0;
}

}  // namespace
}  // namespace tp100

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 20.0;
  return tp100::run(std::clamp(seconds, 1.0, 36000.0));
}
