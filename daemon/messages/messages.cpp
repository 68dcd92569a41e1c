#include "messages/messages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/enum_names.h"
#include "core/faults.h"
#include "terrain/world.h"
#include "text/json_writer.h"

namespace tp100::messages {
namespace {

constexpr double kPathSpacingM = 0.02;

void write_motion(text::JsonWriter& json, const Estimate& estimate) {
  json.fields(estimate.pose).fields(estimate.twist);
  json.field("sd_x_m", std::sqrt(estimate.covariance.xx))
      .field("sd_y_m", std::sqrt(estimate.covariance.yy))
      .field("sd_yaw_rad", std::sqrt(estimate.covariance.yaw_yaw));
}

void write_filter(text::JsonWriter& json, const FilterFigures& filter) {
  if (filter.camera_age_us >= 0) json.field("camera_age_us", filter.camera_age_us);
  json.field("camera_used", filter.camera_used)
      .field("camera_rejected", filter.camera_rejected)
      .field("nis", filter.nis)
      .field("nis_mean", filter.nis_mean)
      .field("recoveries", filter.recoveries);
}

void write_tracks(text::JsonWriter& json, const StepRecord& record) {
  const Snapshot& snapshot = record.snapshot;
  json.field("left_mps", snapshot.left_mps).field("right_mps", snapshot.right_mps);
  if (record.command_valid)
    json.field("left_commanded_mps", snapshot.commanded_left_mps)
        .field("right_commanded_mps", snapshot.commanded_right_mps);
}

void write_terrain(text::JsonWriter& json, const course::Terrain& terrain) {
  json.objects("obstacles", terrain::outlines_of(terrain), [&](const terrain::Outline& outline) {
    json.field("kind", to_string(outline.obstacle)).fields(outline.place);
    json.field("width_m", 2.0 * outline.half_width_m);
    json.objects("profile", outline.points, [&](const terrain::Outline::Point& point) {
      json.field("along_m", point.along_m).field("height_m", point.height_m);
    });
  });
  json.objects("surfaces", terrain.surfaces,
               [&](const course::Surface& surface) { json.fields(surface); });
}

course::PathPoint between(const course::PathPoint& a, const course::PathPoint& b, double share) {
  const auto mean = [share](double from, double to) { return from + share * (to - from); };
  return {mean(a.s_m, b.s_m), mean(a.x_m, b.x_m), mean(a.y_m, b.y_m), mean(a.yaw_rad, b.yaw_rad)};
}

struct GroundPoint {
  course::PathPoint at{};
  double z_m = 0.0;
};

/// The path's points on the ground; where it is not level, with more points between them.
std::vector<GroundPoint> ground_points(const course::Path& path, const terrain::World& world) {
  constexpr std::size_t kParts = 4;
  const std::vector<course::PathPoint> points = path_points(path);
  const std::size_t parts = points.size() <= kMaxPathPoints / kParts ? kParts : 1;
  const auto on_ground = [&](const course::PathPoint& at) {
    return GroundPoint{at, world.height_m(at.x_m, at.y_m)};
  };
  std::vector<GroundPoint> ground = {on_ground(points.front())};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const GroundPoint next = on_ground(points[i]);
    std::vector<GroundPoint> finer;
    bool level = next.z_m == ground.back().z_m;
    for (std::size_t k = 1; k < parts && !world.flat(); ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(parts);
      finer.push_back(on_ground(between(points[i - 1], points[i], share)));
      level = level && finer.back().z_m == next.z_m;
    }
    if (!level) ground.insert(ground.end(), finer.begin(), finer.end());
    ground.push_back(next);
  }
  return ground;
}

void write_path(text::JsonWriter& json, const course::Path* path, const terrain::World& world) {
  const auto points = path == nullptr ? std::vector<GroundPoint>{} : ground_points(*path, world);
  json.objects("path", points, [&](const GroundPoint& point) {
    json.floor_pose(point.at).field("z_m", point.z_m).field("s_m", point.at.s_m);
  });
  static const std::vector<course::PathSegment> kNone;
  json.objects("segments", path == nullptr ? kNone : path->segments(),
               [&](const course::PathSegment& segment) {
                 json.field("kind", name_in(course::kSegmentKindNames, segment.kind))
                     .field("from_m", segment.begin.s_m)
                     .field("to_m", segment.end.s_m);
                 json.object("begin", [&] { json.floor_pose(segment.begin); });
                 json.object("end", [&] { json.floor_pose(segment.end); });
               });
}

void write_robot(text::JsonWriter& json, const course::Robot& robot) {
  json.field("name", robot.name)
      .field("length_m", robot.shape.length_m)
      .field("width_m", robot.emulated.body.width_m)
      .field("height_m", robot.shape.height_m)
      .field("gauge_m", robot.shape.gauge_m)
      .field("axle_spacing_m", robot.shape.axle_spacing_m)
      .field("wheel_radius_m", robot.shape.wheel_radius_m)
      .field("shoe_width_m", robot.emulated.body.shoe_width_m);
}

void write_corners(text::JsonWriter& json, const course::Polygon& polygon) {
  json.objects("corners", polygon, [&](const course::Vertex& corner) { json.fields(corner); });
}

}  // namespace

