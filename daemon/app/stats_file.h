#pragma once
// The figures of a run as JSON (--stats). Written to a temporary file and renamed.

#include <optional>
#include <string>
#include <vector>

#include "app/live_cycle.h"
#include "app/live_world.h"
#include "link/camera_intake.h"
#include "publish/figures.h"

namespace tp100::app {

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
  publish::RecordingFigures recording{};
  double recording_cpu_s = 0.0;
  publish::LoopFigures loop{};
};

/// One JSON object.
std::string stats_json(const RunFigures& figures);

/// Writes `text` to `path` as a whole or not at all. Throws SetupError.
void write_stats(const std::string& path, const std::string& text);

}  // namespace tp100::app
