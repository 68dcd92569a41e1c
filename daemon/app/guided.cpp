#include "app/guided.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>

#include "core/angle.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "course/course.h"
#include "identify/calibration.h"
#include "identify/drive_file.h"
#include "identify/drive_sink.h"
#include "text/atomic_file.h"
#include "text/toml_document.h"

namespace tp100::app {
namespace {

/// A number from standard input; nothing for an empty line.
std::optional<double> ask(const std::string& question) {
  while (true) {
    std::printf("%s ", question.c_str());
    std::fflush(stdout);
    std::string line;
    if (!std::getline(std::cin, line))
      throw SetupError(
          "identify --drive: no camera saw the drive and nobody answers; give --camera, or answer "
          "on standard input");
    if (line.find_first_not_of(" \t\r") == std::string::npos) return std::nullopt;
    char* end = nullptr;
    const double value = std::strtod(line.c_str(), &end);
    const bool whole = std::string_view(end).find_first_not_of(" \t\r") == std::string_view::npos;
    if (end != line.c_str() && whole && std::isfinite(value)) return value;
    std::printf("'%s' is no number\n", text::one_line(line, 40).c_str());
  }
}

void ask_for(identify::HandMeasured& measured) {
  std::printf("No camera saw this drive. Measure it; an empty line leaves a value out.\n");
  measured.distance_m = ask("  distance from start to end, straight through the air [m]:");
  const auto turned_deg = ask("  turned angle, left positive, whole turns counted [deg]:");
  if (turned_deg) measured.turned_rad = *turned_deg * kRadPerDeg;
}

std::string space_for(const course::Course& course) {
  char text[120];
  std::snprintf(text, sizeof text, "%.1f m ahead, %.1f behind, %.1f to the left, %.1f to the right",
                course.fence.max_x_m, -course.fence.min_x_m, course.fence.max_y_m,
                -course.fence.min_y_m);
  return text;
}

}  // namespace

GuidedDrives drive_guided(const GuidedOptions& options, const course::Robot& robot) {
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);
  if (error)
    throw SetupError(options.folder + ": cannot create the folder (" + error.message() +
                     "); give another --runs-dir");
  const std::vector<std::string> courses =
      options.courses.empty() ? identify::calibration_courses(robot.shape) : options.courses;
  const std::size_t all = courses.size() * static_cast<std::size_t>(options.repeats);
  GuidedDrives result;
  for (const std::string& name : courses) {
    const course::TextFile file = course::read_bundled(course::Bundled::kCourses, name);
    const course::Course course = course::parse_course(file.text, file.path);
    for (int repeat = 1; repeat <= options.repeats; ++repeat) {
      std::printf("drive %zu of %zu: %s; it needs %s of its start\n", result.drives.size() + 1, all,
                  course.name.c_str(), space_for(course).c_str());
      std::fflush(stdout);
      identify::DriveSink sink;
      RunOptions run = options.run;
      run.course = name;
      run.ran_before = !result.drives.empty();
      run.sinks.push_back(&sink);
      if (run_run(run) != 0) return result;
      identify::Drive drive = sink.drive();
      // In the order of a folder's listing, by which hand measurements count the runs.
      const std::size_t number = result.drives.size() + 1;
      drive.name = (number < 10 ? "0" : "") + std::to_string(number) + "-" + course.name;
      if (drive.camera.empty()) ask_for(drive.measured);
      text::write_file(options.folder + "/" + drive.name + "-samples.csv",
                       identify::write_drive(drive));
      result.drives.push_back(std::move(drive));
      const std::string measured = identify::write_measured(result.drives);
      if (!measured.empty()) text::write_file(options.folder + "/measured.csv", measured);
    }
  }
  result.completed = true;
  return result;
}

}  // namespace tp100::app