std::vector<course::PathPoint> path_points(const course::Path& path) {
  // Each segment adds at most one point to those that are one spacing apart.
  const double free = static_cast<double>(kMaxPathPoints - 1 - path.segments().size());
  const double spacing_m = std::max(kPathSpacingM, path.length_m() / free);
  std::vector<course::PathPoint> points;
  for (std::size_t i = 0; i < path.segments().size(); ++i) {
    const course::PathSegment& segment = path.segments()[i];
    const auto parts = static_cast<std::size_t>(std::ceil(segment.length_m / spacing_m));
    if (i == 0) points.push_back(segment.begin);
    for (std::size_t k = 1; k < parts; ++k)
      points.push_back(
          path.at(i, segment.length_m * static_cast<double>(k) / static_cast<double>(parts)));
    points.push_back(segment.end);
  }
  return points;
}

Messages::Messages(RunContext run_context, PublishClock clock)
    : run_context_(std::move(run_context)), clock_(clock) {
  if (run_context_.course != nullptr) path_.emplace(*run_context_.course);
}

std::string Messages::estimate(const StepRecord& record, const std::optional<Truth>& truth) const {
  const Snapshot& snapshot = record.snapshot;
  return text::json_object([&](text::JsonWriter& json) {
    json.field("t_s", clock_.t_s(record.now_ns)).field("step", record.step);
    if (snapshot.has_sample) json.field("age_us", snapshot.age_us);
    json.field("steering", to_string(snapshot.steering));
    for (const PoseSource source : kPoseSources)
      json.object(to_string(source), [&] {
        write_motion(json, snapshot.estimates[source]);
        if (source == PoseSource::kFused) write_filter(json, snapshot.filter);
      });
    json.object("world", [&] { json.fields(snapshot.world); });
    if (truth)
      json.object("truth", [&] {
        json.fields(truth->pose);
        json.field("age_us", (record.now_ns - truth->at_ns) / kNsPerUs);
      });
    if (path() != nullptr) {
      const course::PathPoint point = path()->at(snapshot.progress_m);
      json.object("reference", [&] { json.floor_pose(point); });
    }
    json.object("imu", [&] {
      json.field("roll_rad", snapshot.imu_roll_rad)
          .field("pitch_rad", snapshot.imu_pitch_rad)
          .field("slope", to_string(snapshot.imu_slope))
          .field("obstacle_class", to_string(snapshot.imu_obstacle));
    });
    const TerrainContact& contact = snapshot.terrain_contact;
    json.field("pitch_source", to_string(contact.pitch_source));
    json.object("terrain_contact", [&] {
      json.field("obstacle", to_string(contact.obstacle))
          .field("climbing", contact.climbing)
          .field("slope_rad", contact.slope_rad)
          .field("traction", to_string(contact.traction));
    });
    json.object("tracks", [&] { write_tracks(json, record); });
    json.field("cross_track_m", snapshot.cross_track_m)
        .field("heading_error_rad", snapshot.heading_error_rad)
        .field("desired_yaw_rad", snapshot.command.desired_yaw_rad)
        .field("desired_speed_mps", snapshot.command.speed_mps)
        .field("at_fence", snapshot.at_fence)
        .field("progress_m", snapshot.progress_m)
        .field("recovering", snapshot.recovering);
  });
}

