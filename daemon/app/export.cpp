#include "app/export.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <utility>

#include "analysis/atomic_file.h"
#include "analysis/drive_file.h"
#include "analysis/tum.h"
#include "app/drive_sink.h"

namespace tp100::app {
namespace {

using analysis::Recording;

std::string number(double value) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

HostNs start_of(const Recording& recording) {
  return std::strtoll(recording.fact("start_ns").c_str(), nullptr, 10);
}

/// When the run was: its first and last step, or everything if nothing ran.
struct Window {
  HostNs from_ns = std::numeric_limits<HostNs>::max();
  HostNs to_ns = std::numeric_limits<HostNs>::min();
  bool has(HostNs at) const { return at >= from_ns && at <= to_ns; }
};

Window window_of(const Recording& recording) {
  Window run, all;
  recording.visit({.step = [&](const StepRecord& record) {
    const auto widen = [&](Window& window) {
      window.from_ns = std::min(window.from_ns, record.now_ns);
      window.to_ns = record.now_ns;
    };
    widen(all);
    if (record.snapshot.run_state == RunState::kRunning) widen(run);
  }});
  return run.from_ns <= run.to_ns ? run : all;
}

/// Calls `each` with the snapshot of every step in the window that got a sample.
template <class Each>
void for_each_pose(const Recording& recording, Each each) {
  const Window window = window_of(recording);
  HostNs last = std::numeric_limits<HostNs>::min();
  recording.visit({.step = [&](const StepRecord& record) {
    const Snapshot& snapshot = record.snapshot;
    const HostNs at = snapshot.sample.measured_ns;
    if (record.sample_count == 0 || !window.has(at) || at <= last) return;
    last = at;
    each(at, snapshot);
  }});
}

void write(const std::filesystem::path& folder, const char* name, const std::string& text) {
  const std::string path = (folder / name).string();
  analysis::write_file(path, text);
  std::printf("%s\n", path.c_str());
}

void export_run(const std::string& run, const ExportOptions& options) {
  const Recording recording(run);
  if (!recording.whole())
    std::fprintf(stderr, "tp100d: %s: was cut off; exported up to there\n",
                 recording.path().c_str());
  const std::filesystem::path folder = options.out.empty()
                                           ? std::filesystem::path(recording.path()).parent_path()
                                           : std::filesystem::path(options.out);
  if (options.csv) {
    write(folder, "samples.csv", analysis::write_drive(recorded_drive(recording)));
    write(folder, "poses.csv", poses_csv(recording));
  }
  if (options.tum) {
    const Trajectories lines = trajectories(recording);
    write(folder, "model.tum", lines.model);
    write(folder, "odometry.tum", lines.odometry);
    write(folder, "fused.tum", lines.fused);
    if (!lines.truth.empty()) write(folder, "truth.tum", lines.truth);
  }
}

}  // namespace

std::string poses_csv(const Recording& recording) {
  std::string text = "t_s";
  for (const char* pose : {"model", "odometry", "fused"})
    for (const char* value : {"x_m", "y_m", "z_m", "roll_rad", "pitch_rad", "yaw_rad"})
      text += std::string(",") + pose + "_" + value;
  text +=
      ",left_mps,right_mps,slip_left,slip_right,cross_track_m,heading_error_rad,progress_m,"
      "desired_yaw_rad,speed_mps\n";
  const HostNs start = start_of(recording);
  for_each_pose(recording, [&](HostNs at, const Snapshot& snapshot) {
    text += number(to_s(at - start));
    for (const Pose* pose : {&snapshot.model, &snapshot.odometry, &snapshot.fused.pose})
      for (const double value :
           {pose->x_m, pose->y_m, pose->z_m, pose->roll_rad, pose->pitch_rad, pose->yaw_rad})
        text += "," + number(value);
    for (const double value :
         {snapshot.left_mps, snapshot.right_mps, snapshot.slip_left, snapshot.slip_right,
          snapshot.cross_track_m, snapshot.heading_error_rad, snapshot.progress_m,
          snapshot.command.desired_yaw_rad, snapshot.command.speed_mps})
      text += "," + number(value);
    text += '\n';
  });
  return text;
}

Trajectories trajectories(const Recording& recording) {
  Trajectories lines;
  const HostNs start = start_of(recording);
  for_each_pose(recording, [&](HostNs at, const Snapshot& snapshot) {
    const double t_s = to_s(at - start);
    lines.model += analysis::tum_line(t_s, snapshot.model);
    lines.odometry += analysis::tum_line(t_s, snapshot.odometry);
    lines.fused += analysis::tum_line(t_s, snapshot.fused.pose);
  });
  const Window window = window_of(recording);
  recording.visit({.truth = [&](HostNs at, const Pose& truth) {
    if (window.has(at)) lines.truth += analysis::tum_line(to_s(at - start), truth);
  }});
  return lines;
}

int run_export(const ExportOptions& options) {
  ExportOptions wanted = options;
  if (!wanted.csv && !wanted.tum) wanted.csv = wanted.tum = true;
  if (wanted.runs.size() > 1 && !wanted.out.empty())
    throw SetupError("--out is for one run; without it the files go beside each recording");
  for (const std::string& run : wanted.runs) export_run(run, wanted);
  return 0;
}

}  // namespace tp100::app
