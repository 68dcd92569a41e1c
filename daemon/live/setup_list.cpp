#include "live/setup_list.h"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <utility>

#include "bridge/step.h"
#include "core/error.h"
#include "course/course.h"
#include "course/path.h"
#include "course/robot_file.h"
#include "identify/identify.h"
#include "messages/messages.h"
#include "terrain/climbable.h"
#include "terrain/world.h"

namespace tp100::live {
namespace {

using course::Bundled;
using Json = nlohmann::ordered_json;

/// Points of the path, thinned out evenly; the last one stays.
std::vector<course::PathPoint> outline(const course::Path& path) {
  std::vector<course::PathPoint> all = messages::path_points(path);
  if (all.size() <= kMaxOutline) return all;
  std::vector<course::PathPoint> out;
  for (std::size_t i = 0; i < kMaxOutline; ++i)
    out.push_back(all[i * (all.size() - 1) / (kMaxOutline - 1)]);
  return out;
}

Json piece(const course::Place& place, double length_m, double width_m) {
  return {{"x_m", place.x_m},
          {"y_m", place.y_m},
          {"heading_rad", place.heading_rad},
          {"length_m", length_m},
          {"width_m", width_m}};
}

Json course_json(const course::Course& course) {
  const course::Path path(course);
  const Pose& start = course.start;
  const course::Fence& fence = course.fence;
  Json json = {{"description", course.description},
               {"identifies", course.identifies},
               {"speed_mps", course.speed_mps},
               {"length_m", path.length_m()},
               {"disturbances", course.disturbances.size()},
               {"start", {{"x_m", start.x_m}, {"y_m", start.y_m}, {"yaw_rad", start.yaw_rad}}},
               {"fence",
                {{"min_x_m", fence.min_x_m},
                 {"max_x_m", fence.max_x_m},
                 {"min_y_m", fence.min_y_m},
                 {"max_y_m", fence.max_y_m}}}};
  for (const char* list : {"outline", "obstacles", "surfaces"}) json[list] = Json::array();
  for (const course::PathPoint& point : outline(path))
    json["outline"].push_back({{"x_m", point.x_m}, {"y_m", point.y_m}});
  for (const terrain::Outline& each : terrain::outlines_of(course.terrain)) {
    json["obstacles"].push_back(piece(each.place, each.length_m(), 2.0 * each.half_width_m));
    json["obstacles"].back()["kind"] = to_string(each.obstacle);
  }
  for (const course::Surface& surface : course.terrain.surfaces)
    json["surfaces"].push_back(piece(surface.place, surface.length_m, surface.width_m));
  return json;
}

config::LoadedRun with_file(const config::LoadedRun& run, Bundled kind,
                            const course::TextFile& file) {
  return kind == Bundled::kCourses
             ? config::with_files(run, file, run.files.robot, run.files.setup)
             : config::with_files(run, run.files.course, file, run.files.setup);
}

/// Throws UserError if the run's files do not fit together.
void set_fit(Json& json, const config::RunSetup& run, bool is_course) {
  const bridge::Step step(run.parameters, run.course);
  if (is_course) json["duration_s"] = step.nominal_duration_s();
  require_fit(run);
}

/// `message` without its place in the file, "NAME:line:column: ", which is set.
std::string set_place(Json& json, const std::string& message, const std::string& name) {
  static const std::regex kPlace(R"(:(\d{1,9}):(\d{1,9}): (.*))");
  std::smatch place;
  if (!message.starts_with(name)) return message;
  const std::string rest = message.substr(name.size());
  if (!std::regex_match(rest, place, kPlace)) return message;
  json["line"] = std::stoi(place[1]);
  json["column"] = std::stoi(place[2]);
  return place[3];
}

Json entry_json(const config::SetupFiles& files, const config::LoadedRun& run, Bundled kind,
                const config::SetupFiles::Entry& entry) {
  Json json = {{"name", entry.name}, {"from", to_string(entry.from)}};
  std::string why;
  const bool is_course = kind == Bundled::kCourses;
  const course::Course* course = run.setup.course.get();
  const bool in_force = is_course ? course != nullptr && course->name == entry.name
                                  : run.setup.robot.name == entry.name;
  try {
    const course::TextFile file = files.read(kind, entry.name);
    const config::LoadedRun with = with_file(run, kind, file);
    if (is_course) {
      json.update(course_json(*with.setup.course));
    } else {
      json["description"] = with.setup.robot.description;
    }
    set_fit(json, with.setup, is_course);
  } catch (const UserError& error) {
    why = error.what();
  }
  json["in_force"] = in_force;
  json["why_not"] = why;
  return json;
}

/// As the channel /course has it.
std::string course_text(course::Course course, const course::Robot& robot) {
  messages::RunContext context;
  context.course = std::make_shared<const course::Course>(std::move(course));
  context.robot = robot;
  return messages::Messages(std::move(context), {}).course();
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void require_fit(const config::RunSetup& run) {
  if (!run.configuration.camera.listen.empty() && run.parameters.setup == bridge::Setup::kStand)
    throw UserError("--camera: on a stand it sees a robot that stands still; leave it out");
  if (run.course != nullptr) terrain::require_climbable(*run.course, run.robot);
}

std::string setup_list(const config::SetupFiles& files, const config::LoadedRun& run) {
  const auto& setup = run.setup;
  Json json = {{"course", setup.course == nullptr ? "" : setup.course->name},
               {"robot", setup.robot.name},
               {"setup", bridge::to_string(setup.parameters.setup)},
               {"setups", Json::array()},
               {"may_save", files.may_save()},
               {"calibration", identify::calibration_courses(setup.robot.shape)}};
  for (const auto& each : bridge::kSetupNames) json["setups"].push_back(each.name);
  for (const Bundled kind : {Bundled::kCourses, Bundled::kRobots}) {
    Json& list = json[kind == Bundled::kCourses ? "courses" : "robots"] = Json::array();
    for (const config::SetupFiles::Entry& entry : files.list(kind))
      list.push_back(entry_json(files, run, kind, entry));
  }
  return text_of(json);
}

std::string checked_file(const config::LoadedRun& run, Bundled kind, const course::TextFile& file) {
  const bool is_course = kind == Bundled::kCourses;
  Json json = {{"error", ""}, {"why_not", ""}};
  std::string drawn;
  try {
    if (is_course) {
      course::Draft draft = course::parse_draft(file.text, file.path);
      json["length_m"] = course::Path(draft.course).length_m();
      drawn = course_text(std::move(draft.course), run.setup.robot);
      if (!draft.error.empty()) throw UserError(draft.error);
    } else {
      course::parse_robot(file.text, file.path);
    }
    try {
      set_fit(json, with_file(run, kind, file).setup, is_course);
    } catch (const UserError& misfit) {
      json["why_not"] = misfit.what();
    }
  } catch (const UserError& error) {
    json["error"] = set_place(json, error.what(), file.path);
  }
  std::string text = text_of(json);
  if (!drawn.empty()) text.replace(text.size() - 1, 1, ",\"course\":" + drawn + "}");
  return text;
}

}  // namespace tp100::live