std::string Messages::sample(const Sample& sample, HostNs now) const {
  std::vector<std::string_view> faults;
  each_fault(sample.faults, [&](Fault fault) { faults.push_back(describe(fault).name); });
  return text::json_object([&](text::JsonWriter& json) {
    json.field("t_s", clock_.t_s(sample.measured_ns))
        .field("sequence", sample.sequence)
        .field("lost_before", sample.lost_before)
        .field("device_us", sample.device_us)
        .field("age_us", (now - sample.measured_ns) / kNsPerUs)
        .field("left_counts", sample.left_counts)
        .field("right_counts", sample.right_counts)
        .values("gyro_radps", sample.gyro_radps)
        .values("accel_mps2", sample.accel_mps2)
        .field("temperature_degc", sample.temperature_degc)
        .field("battery_v", sample.battery_v)
        .field("left_duty", sample.left_duty)
        .field("right_duty", sample.right_duty)
        .field("state", to_string(sample.state))
        .values("faults", faults)
        .field("imu_age", sample.imu_age);
  });
}

std::string Messages::command(const StepRecord& record) const {
  const Command& command = record.snapshot.command;
  return text::json_object([&](text::JsonWriter& json) {
    json.field("t_s", clock_.t_s(record.now_ns))
        .field("answers", command.answers)
        .floor_pose(command.pose)
        .field("desired_yaw_rad", command.desired_yaw_rad)
        .field("yaw_rate_radps", command.yaw_rate_radps)
        .field("speed_mps", command.speed_mps)
        .field("gyro_bias_radps", command.gyro_bias_radps);
    if (!record.inputs.clock.valid) return;
    const HostNs left_ns = record.inputs.clock.to_host(command.expiry_us) - record.now_ns;
    json.field("expires_in_ms", to_s(left_ns) * 1e3);
  });
}

std::string Messages::slip(const StepRecord& record) const {
  const Snapshot& snapshot = record.snapshot;
  return text::json_object([&](text::JsonWriter& json) {
    json.field("t_s", clock_.t_s(record.now_ns))
        .field("left", snapshot.slip_left)
        .field("right", snapshot.slip_right)
        .field("fused_left", snapshot.filter.slip_left)
        .field("fused_right", snapshot.filter.slip_right)
        .field("gyro_bias_radps", snapshot.gyro_bias_radps)
        .field("fused_gyro_bias_radps", snapshot.filter.gyro_bias_radps)
        .field("slope_rad", snapshot.terrain_contact.slope_rad);
  });
}

std::string Messages::course() const {
  static const course::Course kNone{};
  const course::Course& course = run_context_.course == nullptr ? kNone : *run_context_.course;
  return text::json_object([&](text::JsonWriter& json) {
    json.field("name", course.name)
        .field("description", course.description)
        .field("speed_mps", course.speed_mps)
        .field("length_m", path() == nullptr ? 0.0 : path()->length_m());
    json.object("start", [&] { json.floor_pose(course.start); });
    write_path(json, path(), terrain::World(course.terrain, run_context_.robot.shape));
    write_terrain(json, course.terrain);
    json.objects("disturbances", course.disturbances,
                 [&](const course::Disturbance& one) { json.fields(one); });
    if (run_context_.course != nullptr)
      json.object("fence", [&] {
        json.field("min_x_m", course.fence.min_x_m)
            .field("max_x_m", course.fence.max_x_m)
            .field("min_y_m", course.fence.min_y_m)
            .field("max_y_m", course.fence.max_y_m);
        write_corners(json, course::corners_of(course.fence));
      });
    json.objects("keep_out", course.fence.keep_out,
                 [&](const course::Polygon& area) { write_corners(json, area); });
    json.object("robot", [&] { write_robot(json, run_context_.robot); });
  });
}

std::string Messages::event(const Event& event) const {
  return text::json_object([&](text::JsonWriter& json) {
    json.field("t_s", clock_.t_s(event.at_ns))
        .field("kind", event.kind)
        .field("level", name_in(kLevelNames, event.level))
        .field("text", event.text)
        .field("cause", event.cause)
        .field("fix", event.fix);
  });
}

}  // namespace tp100::messages
