#pragma once
// The figures of a run as JSON (--stats).

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "link/camera_intake.h"
#include "live/live_cycle.h"
#include "live/live_world.h"
#include "messages/figures.h"
#include "record/worker.h"

namespace tp100::live {

/// What a run came to.
struct RunFigures {
  std::string result;  ///< "running", "completed", "aborted", "interrupted", "duration"
  std::string port;
  std::string page;    ///< address of the page; empty: no server
  std::string course;  ///< empty: none
  std::string robot;
  std::string setup;
  double duration_s = 0.0;
  FaultMask faults = 0;  ///< of the last abort
  LiveStatus status{};
  std::optional<link::CameraCounters> camera;  ///< nothing: no camera was asked for
  WorldFigures world{};
  messages::RecordingFigures recording{};
  double recording_cpu_s = 0.0;
  messages::LoopFigures loop{};
};

/// One JSON object.
std::string stats_json(const RunFigures& figures);

/// The file of --stats, which is replaced again and again. One thread.
class StatsFile {
 public:
  /// An empty `path` is none. `disk` writes it and must outlive this.
  StatsFile(std::string path, record::Worker& disk);
  /// Has `figures` written. The first time, before anything moves, it waits for the disk and throws
  /// SetupError if they cannot be; later it never waits, and figures that the disk has not taken
  /// yet give way.
  void write(const RunFigures& figures);
  /// Why the file is not written any more, in one line, the first time that it was not; or nothing.
  std::string take_note();

 private:
  struct State {
    std::mutex mutex;
    std::optional<std::string> text;  ///< that waits for the disk
    bool writing = false;
    bool failed = false;
    std::string note;
  };

  const std::string path_;
  record::Worker& disk_;
  bool begun_ = false;
  std::shared_ptr<State> state_ = std::make_shared<State>();  // shared with the disk's thread
};

}  // namespace tp100::live
