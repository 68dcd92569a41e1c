#pragma once
// The recorded runs as viewers see and manage them: list, notes, deletion, reports. A thread of
// its own waits for the programs that make reports.

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "core/worker.h"
#include "runs/report_process.h"
#include "runs/run_folder.h"

namespace tp100::runs {

/// Most runs listed; older ones are left out.
inline constexpr std::size_t kMaxListedRuns = 500;

struct ArchiveSettings {
  std::string folder;             ///< empty: nothing is recorded
  std::uint64_t quota_bytes = 0;  ///< as shown; 0: none
  std::string program;            ///< tp100d, which makes reports
  /// The run being recorded; empty: none. Any thread.
  std::function<std::string()> active = [] { return std::string(); };
  std::chrono::milliseconds limit = std::chrono::minutes(10);  ///< for one report
};

class RunArchive {
 public:
  /// Receives why the request failed, in one line, or nothing; and its answer as JSON. Called once,
  /// from any thread, also at the archive's end.
  using Answer = Worker::Answer;

  /// The archive must outlive `disk`.
  RunArchive(ArchiveSettings settings, Worker& disk)
      : settings_(std::move(settings)), disk_(disk) {}
  /// Ends a report that is being made.
  ~RunArchive() { process_.stop(); }

  /// The answer to GET /api/runs (CHANNELS.md), at most a second old, and never from before a
  /// change made here. Contains names only, no paths. Waits for the disk; any thread.
  std::string json();

  // Any thread; none of these waits for the disk.
  void change_note(const std::string& run, const RunNoteChange& change, const Answer& answer);
  void remove(const std::string& run, const Answer& answer);
  /// Makes report.html, metrics.json and the figures of a run in its folder.
  void report(const std::string& run, const Answer& answer);
  /// Makes compare-WITH.html in the folder of `run`.
  void compare(const std::string& run, const std::string& with, const Answer& answer);
  /// Answers with the report of `tp100d identify` on these runs, and the robot file that it makes.
  /// `measured`: the text of its file of hand measurements; empty: none.
  void identify(const std::vector<std::string>& runs, const std::string& measured,
                const Answer& answer);

 private:
  /// An answer to a job that may have changed the runs.
  Answer without_paths(Answer answer);
  /// Answers with what `job` returns, one at a time; `of`: the run that it is about.
  void in_process(const std::string& of, const Answer& answer, std::function<std::string()> job);
  /// `with`: empty for a report. Returns its address.
  std::string make_report(const std::string& run, const std::string& with);
  std::string make_robot(const std::vector<std::string>& runs, const std::string& measured);
  std::string recording(const std::string& run) const;

  const ArchiveSettings settings_;
  Worker& disk_;
  std::mutex mutex_;    // guards what follows; never held while waiting for a disk or a program
  std::string making_;  // the run of which a report is being made; empty: none
  std::string json_;    // the newest list
  std::string active_;  // the run being recorded when json_ was made
  std::chrono::steady_clock::time_point read_{};
  std::uint64_t changes_ = 0, listed_ = 0;  // made here; known to the list
  ReportProcess process_;
  Worker reports_{"reports"};  // declared last: its jobs use the others
};

}  // namespace tp100::runs
