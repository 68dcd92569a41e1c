#include "report/replay_view.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "course/path.h"
#include "report/report_figures.h"

namespace tp100::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostFrames = 2000;
constexpr int kPathPoints = 600;

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
          {"belt", robot.emulated.body.belt_width_m},
          {"height", robot.shape.height_m},
          {"radius", robot.shape.belt_radius_m}};
}

Json frames_of(const RecordedRun& run) {
  Json frames = {{"t", Json::array()},        {"robot", Json::array()}, {"left", Json::array()},
                 {"right", Json::array()},    {"truth", Json::array()}, {"model", Json::array()},
                 {"odometry", Json::array()}, {"fused", Json::array()}};
  const std::vector<TrackPoint>& points = run.result.points;
  const std::size_t every = points.size() / kMostFrames + 1;
  double left_m = 0.0, right_m = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const TrackPoint& point = points[i];
    const RunMoment& moment = run.moments[i];
    const double dt_s = i > 0 ? point.t_s - points[i - 1].t_s : 0.0;
    if (std::isfinite(moment.left_mps)) left_m += moment.left_mps * dt_s;
    if (std::isfinite(moment.right_mps)) right_m += moment.right_mps * dt_s;
    if (i % every != 0 && i + 1 != points.size()) continue;
    // Estimates know nothing of the floor's height; the world does.
    const double z_m = moment.steering_world.z_m;
    frames["t"].push_back(rounded(point.t_s));
    frames["robot"].push_back(json_of(moment.steering_world));
    frames["left"].push_back(rounded(left_m));
    frames["right"].push_back(rounded(right_m));
    frames["truth"].push_back(run.has_truth ? json_of(point.world) : Json());
    frames["model"].push_back(place(point.model.x_m, point.model.y_m, z_m));
    frames["odometry"].push_back(place(point.odometry.x_m, point.odometry.y_m, z_m));
    frames["fused"].push_back(place(point.fused.x_m, point.fused.y_m, z_m));
  }
  return frames;
}

void add_course(const course::Course& course, Json& view) {
  const course::Path path(course);
  for (int i = 0; i <= kPathPoints; ++i) {
    const course::PathPoint at = path.at(path.length_m() * i / kPathPoints);
    view["path"].push_back(Json::array({rounded(at.x_m), rounded(at.y_m)}));
  }
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

/// Where to look at and how far around.
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
  Json view = {{"frames", frames_of(run)},
               {"path", Json::array()},
               {"ramps", Json::array()},
               {"blocks", Json::array()},
               {"surfaces", Json::array()},
               {"robot", robot_of(run.subject.robot)},
               {"trails", Json::array({"model", "odometry"})}};
  if (run.result.has_camera) view["trails"].push_back("fused");
  if (run.has_truth) view["trails"].push_back("truth");
  view["colours"] = {{"path", kPathColour},
                     {"truth", kTruthColour},
                     {"model", kModelColour},
                     {"odometry", kOdometryColour},
                     {"fused", kFusedColour}};
  if (run.subject.course != nullptr) add_course(*run.subject.course, view);
  add_extent(run, view);
  return "<figure id='replay'><canvas width='1000' height='520' tabindex='0' "
         "style='width:100%;touch-action:none;border:1px solid #999'></canvas>"
         "<div style='display:flex;gap:.8em;align-items:center'><button type='button'>Play</button>"
         "<input type='range' min='0' step='0.01' value='0' aria-label='time' style='flex:1'>"
         "<output></output><select aria-label='speed'><option value='1'>1 x</option>"
         "<option value='5'>5 x</option><option value='20'>20 x</option></select>"
         "<label><input type='checkbox'>follow</label></div>"
         "<figcaption>Drag to turn, wheel to come nearer. The robot stands where the pose that "
         "steers puts it; its outline on the floor is where it truly was, where that is known."
         "</figcaption></figure>\n<script>\n" +
         std::string(kReplayScript) + "tp100Replay(document.getElementById('replay'), " +
         view.dump(-1, ' ', true, Json::error_handler_t::replace) + ");\n</script>\n";
}

}  // namespace tp100::report
