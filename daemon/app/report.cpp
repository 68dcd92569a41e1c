#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <utility>

#include "app/commands.h"
#include "config/run_setup.h"
#include "report/recorded_run.h"
#include "report/report_page.h"
#include "report/result_text.h"
#include "runs/run_folder.h"
#include "text/atomic_file.h"
#include "text/command_line.h"

namespace tp100::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxRuns = 20;

report::RunNotes notes_of(const std::string& recording) {
  const runs::RunNote note = runs::note_beside(recording);
  report::RunNotes out{.name = note.name, .tags = note.tags, .note = note.note, .marks = {}};
  for (const runs::Mark& mark : runs::marks_of(note))
    out.marks.push_back({.at_ns = from_s(mark.t_s), .text = mark.text});
  return out;
}

report::RecordedRun read(const std::string& path) {
  const record::Recording recording(path);
  const config::RunSetup setup = config::parse_run(recorded_files(recording));
  report::RecordedRun run = report::read_run(
      recording, {.course = setup.course,
                  .robot = setup.robot,
                  .steering = setup.parameters.steering,
                  .rate_hz = setup.configuration.loop.rate_hz,
                  .turning_threshold_radps = setup.parameters.model.turning_threshold_radps,
                  .notes = notes_of(recording.path())});
  run.written_unix_s = text::written_unix_s(run.path);
  if (!run.whole)
    std::fprintf(stderr, "tp100d: %s: the recording is cut off; reported everything before that\n",
                 run.path.c_str());
  return run;
}

void write(const fs::path& folder, const std::string& name, const std::string& text) {
  const std::string path = (folder / name).string();
  text::write_file(path, text);
  std::printf("%s\n", path.c_str());
}

void write(const fs::path& folder, const std::vector<report::Figure>& figures) {
  for (const report::Figure& figure : figures) write(folder, figure.name + ".svg", figure.svg);
}

/// The run's name, with a number appended where several are equal.
std::string name_of(const std::string& path, std::set<std::string>& taken) {
  const std::string run = record::run_name(path);
  std::string name = run;
  for (int i = 2; !taken.insert(name).second; ++i) name = run + " (" + std::to_string(i) + ")";
  return name;
}

// Each call may be refused; the report is made all the same.
void become_background() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::setpriority(PRIO_PROCESS, 0, 19);
  const sched_param priority{};
  ::sched_setscheduler(0, SCHED_IDLE, &priority);
  // If memory runs out, the kernel is to end this program first.
  std::ofstream("/proc/self/oom_score_adj") << 1000;
}

}  // namespace

void add_background(CLI::App& command) {
  command.add_flag_callback("--background", become_background,
                            "Run at idle priority; end when the parent process ends");
}

int run_report(const ReportOptions& options) {
  if (options.runs.size() > 1 && !options.out.empty())
    throw UserError("--out is for one run; without it the files go beside each recording");
  for (const std::string& path : options.runs) {
    const report::RecordedRun run = read(path);
    const auto judged = report::judged(run);
    const std::vector<report::Figure> figures = report::figures_of(run);
    const fs::path folder =
        options.out.empty() ? fs::path(run.path).parent_path() : fs::path(options.out);
    text::make_folder(folder);
    write(folder, "report.html", report::report_page(run, judged, figures));
    write(folder, "metrics.json", report::metrics_json(run, judged));
    write(folder, figures);
  }
  return 0;
}

int run_compare(const ReportOptions& options) {
  if (options.runs.size() < 2 || options.runs.size() > kMaxRuns)
    throw UserError("compare: give two to " + std::to_string(kMaxRuns) + " recordings");
  std::vector<report::ComparedRun> runs;
  std::vector<std::optional<report::RunFigures>> judged;
  std::string metrics = "{\"runs\": [\n";
  std::set<std::string> taken;
  for (const std::string& path : options.runs) {
    report::RecordedRun run = read(path);
    judged.push_back(report::judged(run));
    metrics += (runs.empty() ? "" : ",\n") + report::metrics_json(run, judged.back());
    report::thin_for_figures(run);
    runs.push_back({name_of(path, taken), std::move(run)});
  }
  const std::vector<report::Figure> figures = report::figures_of(runs);
  const fs::path folder = options.out;
  text::make_folder(folder);
  write(folder, "compare.html", report::compare_page(runs, judged, figures));
  write(folder, "compare.json", metrics + "]}\n");
  write(folder, figures);
  return 0;
}

void add_report(CLI::App& app, Action& action) {
  static ReportOptions options;
  CLI::App* command =
      app.add_subcommand("report", "Turn recordings into report.html, metrics.json and figures");
  text::option(command, "RUN", options.runs, "RUN", "Recordings, or their folders")->required();
  text::option(command, "--out", options.out, "FOLDER",
               "Folder to write to (default: beside the recording)");
  add_background(*command);
  command->footer("Example: tp100d report runs/RUN");
  command->callback([&action] { action = [] { return run_report(options); }; });
}

void add_compare(CLI::App& app, Action& action) {
  static ReportOptions options{.runs = {}, .out = "."};
  CLI::App* command = app.add_subcommand("compare", "Compare recorded runs in overlaid figures");
  text::option(command, "RUN", options.runs, "RUN", "Recordings, or their folders")->required();
  text::option(command, "--out", options.out, "FOLDER",
               "Folder to write compare.html to (default: here)");
  add_background(*command);
  command->footer("Example: tp100d compare runs/before runs/after --out compared");
  command->callback([&action] { action = [] { return run_compare(options); }; });
}

}  // namespace tp100::app
