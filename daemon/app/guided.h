#pragma once
// The guided calibration of `tp100d identify --drive`: one calibration course after the other on a
// port, recorded, and measured by a camera or by whoever stands there.

#include <string>
#include <vector>

#include "app/run.h"
#include "course/robot.h"
#include "identify/drive.h"

namespace tp100::app {

struct GuidedOptions {
  RunOptions run{};  ///< port, camera, robot, configuration, go; its course is set here
  std::vector<std::string> courses;  ///< bundled names or files; empty: calibration_courses
  int repeats = 2;                   ///< of each drive
  std::string folder;                ///< for the recordings, one CSV file a drive; made if need be
};

struct GuidedDrives {
  std::vector<identify::Drive> drives;
  bool completed = false;  ///< all of them; else the drives before the one that failed
};

/// Drives all courses. On a physical port each drive waits for Enter (unless `go`); where a drive
/// ended is asked for on standard output and read from standard input if no camera saw it. A drive
/// that is not completed ends the calibration; earlier ones stay in the folder. Throws SetupError.
GuidedDrives drive_guided(const GuidedOptions& options, const course::Robot& robot);

}  // namespace tp100::app
