#include "report/replay_view.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "course/path.h"
#include "report/report_figures.h"

namespace tp100::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxFrames = 2000;

double rounded(double value) { return std::round(value * 1e5) / 1e5; }

Json place(double x_m, double y_m, double z_m) {
  return Json::array({rounded(x_m), rounded(y_m), rounded(z_m)});
}

Json json_of(const Pose& pose) {
  return Json::array({rounded(pose.x_m), rounded(pose.y_m), rounded(pose.z_m),
                      rounded(pose.roll_rad), rounded(pose.pitch_rad), rounded(pose.yaw_rad)});
}

Json robot_of(const course::Robot& robot) {
  return {{"length", robot.shape.length_m},
          {"gauge", robot.shape.gauge_m},
          {"track", robot.emulated.body.shoe_width_m},
          {"height", robot.shape.height_m},
          {"radius", robot.shape.wheel_radius_m}};
}

Json frames_of(const RecordedRun& run) {
  Json frames = {{"t", Json::array()},
                 {"robot", Json::array()},
                 {"left", Json::array()},
                 {"right", Json::array()},
                 {"truth", Json::array()}};
  const std::vector<TrajectoryPoint>& points = run.result.points;
  const std::size_t every = points.size() / kMaxFrames + 1;
  double left_m = 0.0, right_m = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const TrajectoryPoint& point = points[i];
    const RunMoment& moment = run.moments[i];
    const double dt_s = i > 0 ? point.t_s - points[i - 1].t_s : 0.0;
    if (std::isfinite(moment.left_mps)) left_m += moment.left_mps * dt_s;
    if (std::isfinite(moment.right_mps)) right_m += moment.right_mps * dt_s;
    if (i % every != 0 && i + 1 != points.size()) continue;
    // Estimates do not contain the floor's height; the world does.
    const double z_m = moment.steering_world.z_m;
    frames["t"].push_back(rounded(point.t_s));
    frames["robot"].push_back(json_of(moment.steering_world));
    frames["left"].push_back(rounded(left_m));
    frames["right"].push_back(rounded(right_m));
    frames["truth"].push_back(run.has_truth ? json_of(point.world) : Json());
    for (const PoseSource source : kPoseSources) {
      const Pose& pose = point.estimates[source];
      frames[to_string(source)].push_back(place(pose.x_m, pose.y_m, z_m));
    }
  }
  return frames;
}

void add_course(const course::Course& course, Json& view) {
  for (const auto& [x_m, y_m] : path_line(course))
    view["path"].push_back(Json::array({rounded(x_m), rounded(y_m)}));
  for (const course::Ramp& r : course.terrain.ramps)
    view["ramps"].push_back({r.place.x_m, r.place.y_m, r.place.heading_rad, r.height_m,
                             r.up_length_m(), r.top_m, r.down_length_m(), r.width_m});
  for (const course::Block& b : course.terrain.blocks)
    view["blocks"].push_back(
        {b.place.x_m, b.place.y_m, b.place.heading_rad, b.height_m, b.depth_m, b.width_m});
  for (const course::Surface& s : course.terrain.surfaces)
    view["surfaces"].push_back(
        {s.place.x_m, s.place.y_m, s.place.heading_rad, s.length_m, s.width_m});
}

/// Adds the centre and the extent of the view.
void add_extent(const RecordedRun& run, Json& view) {
  double low_x = 0.0, high_x = 0.0, low_y = 0.0, high_y = 0.0;
  bool any = false;
  const auto widen = [&](double x_m, double y_m) {
    low_x = any ? std::min(low_x, x_m) : x_m;
    high_x = any ? std::max(high_x, x_m) : x_m;
    low_y = any ? std::min(low_y, y_m) : y_m;
    high_y = any ? std::max(high_y, y_m) : y_m;
    any = true;
  };
  for (const Json& point : view["path"]) widen(point[0], point[1]);
  for (const RunMoment& moment : run.moments)
    widen(moment.steering_world.x_m, moment.steering_world.y_m);
  view["middle"] = {rounded((low_x + high_x) / 2.0), rounded((low_y + high_y) / 2.0)};
  view["size"] = rounded(std::max({high_x - low_x, high_y - low_y, 0.5}));
}

}  // namespace

std::string replay_view(const RecordedRun& run) {
  Json view = {{"frames", frames_of(run)},       {"path", Json::array()},
               {"ramps", Json::array()},         {"blocks", Json::array()},
               {"surfaces", Json::array()},      {"robot", robot_of(run.run_context.robot)},
               {"path_histories", Json::array()}};
  for (const PoseSource source : kPoseSources)
    if (run.result.has_estimate(source)) view["path_histories"].push_back(to_string(source));
  if (run.has_truth) view["path_histories"].push_back("truth");
  if (run.run_context.course != nullptr) add_course(*run.run_context.course, view);
  add_extent(run, view);
  std::string key;
  for (const Json& name : view["path_histories"]) {
    const auto text = name.get<std::string>();
    key += "<span style='color:var(--" + text + ")'>" + text + "</span> ";
  }
  return "<figure id='replay' class='wide'><canvas width='1000' height='520' tabindex='0' "
         "role='img' aria-label='The run in three dimensions'></canvas>"
         "<div class='controls'><button type='button'>Play</button>"
         "<input type='range' min='0' step='0.01' value='0' aria-label='time'>"
         "<output></output><select aria-label='speed'><option value='1'>1 x</option>"
         "<option value='5'>5 x</option><option value='20'>20 x</option></select>"
         "<label><input type='checkbox'>follow</label></div>"
         "<figcaption>" +
         key +
         "Drag to turn, wheel to zoom. The robot is drawn at the steering pose; its outline on the "
         "floor at the true pose, where that is known.</figcaption></figure>\n<script>\n" +
         std::string(kReplayScript) + "tp100Replay(document.getElementById('replay'), " +
         view.dump(-1, ' ', true, Json::error_handler_t::replace) + ");\n</script>\n";
}

}  // namespace tp100::report
