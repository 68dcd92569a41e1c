#include "live/setup_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>

#include "bridge/step.h"
#include "core/error.h"
#include "course/course.h"
#include "course/path.h"
#include "course/robot_file.h"
#include "identify/identify.h"
#include "messages/messages.h"
#include "terrain/climbable.h"
#include "text/json_writer.h"

namespace tp100::live {
namespace {

using course::Bundled;

/// Points of the path, thinned out evenly; the last one stays.
std::vector<course::PathPoint> outline(const course::Path& path) {
  std::vector<course::PathPoint> all = messages::path_points(path);
  if (all.size() <= kMaxOutline) return all;
  std::vector<course::PathPoint> out;
  for (std::size_t i = 0; i < kMaxOutline; ++i)
    out.push_back(all[i * (all.size() - 1) / (kMaxOutline - 1)]);
  return out;
}

void write_piece(text::JsonWriter& json, const course::Place& place, double length_m,
                 double width_m, double height_m) {
  json.begin_object()
      .field("x_m", place.x_m)
      .field("y_m", place.y_m)
      .field("heading_rad", place.heading_rad)
      .field("length_m", length_m)
      .field("width_m", width_m)
      .field("height_m", height_m)
      .end_object();
}

void write_course(text::JsonWriter& json, const course::Course& course) {
  const course::Path path(course);
  json.field("description", course.description)
      .field("identifies", course.identifies)
      .field("speed_mps", course.speed_mps)
      .field("length_m", path.length_m())
      .field("disturbances", course.disturbances.size());
  json.key("start")
      .begin_object()
      .field("x_m", course.start.x_m)
      .field("y_m", course.start.y_m)
      .field("yaw_rad", course.start.yaw_rad)
      .end_object()
      .key("fence")
      .begin_object()
      .field("min_x_m", course.fence.min_x_m)
      .field("max_x_m", course.fence.max_x_m)
      .field("min_y_m", course.fence.min_y_m)
      .field("max_y_m", course.fence.max_y_m)
      .end_object()
      .key("outline")
      .begin_array();
  for (const course::PathPoint& point : outline(path))
    json.begin_object().field("x_m", point.x_m).field("y_m", point.y_m).end_object();
  json.end_array().key("ramps").begin_array();
  for (const course::Ramp& ramp : course.terrain.ramps)
    write_piece(json, ramp.place, ramp.length_m(), ramp.width_m, ramp.height_m);
  json.end_array().key("blocks").begin_array();
  for (const course::Block& block : course.terrain.blocks)
    write_piece(json, block.place, block.depth_m, block.width_m, block.height_m);
  json.end_array().key("surfaces").begin_array();
  for (const course::Surface& surface : course.terrain.surfaces)
    write_piece(json, surface.place, surface.length_m, surface.width_m, 0.0);
  json.end_array();
}

config::LoadedRun with_file(const config::LoadedRun& run, Bundled kind,
                            const course::TextFile& file) {
  return kind == Bundled::kCourses
             ? config::with_files(run, file, run.files.robot, run.files.setup)
             : config::with_files(run, run.files.course, file, run.files.setup);
}

/// Throws SetupError if the run's files do not fit together.
void write_fit(text::JsonWriter& json, const config::RunSetup& run, bool is_course) {
  const bridge::Step step(run.parameters, run.course);
  if (is_course) json.field("duration_s", step.nominal_duration_s());
  require_fit(run);
}

/// `message` without its place in the file, which is written: "NAME:line:column: what".
std::string_view write_place(text::JsonWriter& json, std::string_view message,
                             std::string_view name) {
  unsigned line = 0, column = 0;
  if (!message.starts_with(name) || !message.substr(name.size()).starts_with(':')) return message;
  const char* const end = message.data() + message.size();
  const auto [after_line, no_line] = std::from_chars(message.data() + name.size() + 1, end, line);
  if (no_line != std::errc() || after_line == end || *after_line != ':') return message;
  const auto [after, no_column] = std::from_chars(after_line + 1, end, column);
  if (no_column != std::errc() || end - after < 2 || *after != ':') return message;
  json.field("line", line).field("column", column);
  return message.substr(static_cast<std::size_t>(after - message.data()) + 2);
}

void write_entry(text::JsonWriter& json, const config::SetupFiles& files,
                 const config::LoadedRun& run, Bundled kind,
                 const config::SetupFiles::Entry& entry) {
  json.begin_object().field("name", entry.name).field("from", to_string(entry.from));
  std::string why;
  const bool is_course = kind == Bundled::kCourses;
  const course::Course* course = run.setup.course.get();
  const bool in_force = is_course ? course != nullptr && course->name == entry.name
                                  : run.setup.robot.name == entry.name;
  try {
    const course::TextFile file = files.read(kind, entry.name);
    const config::LoadedRun with = with_file(run, kind, file);
    if (is_course) {
      write_course(json, *with.setup.course);
    } else {
      json.field("description", with.setup.robot.description);
    }
    write_fit(json, with.setup, is_course);
  } catch (const SetupError& error) {
    why = error.what();
  }
  json.field("in_force", in_force).field("why_not", why).end_object();
}

}  // namespace

void require_fit(const config::RunSetup& run) {
  if (!run.configuration.camera.listen.empty() && run.parameters.setup == bridge::Setup::kStand)
    throw SetupError("--camera: on a stand it sees a robot that stands still; leave it out");
  if (run.course != nullptr) terrain::require_climbable(*run.course, run.robot);
}

std::string setup_list(const config::SetupFiles& files, const config::LoadedRun& run) {
  std::string text;
  text::JsonWriter json(text);
  const auto& setup = run.setup;
  json.begin_object()
      .field("course", setup.course == nullptr ? "" : setup.course->name)
      .field("robot", setup.robot.name)
      .field("setup", bridge::to_string(setup.parameters.setup))
      .key("setups")
      .begin_array();
  for (const auto& each : bridge::kSetupNames) json.value(each.name);
  json.end_array().field("may_save", files.may_save()).key("calibration").begin_array();
  for (const std::string& each : identify::calibration_courses(setup.robot.shape)) json.value(each);
  json.end_array();
  for (const Bundled kind : {Bundled::kCourses, Bundled::kRobots}) {
    json.key(kind == Bundled::kCourses ? "courses" : "robots").begin_array();
    for (const config::SetupFiles::Entry& entry : files.list(kind))
      write_entry(json, files, run, kind, entry);
    json.end_array();
  }
  json.end_object();
  return text;
}

std::string checked_file(const config::LoadedRun& run, Bundled kind, const course::TextFile& file) {
  const bool is_course = kind == Bundled::kCourses;
  std::string text, why;
  text::JsonWriter json(text);
  json.begin_object();
  try {
    if (is_course) {
      const course::Path path(course::parse_course(file.text, file.path));
      json.field("length_m", path.length_m());
    } else {
      course::parse_robot(file.text, file.path);
    }
    json.field("error", "");
    try {
      write_fit(json, with_file(run, kind, file).setup, is_course);
    } catch (const SetupError& misfit) {
      why = misfit.what();
    }
  } catch (const SetupError& error) {
    json.field("error", write_place(json, error.what(), file.path));
  }
  json.field("why_not", why).end_object();
  return text;
}

}  // namespace tp100::live
