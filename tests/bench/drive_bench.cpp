// Driving by hand in virtual time, as JSON rows: the times until the robot is commanded to stop and
// stands after the loss of its driver, and how far commands by hand take it out of a fence.
//
// Usage: drive_bench TRIALS RUNS
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "../robot/dead_man.h"
#include "../robot/fence_runs.h"

namespace {

void print(const std::string& what, std::vector<double> values, const char* unit) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  std::printf("%s\n", nlohmann::json{{"what", what},
                                     {"count", values.size()},
                                     {"unit", unit},
                                     {"p50", at(0.5)},
                                     {"p99", at(0.99)},
                                     {"max", values.back()}}
                          .dump()
                          .c_str());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace tp100::sim;
  if (argc != 3) {
    std::fprintf(stderr, "usage: drive_bench TRIALS RUNS\n");
    return 2;
  }
  int status = 0;
  for (const auto& [client, by] : kClients)
    for (const auto& [loss, loss_name] : kLosses) {
      const LossTimes times = lose_driver(loss, std::atoi(argv[1]), 1, client);
      const std::string name = std::string(by) + ", " + loss_name;
      if (!times.wrong.empty()) {
        std::fprintf(stderr, "drive_bench: %s: %s\n", name.c_str(), times.wrong.c_str());
        status = 1;
      }
      print(name + ": command of standstill on the wire", times.command_ms, "ms");
      print(name + ": duties below the dead band", times.duty_ms, "ms");
      print(name + ": robot stands", times.standing_ms, "ms");
    }
  std::vector<double> outside_mm, estimated_mm, error_mm, driven_m, at_fence_s;
  double aborted = 0.0;
  for (int seed = 1; seed <= std::atoi(argv[2]); ++seed) {
    const FenceRun run = drive_in_fence(static_cast<std::uint64_t>(seed), 20.0);
    outside_mm.push_back(run.outside_m * 1e3);
    estimated_mm.push_back(run.estimated_outside_m * 1e3);
    error_mm.push_back(run.pose_error_m * 1e3);
    driven_m.push_back(run.driven_m);
    at_fence_s.push_back(run.at_fence_s);
    if (run.end != tp100::RunState::kDriving) ++aborted;
  }
  if (outside_mm.empty()) return status;
  print("centre outside the fence (negative: inside)", outside_mm, "mm");
  print("the same by the estimated pose", estimated_mm, "mm");
  print("error of the pose", error_mm, "mm");
  print("driven", driven_m, "m");
  print("limited by the fence", at_fence_s, "s");
  print("drives that ended early", {aborted}, "");
  return status;
}
