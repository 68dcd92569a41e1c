#include "app/report.h"

#include <cstdio>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "analysis/recorded_run.h"
#include "analysis/report_page.h"
#include "analysis/run_metrics.h"
#include "app/replay_recording.h"
#include "app/run_setup.h"
#include "disk/atomic_file.h"

namespace tp100::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRuns = 20;

analysis::RecordedRun read(const std::string& path) {
  const analysis::Recording recording(path);
  const RunSetup setup = parse_run(recorded_files(recording));
  analysis::RecordedRun run =
      analysis::read_run(recording, {.course = setup.course,
                                     .robot = setup.robot,
                                     .steering = setup.parameters.steering,
                                     .rate_hz = setup.configuration.loop.rate_hz});
  if (!run.whole)
    std::fprintf(stderr, "tp100d: %s: was cut off; reported up to there\n", run.path.c_str());
  return run;
}

void write(const fs::path& folder, const std::string& name, const std::string& text) {
  const std::string path = (folder / name).string();
  disk::write_file(path, text);
  std::printf("%s\n", path.c_str());
}

void write(const fs::path& folder, const std::vector<analysis::Figure>& figures) {
  for (const analysis::Figure& figure : figures) write(folder, figure.name + ".svg", figure.svg);
}

/// The folder of a run, or the name of a file; told apart by a number where several are the same.
std::string name_of(const std::string& path, std::set<std::string>& taken) {
  const fs::path file(analysis::recording_file(path));
  std::string stem = file.stem().string();
  if (stem == "run") stem = fs::absolute(file).lexically_normal().parent_path().filename().string();
  std::string name = stem;
  for (int i = 2; !taken.insert(name).second; ++i) name = stem + " (" + std::to_string(i) + ")";
  return name;
}

}  // namespace

int run_report(const ReportOptions& options) {
  if (options.runs.size() > 1 && !options.out.empty())
    throw SetupError("--out is for one run; without it the files go beside each recording");
  for (const std::string& path : options.runs) {
    const analysis::RecordedRun run = read(path);
    const auto judged = analysis::judged(run);
    const std::vector<analysis::Figure> figures = analysis::figures_of(run);
    const fs::path folder =
        options.out.empty() ? fs::path(run.path).parent_path() : fs::path(options.out);
    disk::make_folder(folder);
    write(folder, "report.html", analysis::report_page(run, judged, figures));
    write(folder, "metrics.json", analysis::metrics_json(run, judged));
    write(folder, figures);
  }
  return 0;
}

int run_compare(const CompareOptions& options) {
  if (options.runs.size() < 2 || options.runs.size() > kMostRuns)
    throw SetupError("compare: give two to " + std::to_string(kMostRuns) + " recordings");
  std::vector<analysis::ComparedRun> runs;
  std::vector<std::optional<analysis::RunFigures>> judged;
  std::string metrics = "{\"runs\": [\n";
  std::set<std::string> taken;
  for (const std::string& path : options.runs) {
    analysis::RecordedRun run = read(path);
    judged.push_back(analysis::judged(run));
    metrics += (runs.empty() ? "" : ",\n") + analysis::metrics_json(run, judged.back());
    analysis::thin_for_figures(run);
    runs.push_back({name_of(path, taken), std::move(run)});
  }
  const std::vector<analysis::Figure> figures = analysis::figures_of(runs);
  const fs::path folder = options.out;
  disk::make_folder(folder);
  write(folder, "compare.html", analysis::compare_page(runs, judged, figures));
  write(folder, "compare.json", metrics + "]}\n");
  write(folder, figures);
  return 0;
}

}  // namespace tp100::app
