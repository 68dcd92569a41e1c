#pragma once
// The figures of a run as JSON (--stats).

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/worker.h"
#include "live/active_run.h"
#include "live/external_inputs.h"
#include "live/live_cycle.h"
#include "messages/event_queue.h"
#include "messages/figures.h"

namespace tp100::live {

/// Result and figures of a run.
struct DaemonFigures {
  std::string result{};  ///< "running", "completed", "aborted", "interrupted", "duration"
  std::string port{};
  std::string page{};                      ///< address of the page; empty: no server
  std::shared_ptr<const ActiveRun> run{};  ///< in force
  double duration_s = 0.0;
  FaultMask faults = 0;  ///< of the last abort
  LiveStatus status{};
  InputFigures inputs{};
  messages::RecordingFigures recording{};
  double recording_cpu_s = 0.0;
  messages::LoopFigures loop{};
};

/// The last lines of the program, without the newline at their end.
std::string summary_text(const DaemonFigures& figures);

/// The file of --stats, rewritten periodically. One thread.
class StatsFile {
 public:
  /// An empty `path` means no file. `disk` writes it and must outlive this, and `events` the disk;
  /// they hear of the first failure.
  StatsFile(std::string path, Worker& disk, messages::EventQueue& events)
      : path_(std::move(path)), disk_(disk), events_(events) {}
  /// Writes `figures`. The first time, before anything moves, it waits for the disk and throws
  /// UserError on failure. Later it never waits, and newer figures replace those not written yet.
  void write(const DaemonFigures& figures);
  /// Whether the newest figures are not on the disk yet.
  bool waits() const {
    const std::lock_guard lock(state_->mutex);
    return state_->writing;
  }

 private:
  struct State {
    std::mutex mutex;
    std::optional<std::string> text;  ///< waiting for the disk
    bool writing = false;
    bool failed = false;
  };

  const std::string path_;
  Worker& disk_;
  messages::EventQueue& events_;
  bool begun_ = false;
  std::shared_ptr<State> state_ = std::make_shared<State>();  // shared with the disk's thread
};

}  // namespace tp100::live
