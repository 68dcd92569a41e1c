#include <algorithm>
#include <memory>
#include <optional>
#include <regex>
#include <utility>
#include <vector>

#include "bridge/step.h"
#include "core/error.h"
#include "course/course.h"
#include "course/path.h"
#include "course/robot_file.h"
#include "identify/identify.h"
#include "live/services.h"
#include "messages/messages.h"
#include "terrain/world.h"
#include "text/json_writer.h"

namespace tp100::live {
namespace {

using course::Bundled;
using text::JsonWriter;

/// Points of the path, thinned out evenly; the last one stays.
std::vector<course::PathPoint> outline(const course::Path& path) {
  std::vector<course::PathPoint> all = messages::path_points(path);
  if (all.size() <= kMaxOutline) return all;
  std::vector<course::PathPoint> out;
  for (std::size_t i = 0; i < kMaxOutline; ++i)
    out.push_back(all[i * (all.size() - 1) / (kMaxOutline - 1)]);
  return out;
}

void write_piece(JsonWriter& json, const course::Place& place, double length_m, double width_m) {
  json.fields(place).field("length_m", length_m).field("width_m", width_m);
}

void write_course(JsonWriter& json, const course::Course& course) {
  const course::Path path(course);
  json.field("description", course.description)
      .field("identifies", course.identifies)
      .field("speed_mps", course.speed_mps)
      .field("length_m", path.length_m())
      .field("disturbances", course.disturbances.size());
  json.object("start", [&] { json.floor_pose(course.start); });
  const course::Fence& fence = course.fence;
  json.object("fence", [&] {
    json.field("min_x_m", fence.min_x_m)
        .field("max_x_m", fence.max_x_m)
        .field("min_y_m", fence.min_y_m)
        .field("max_y_m", fence.max_y_m);
  });
  json.objects("outline", outline(path), [&](const course::PathPoint& point) {
    json.field("x_m", point.x_m).field("y_m", point.y_m);
  });
  json.objects("obstacles", terrain::outlines_of(course.terrain), [&](const terrain::Outline& of) {
    write_piece(json, of.place, of.length_m(), 2.0 * of.half_width_m);
    json.field("kind", to_string(of.obstacle));
  });
  json.objects("surfaces", course.terrain.surfaces, [&](const course::Surface& surface) {
    write_piece(json, surface.place, surface.length_m, surface.width_m);
  });
}

config::LoadedRun with_file(const config::LoadedRun& run, Bundled kind,
                            const course::TextFile& file) {
  return kind == Bundled::kCourses
             ? config::with_files(run, file, run.files.robot, run.files.setup)
             : config::with_files(run, run.files.course, file, run.files.setup);
}

void write_entry(JsonWriter& json, const config::SetupFiles& files, const config::LoadedRun& run,
                 Bundled kind, const config::SetupFiles::Entry& entry) {
  const bool is_course = kind == Bundled::kCourses;
  const course::Course* course = run.setup.course.get();
  const bool in_force = is_course ? course != nullptr && course->name == entry.name
                                  : run.setup.robot.name == entry.name;
  json.field("name", entry.name).field("from", to_string(entry.from)).field("in_force", in_force);
  std::string why;
  try {
    const config::LoadedRun with = with_file(run, kind, files.read(kind, entry.name));
    if (is_course) {
      write_course(json, *with.setup.course);
    } else {
      json.field("description", with.setup.robot.description);
    }
    const bridge::Step step(with.setup.parameters, with.setup.course);
    if (is_course) json.field("duration_s", step.nominal_duration_s());
    config::require_fit(with.setup);
  } catch (const UserError& error) {
    why = error.what();
  }
  json.field("why_not", why);
}

/// As the channel /course has it.
std::string course_text(std::shared_ptr<const course::Course> course, const course::Robot& robot) {
  messages::RunContext context;
  context.course = std::move(course);
  context.robot = robot;
  return messages::Messages(std::move(context), {}).course();
}

/// Writes `message`, and its place apart from it if it begins with one: "NAME:line:column: ".
void write_error(JsonWriter& json, const std::string& message, const std::string& name) {
  static const std::regex kPlace(R"(:(\d{1,9}):(\d{1,9}): (.*))");
  std::smatch place;
  const std::string rest = message.starts_with(name) ? message.substr(name.size()) : "";
  const bool placed = std::regex_match(rest, place, kPlace);
  json.field("error", placed ? place[3].str() : message);
  if (placed) json.field("line", std::stoi(place[1])).field("column", std::stoi(place[2]));
}

}  // namespace

std::string setup_list(const config::SetupFiles& files, const config::LoadedRun& run) {
  const auto& setup = run.setup;
  return text::json_object([&](JsonWriter& json) {
    json.field("course", setup.course == nullptr ? "" : setup.course->name)
        .field("robot", setup.robot.name)
        .field("setup", bridge::to_string(setup.parameters.setup));
    json.key("setups").begin_array();
    for (const auto& each : bridge::kSetupNames) json.value(each.name);
    json.end_array();
    json.field("may_save", files.may_save())
        .values("calibration", identify::calibration_courses(setup.robot.shape));
    for (const auto& [name, kind] :
         {std::pair{"courses", Bundled::kCourses}, std::pair{"robots", Bundled::kRobots}})
      json.objects(name, files.list(kind), [&](const config::SetupFiles::Entry& entry) {
        write_entry(json, files, run, kind, entry);
      });
  });
}

CheckedFile checked_file(const config::LoadedRun& run, Bundled kind, const course::TextFile& file) {
  CheckedFile checked;
  std::string why_not;
  std::shared_ptr<const course::Course> course;
  std::optional<double> duration_s;
  try {
    if (kind == Bundled::kCourses) {
      course::Draft draft = course::parse_draft(file.text, file.path);
      course = std::make_shared<const course::Course>(std::move(draft.course));
      if (!draft.error.empty()) throw UserError(draft.error);
    } else {
      course::parse_robot(file.text, file.path);
    }
    try {
      const config::RunSetup with = with_file(run, kind, file).setup;
      const bridge::Step step(with.parameters, with.course);
      duration_s = step.nominal_duration_s();
      config::require_fit(with);
    } catch (const UserError& misfit) {
      why_not = misfit.what();
    }
  } catch (const UserError& error) {
    checked.error = error.what();
  }
  checked.json = text::json_object([&](JsonWriter& json) {
    write_error(json, checked.error, file.path);
    json.field("why_not", why_not);
    if (course == nullptr) return;
    json.field("length_m", course::Path(*course).length_m()).field("duration_s", duration_s);
    json.key("course").raw(course_text(course, run.setup.robot));
  });
  return checked;
}

}  // namespace tp100::live
