#include "messages/messages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/faults.h"
#include "text/json_writer.h"

namespace tp100::messages {
namespace {

constexpr double kPathSpacingM = 0.02;

template <class Values>
void write_fields(text::JsonWriter& json, const Values& values) {
  visit_fields([&](auto name, double value) { json.field(name, value); }, values);
}

void write_motion(text::JsonWriter& json, const Estimate& estimate) {
  write_fields(json, estimate.pose);
  write_fields(json, estimate.twist);
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

void write_truth(text::JsonWriter& json, const std::optional<Truth>& truth, HostNs now) {
  if (!truth) return;
  json.key("truth").begin_object();
  write_fields(json, truth->pose);
  json.field("age_us", (now - truth->at_ns) / kNsPerUs).end_object();
}

void write_reference(text::JsonWriter& json, const course::Path* path, double progress_m) {
  if (path == nullptr) return;
  const course::PathPoint point = path->at(progress_m);
  json.key("reference")
      .begin_object()
      .field("x_m", point.x_m)
      .field("y_m", point.y_m)
      .field("yaw_rad", point.yaw_rad)
      .end_object();
}

void write_tracks(text::JsonWriter& json, const StepRecord& record) {
  const Snapshot& snapshot = record.snapshot;
  json.key("tracks")
      .begin_object()
      .field("left_mps", snapshot.left_mps)
      .field("right_mps", snapshot.right_mps);
  if (record.command_valid)
    json.field("left_commanded_mps", snapshot.commanded_left_mps)
        .field("right_commanded_mps", snapshot.commanded_right_mps);
  json.end_object();
}

const char* level_name(Event::Level level) {
  switch (level) {
    case Event::Level::kInfo:
      return "info";
    case Event::Level::kWarning:
      return "warning";
    case Event::Level::kError:
      break;
  }
  return "error";
}

void write_place(text::JsonWriter& json, const course::Place& place) {
  json.field("x_m", place.x_m).field("y_m", place.y_m).field("heading_rad", place.heading_rad);
}

void write_terrain(text::JsonWriter& json, const course::Terrain& terrain) {
  json.key("ramps").begin_array();
  for (const course::Ramp& ramp : terrain.ramps) {
    json.begin_object();
    write_place(json, ramp.place);
    json.field("height_m", ramp.height_m)
        .field("up_rad", ramp.up_rad)
        .field("top_m", ramp.top_m)
        .field("down_rad", ramp.down_rad)
        .field("width_m", ramp.width_m)
        .end_object();
  }
  json.end_array().key("blocks").begin_array();
  for (const course::Block& block : terrain.blocks) {
    json.begin_object();
    write_place(json, block.place);
    json.field("height_m", block.height_m)
        .field("depth_m", block.depth_m)
        .field("width_m", block.width_m)
        .end_object();
  }
  json.end_array().key("surfaces").begin_array();
  for (const course::Surface& surface : terrain.surfaces) {
    json.begin_object().field("name", surface.name);
    write_place(json, surface.place);
    json.field("length_m", surface.length_m)
        .field("width_m", surface.width_m)
        .field("friction_factor", surface.friction_factor)
        .field("slip_offset", surface.slip_offset)
        .end_object();
  }
  json.end_array();
}

const char* kind_name(course::PathSegment::Kind kind) {
  switch (kind) {
    case course::PathSegment::Kind::kLine:
      return "line";
    case course::PathSegment::Kind::kArc:
      return "arc";
    case course::PathSegment::Kind::kPivot:
      break;
  }
  return "pivot";
}

void write_path(text::JsonWriter& json, const course::Path* path) {
  json.key("path").begin_array();
  if (path != nullptr) {
    for (const course::PathPoint& point : path_points(*path)) {
      json.begin_object()
          .field("x_m", point.x_m)
          .field("y_m", point.y_m)
          .field("yaw_rad", point.yaw_rad)
          .field("s_m", point.s_m)
          .end_object();
    }
  }
  json.end_array().key("segments").begin_array();
  if (path != nullptr) {
    for (const course::PathSegment& segment : path->segments()) {
      const double k = segment.begin.curvature_1pm;
      json.begin_object()
          .field("kind", kind_name(segment.kind))
          .field("from_m", segment.begin.s_m)
          .field("to_m", segment.end.s_m)
          .field("angle_rad", segment.end.yaw_rad - segment.begin.yaw_rad)
          .field("radius_m", k == 0.0 ? 0.0 : 1.0 / std::abs(k))
          .end_object();
    }
  }
  json.end_array();
}

void write_robot(text::JsonWriter& json, const course::Robot& robot) {
  json.key("robot")
      .begin_object()
      .field("name", robot.name)
      .field("length_m", robot.shape.length_m)
      .field("width_m", robot.emulated.body.width_m)
      .field("height_m", robot.shape.height_m)
      .field("gauge_m", robot.shape.gauge_m)
      .field("axle_spacing_m", robot.shape.axle_spacing_m)
      .field("wheel_radius_m", robot.shape.wheel_radius_m)
      .field("shoe_width_m", robot.emulated.body.shoe_width_m)
      .end_object();
}

void write_polygon(text::JsonWriter& json, const course::Polygon& polygon) {
  json.begin_array();
  for (const course::Vertex& corner : polygon)
    json.begin_object().field("x_m", corner.x_m).field("y_m", corner.y_m).end_object();
  json.end_array();
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
  std::string text;
  text.reserve(2048);
  text::JsonWriter json(text);
  json.begin_object().field("t_s", clock_.t_s(record.now_ns)).field("step", record.step);
  if (snapshot.has_sample) json.field("age_us", snapshot.age_us);
  json.field("steering", to_string(snapshot.steering));
  for (const PoseSource source : kPoseSources) {
    json.key(to_string(source)).begin_object();
    write_motion(json, snapshot.estimates[source]);
    if (source == PoseSource::kFused) write_filter(json, snapshot.filter);
    json.end_object();
  }
  json.key("world").begin_object();
  write_fields(json, snapshot.world);
  json.end_object();
  write_truth(json, truth, record.now_ns);
  write_reference(json, path(), snapshot.progress_m);
  json.key("imu")
      .begin_object()
      .field("roll_rad", snapshot.imu_roll_rad)
      .field("pitch_rad", snapshot.imu_pitch_rad)
      .field("slope", to_string(snapshot.imu_slope))
      .field("obstacle_class", to_string(snapshot.imu_obstacle))
      .end_object()
      .field("pitch_source", to_string(snapshot.terrain_contact.pitch_source));
  json.key("terrain_contact")
      .begin_object()
      .field("obstacle", to_string(snapshot.terrain_contact.obstacle))
      .field("climbing", snapshot.terrain_contact.climbing)
      .field("slope_rad", snapshot.terrain_contact.slope_rad)
      .field("traction", to_string(snapshot.terrain_contact.traction))
      .end_object();
  write_tracks(json, record);
  json.field("cross_track_m", snapshot.cross_track_m)
      .field("heading_error_rad", snapshot.heading_error_rad)
      .field("desired_yaw_rad", snapshot.command.desired_yaw_rad)
      .field("desired_speed_mps", snapshot.command.speed_mps)
      .field("at_fence", snapshot.at_fence)
      .field("progress_m", snapshot.progress_m)
      .field("recovering", snapshot.recovering)
      .end_object();
  return text;
}

std::string Messages::sample(const Sample& sample, HostNs now) const {
  std::string text;
  text.reserve(640);
  text::JsonWriter json(text);
  json.begin_object()
      .field("t_s", clock_.t_s(sample.measured_ns))
      .field("sequence", sample.sequence)
      .field("lost_before", sample.lost_before)
      .field("device_us", sample.device_us)
      .field("age_us", (now - sample.measured_ns) / kNsPerUs)
      .field("left_counts", sample.left_counts)
      .field("right_counts", sample.right_counts);
  json.key("gyro_radps").begin_array();
  for (const double rate : sample.gyro_radps) json.value(rate);
  json.end_array().key("accel_mps2").begin_array();
  for (const double force : sample.accel_mps2) json.value(force);
  json.end_array()
      .field("temperature_degc", sample.temperature_degc)
      .field("battery_v", sample.battery_v)
      .field("left_duty", sample.left_duty)
      .field("right_duty", sample.right_duty)
      .field("state", to_string(sample.state));
  json.key("faults").begin_array();
  FaultMask faults = sample.faults;
  while (const auto fault = first_fault(faults)) {
    json.value(describe(*fault).name);
    faults &= ~fault_bit(*fault);
  }
  json.end_array().field("imu_age", sample.imu_age).end_object();
  return text;
}

std::string Messages::command(const StepRecord& record) const {
  const Command& command = record.snapshot.command;
  std::string text;
  text.reserve(256);
  text::JsonWriter json(text);
  json.begin_object()
      .field("t_s", clock_.t_s(record.now_ns))
      .field("answers", command.answers)
      .field("x_m", command.pose.x_m)
      .field("y_m", command.pose.y_m)
      .field("yaw_rad", command.pose.yaw_rad)
      .field("desired_yaw_rad", command.desired_yaw_rad)
      .field("yaw_rate_radps", command.yaw_rate_radps)
      .field("speed_mps", command.speed_mps)
      .field("gyro_bias_radps", command.gyro_bias_radps);
  if (record.inputs.clock.valid) {
    const HostNs left_ns = record.inputs.clock.to_host(command.expiry_us) - record.now_ns;
    json.field("expires_in_ms", to_s(left_ns) * 1e3);
  }
  json.end_object();
  return text;
}

std::string Messages::slip(const StepRecord& record) const {
  const Snapshot& snapshot = record.snapshot;
  std::string text;
  text::JsonWriter json(text);
  json.begin_object()
      .field("t_s", clock_.t_s(record.now_ns))
      .field("left", snapshot.slip_left)
      .field("right", snapshot.slip_right)
      .field("fused_left", snapshot.filter.slip_left)
      .field("fused_right", snapshot.filter.slip_right)
      .field("gyro_bias_radps", snapshot.gyro_bias_radps)
      .field("fused_gyro_bias_radps", snapshot.filter.gyro_bias_radps)
      .field("slope_rad", snapshot.terrain_contact.slope_rad)
      .end_object();
  return text;
}

std::string Messages::course() const {
  std::string text;
  text::JsonWriter json(text);
  static const course::Course kNone{};
  const course::Course& course = run_context_.course == nullptr ? kNone : *run_context_.course;
  json.begin_object()
      .field("name", course.name)
      .field("description", course.description)
      .field("speed_mps", course.speed_mps)
      .field("length_m", path() == nullptr ? 0.0 : path()->length_m());
  json.key("start")
      .begin_object()
      .field("x_m", course.start.x_m)
      .field("y_m", course.start.y_m)
      .field("yaw_rad", course.start.yaw_rad)
      .end_object();
  write_path(json, path());
  write_terrain(json, course.terrain);
  json.key("disturbances").begin_array();
  for (const course::Disturbance& disturbance : course.disturbances) {
    json.begin_object()
        .field("at_m", disturbance.at_m)
        .field("sideways_m", disturbance.sideways_m)
        .field("yaw_rad", disturbance.yaw_rad)
        .field("duration_s", disturbance.duration_s)
        .end_object();
  }
  json.end_array();
  if (run_context_.course != nullptr) {
    json.key("fence")
        .begin_object()
        .field("min_x_m", course.fence.min_x_m)
        .field("max_x_m", course.fence.max_x_m)
        .field("min_y_m", course.fence.min_y_m)
        .field("max_y_m", course.fence.max_y_m)
        .key("corners");
    write_polygon(json, course::corners_of(course.fence));
    json.end_object();
  }
  json.key("keep_out").begin_array();
  for (const course::Polygon& area : course.fence.keep_out) {
    json.begin_object().key("corners");
    write_polygon(json, area);
    json.end_object();
  }
  json.end_array();
  write_robot(json, run_context_.robot);
  json.end_object();
  return text;
}

std::string Messages::event(const Event& event) const {
  std::string text;
  text::JsonWriter(text)
      .begin_object()
      .field("t_s", clock_.t_s(event.at_ns))
      .field("kind", event.kind)
      .field("level", level_name(event.level))
      .field("text", event.text)
      .field("cause", event.cause)
      .field("fix", event.fix)
      .end_object();
  return text;
}

}  // namespace tp100::messages
