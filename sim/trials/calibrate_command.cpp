#include <algorithm>
#include <cstdio>
#include <vector>

#include "core/error.h"
#include "identify/drive_file.h"
#include "identify/identify.h"
#include "sim/robot/lockstep.h"
#include "sim/trials/commands.h"
#include "text/atomic_file.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

// Seeds of one calibration's drives lie this far apart, so that no two share their noise.
constexpr std::uint64_t kSeedStride = 1'000'003;

}  // namespace

course::Robot without_model(course::Robot robot) {
  robot.model = {};
  robot.baselines = {};
  return robot;
}

std::vector<CalibrationDrive> calibration_drives(const Loaded& loaded, int repeats,
                                                 std::uint64_t seed) {
  std::vector<CalibrationDrive> drives;
  const course::Robot unknown = without_model(loaded.robot);
  for (const std::string& name : identify::calibration_courses(loaded.robot.shape)) {
    const course::Course course = load_course(name);
    for (int repeat = 1; repeat <= repeats; ++repeat) {
      identify::DriveSink sink;
      const report::RunResult result = run_lockstep({.course = course,
                                                     .robot = unknown,
                                                     .configuration = loaded.configuration,
                                                     .board = loaded.board,
                                                     .camera = load_camera("overhead"),
                                                     .seed = seed + kSeedStride * drives.size(),
                                                     .sinks = {&sink},
                                                     .truth_sinks = {&sink}});
      // Finished, not completed: an unidentified robot does not end where its course does.
      if (!result.finished)
        throw UserError(name + ": " + loaded.robot.name + " did not finish it (" + result.cause +
                        "); nothing can be identified");
      identify::RecordedDrive drive = sink.drive();
      drive.name = name + "-" + loaded.robot.name + "-" + std::to_string(seed) + "-" +
                   std::to_string(repeat);
      drives.push_back({std::move(drive), sink.truth()});
    }
  }
  return drives;
}

int run_calibrate(const CalibrateCommand& command) {
  const Loaded loaded = load(command.options);
  // Before the drives, so that an unwritable folder is reported at once.
  text::make_folder(command.out);
  std::vector<identify::RecordedDrive> drives = slope_drives(loaded.robot, command.options.seed);
  for (CalibrationDrive& one : calibration_drives(loaded, command.repeats, command.options.seed))
    drives.push_back(std::move(one.drive));
  // In the order of a list of the files, to whose places the rows of measured values refer.
  std::ranges::sort(drives, {}, &identify::RecordedDrive::name);
  for (const identify::RecordedDrive& drive : drives)
    text::write_file(command.out + "/" + drive.name + "-samples.csv", identify::write_drive(drive));
  const std::string measured = identify::write_measured(drives);
  if (!measured.empty()) text::write_file(command.out + "/measured.csv", measured);
  const std::string& out = command.out;
  std::printf("%s in %s; to identify: tp100d identify %s/*-samples.csv%s\n",
              text::counted(drives.size(), "drive").c_str(), out.c_str(), out.c_str(),
              measured.empty() ? "" : (" --measured " + out + "/measured.csv").c_str());
  return 0;
}

}  // namespace tp100::sim
