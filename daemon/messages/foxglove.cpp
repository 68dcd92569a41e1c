#include "messages/foxglove.h"

#include "text/base64.h"

namespace tp100::messages {
namespace {

void write_transform(text::JsonWriter& json, std::string_view child, const Pose& pose,
                     std::uint64_t unix_ns) {
  json.begin_object();
  write_time(json, "timestamp", unix_ns);
  json.field("parent_frame_id", "world").field("child_frame_id", child);
  write_xyz(json, "translation", {pose.x_m, pose.y_m, pose.z_m});
  write_rotation(json, "rotation", pose);
  json.end_object();
}

/// An array whose elements are already JSON.
void write_elements(text::JsonWriter& json, std::string_view name, const std::string& elements) {
  json.key(name).raw("[" + elements + "]");
}

}  // namespace

void write_rotation(text::JsonWriter& json, std::string_view name, const Pose& pose) {
  const Quaternion q = quaternion(pose);
  json.object(name, [&] { json.field("x", q.x).field("y", q.y).field("z", q.z).field("w", q.w); });
}

void write_foxglove_pose(text::JsonWriter& json, const Pose& pose) {
  json.object("pose", [&] {
    write_xyz(json, "position", {pose.x_m, pose.y_m, pose.z_m});
    write_rotation(json, "orientation", pose);
  });
}

void write_vertices(text::JsonWriter& json, std::span<const Point> points, const Colour& colour) {
  json.objects("points", points, [&](const Point& point) {
    json.field("x", point.x_m).field("y", point.y_m).field("z", point.z_m);
  });
  write_colour(json, colour);
  json.key("colors").begin_array().end_array().key("indices").begin_array().end_array();
}

std::string line_strip(std::span<const Point> points, double thickness_m, const Colour& colour) {
  return text::json_object([&](text::JsonWriter& json) {
    json.field("type", 0);
    write_foxglove_pose(json, Pose{});
    json.field("thickness", thickness_m).field("scale_invariant", false);
    write_vertices(json, points, colour);
  });
}

void write_entity(text::JsonWriter& json, const Entity& entity, std::uint64_t unix_ns) {
  json.begin_object();
  write_time(json, "timestamp", unix_ns);
  json.field("frame_id", entity.frame).field("id", entity.id);
  write_time(json, "lifetime", 0);
  json.field("frame_locked", true);
  for (const char* empty : {"metadata", "arrows", "spheres", "cylinders", "texts", "models"})
    json.key(empty).begin_array().end_array();
  write_elements(json, "cubes", entity.cubes);
  write_elements(json, "lines", entity.lines);
  write_elements(json, "triangles", entity.triangles);
  json.end_object();
}

std::string scene_update(std::uint64_t unix_ns, bool all,
                         const std::function<void(text::JsonWriter&)>& write) {
  return text::json_object([&](text::JsonWriter& json) {
    json.key("deletions").begin_array();
    if (all) {
      json.begin_object();
      write_time(json, "timestamp", unix_ns);
      json.field("type", 1).field("id", "").end_object();
    }
    json.end_array().key("entities").begin_array();
    write(json);
    json.end_array();
  });
}

std::string transforms_text(const Messages& messages, const StepRecord& record,
                            const std::optional<Truth>& truth) {
  const PublishClock& clock = messages.clock();
  const std::uint64_t at = clock.unix_ns(record.now_ns);
  return text::json_object([&](text::JsonWriter& json) {
    json.key("transforms").begin_array();
    write_transform(json, "robot", record.snapshot.world, at);
    for (const PoseSource estimate : kPoseSources)
      write_transform(json, to_string(estimate), record.snapshot.estimates[estimate].pose, at);
    if (truth) write_transform(json, "truth", truth->pose, clock.unix_ns(truth->at_ns));
    json.end_array();
  });
}

std::string pose_text(const Messages& messages, HostNs at, const Pose& pose) {
  return text::json_object([&](text::JsonWriter& json) {
    write_time(json, "timestamp", messages.clock().unix_ns(at));
    json.field("frame_id", "world");
    write_foxglove_pose(json, pose);
  });
}

std::string path_text(const Messages& messages, HostNs at) {
  const course::Path* path = messages.path();
  const auto points = path == nullptr ? std::vector<course::PathPoint>{} : path_points(*path);
  return text::json_object([&](text::JsonWriter& json) {
    write_time(json, "timestamp", messages.clock().unix_ns(at));
    json.field("frame_id", "world");
    json.objects("poses", points, [&](const course::PathPoint& point) {
      write_xyz(json, "position", {point.x_m, point.y_m, 0.0});
      write_rotation(json, "orientation", {.yaw_rad = point.yaw_rad});
    });
  });
}

std::string image_text(const Messages& messages, HostNs at, std::string_view jpeg) {
  return text::json_object([&](text::JsonWriter& json) {
    write_time(json, "timestamp", messages.clock().unix_ns(at));
    json.field("frame_id", "camera").field("format", "jpeg").field("data", text::base64(jpeg));
  });
}

std::string log_text(const Messages& messages, const Event& event) {
  std::string message = event.text;
  if (!event.cause.empty()) message += ": " + event.cause;
  if (!event.fix.empty()) message += "; " + event.fix;
  // 2 is info, 3 a warning, 4 an error.
  const int level = 2 + static_cast<int>(event.level);
  return text::json_object([&](text::JsonWriter& json) {
    write_time(json, "timestamp", messages.clock().unix_ns(event.at_ns));
    json.field("level", level)
        .field("message", message)
        .field("name", event.kind)
        .field("file", "")
        .field("line", 0);
  });
}

}  // namespace tp100::messages
