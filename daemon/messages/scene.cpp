#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "messages/foxglove.h"
#include "terrain/world.h"

namespace tp100::messages {
namespace {

constexpr double kPathLiftM = 0.002;  // above the floor, so that the two do not flicker
constexpr Colour kFenceColour{0.65, 0.65, 0.65, 1.0};
constexpr Colour kRampColour{0.72, 0.60, 0.42, 1.0};
constexpr Colour kBlockColour{0.55, 0.45, 0.35, 1.0};
constexpr Colour kSurfaceColour{0.35, 0.55, 0.60, 0.6};
constexpr Colour kBodyColour{0.20, 0.72, 0.35, 1.0};
constexpr Colour kTrackColour{0.12, 0.12, 0.12, 1.0};

Pose pose_of(const course::Place& place, double z_m) {
  return {.x_m = place.x_m, .y_m = place.y_m, .z_m = z_m, .yaw_rad = place.heading_rad};
}

std::string cube(const Pose& pose, const Point& size, const Colour& colour) {
  return text::json_object([&](text::JsonWriter& json) {
    write_foxglove_pose(json, pose);
    write_xyz(json, "size", size);
    write_colour(json, colour);
  });
}

/// A list of triangles, two for each quad a, b, c, d.
class Triangles {
 public:
  void quad(Point a, Point b, Point c, Point d) {
    for (const Point& corner : {a, b, c, a, c, d}) points_.push_back(corner);
  }
  std::string json(const Pose& pose, const Colour& colour) const {
    return text::json_object([&](text::JsonWriter& json) {
      write_foxglove_pose(json, pose);
      write_vertices(json, points_, colour);
    });
  }

 private:
  std::vector<Point> points_;
};

std::string obstacle_triangles(const terrain::Outline& outline) {
  const auto at = [&](std::size_t i, double side) {
    const terrain::Outline::Point& point = outline.points[i];
    return Point{point.along_m, side * outline.half_width_m, point.height_m};
  };
  Triangles out;
  for (std::size_t i = 0; i + 1 < outline.points.size(); ++i)
    out.quad(at(i, -1), at(i + 1, -1), at(i + 1, 1), at(i, 1));
  for (const double side : {-1.0, 1.0})
    out.quad(at(0, side), at(3, side), at(2, side), at(1, side));
  return out.json(pose_of(outline.place, 0.0),
                  outline.obstacle == ObstacleClass::kBlock ? kBlockColour : kRampColour);
}

void write_course(text::JsonWriter& json, const Messages& messages, std::uint64_t at) {
  std::vector<Point> points;
  for (const course::PathPoint& point : path_points(*messages.path()))
    points.push_back({point.x_m, point.y_m, kPathLiftM});
  write_entity(json, {.id = "course/path", .lines = line_strip(points, 0.006, kPathColour)}, at);

  const course::Course& course = *messages.run_context().course;
  const auto write_border = [&](const std::string& id, const course::Polygon& polygon) {
    std::vector<Point> corners;
    for (const course::Vertex& corner : polygon) corners.push_back({corner.x_m, corner.y_m, 0});
    corners.push_back(corners.front());
    write_entity(json, {.id = id, .lines = line_strip(corners, 0.004, kFenceColour)}, at);
  };
  write_border("course/fence", course::corners_of(course.fence));
  std::size_t number = 0;
  for (const course::Polygon& area : course.fence.keep_out)
    write_border("course/keep_out/" + std::to_string(number++), area);

  std::map<std::string, std::size_t> numbers;
  for (const terrain::Outline& outline : terrain::outlines_of(course.terrain)) {
    const std::string id = std::string("course/") + to_string(outline.obstacle) + "/";
    write_entity(
        json, {.id = id + std::to_string(numbers[id]++), .triangles = obstacle_triangles(outline)},
        at);
  }
  number = 0;
  for (const course::Surface& surface : course.terrain.surfaces)
    write_entity(json,
                 {.id = "course/surface/" + std::to_string(number++),
                  .cubes = cube(pose_of(surface.place, 0.0005),
                                {surface.length_m, surface.width_m, 0.001}, kSurfaceColour)},
                 at);
}

void write_robot(text::JsonWriter& json, const course::Robot& robot, std::uint64_t at) {
  const course::ShapeValues& shape = robot.shape;
  const double track_m = robot.emulated.body.shoe_width_m;
  const double track_height_m = 2.0 * shape.wheel_radius_m;
  const double body_height_m = std::max(0.01, shape.height_m - shape.wheel_radius_m);
  const Pose body{.z_m = shape.wheel_radius_m + body_height_m / 2.0};
  write_entity(
      json,
      {.id = "robot/body",
       .frame = "robot",
       .cubes = cube(body,
                     {shape.length_m * 0.9, std::max(0.01, shape.gauge_m - track_m), body_height_m},
                     kBodyColour)},
      at);
  for (const bool left : {true, false}) {
    const Pose track{.y_m = (left ? 0.5 : -0.5) * shape.gauge_m, .z_m = shape.wheel_radius_m};
    write_entity(json,
                 {.id = left ? "robot/left" : "robot/right",
                  .frame = "robot",
                  .cubes = cube(track, {shape.length_m, track_m, track_height_m}, kTrackColour)},
                 at);
  }
}

}  // namespace

std::string scene_text(const Messages& messages, HostNs at) {
  const std::uint64_t unix_ns = messages.clock().unix_ns(at);
  return scene_update(unix_ns, true, [&](text::JsonWriter& json) {
    if (messages.path() != nullptr) write_course(json, messages, unix_ns);
    write_robot(json, messages.run_context().robot, unix_ns);
  });
}

}  // namespace tp100::messages
