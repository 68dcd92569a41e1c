#pragma once
// The messages of Foxglove's own schemas, and the pieces of JSON that they share.

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/pose.h"
#include "core/step_record.h"
#include "messages/messages.h"
#include "text/json_writer.h"

namespace tp100::messages {

/// foxglove.FrameTransforms: robot and estimates in the world, and the truth if it is known.
std::string transforms_text(const Messages& messages, const StepRecord& record,
                            const std::optional<Truth>& truth);
/// foxglove.PoseInFrame.
std::string pose_text(const Messages& messages, HostNs at, const Pose& pose);
/// foxglove.PosesInFrame: the reference path; empty without a course.
std::string path_text(const Messages& messages, HostNs at);
/// foxglove.SceneUpdate: the course and the robot for 3-D viewers; it replaces the one before.
std::string scene_text(const Messages& messages, HostNs at);
/// foxglove.CompressedImage: an image of a camera, taken at `at`.
std::string image_text(const Messages& messages, HostNs at, std::string_view jpeg);
/// foxglove.Log.
std::string log_text(const Messages& messages, const Event& event);

// Shared pieces.

struct Point {
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;
};

/// Red, green, blue, opacity; 0..1.
using Colour = std::array<double, 4>;
inline constexpr Colour kPathColour{1.0, 1.0, 1.0, 1.0};

/// foxglove's time, from Unix nanoseconds.
inline void write_time(text::JsonWriter& json, std::string_view name, std::uint64_t unix_ns) {
  json.object(name, [&] {
    json.field("sec", unix_ns / 1'000'000'000U).field("nsec", unix_ns % 1'000'000'000U);
  });
}

inline void write_xyz(text::JsonWriter& json, std::string_view name, const Point& point) {
  json.object(name,
              [&] { json.field("x", point.x_m).field("y", point.y_m).field("z", point.z_m); });
}

inline void write_colour(text::JsonWriter& json, const Colour& colour) {
  json.object("color", [&] {
    json.field("r", colour[0]).field("g", colour[1]).field("b", colour[2]).field("a", colour[3]);
  });
}

/// {"x","y","z","w"} under `name`.
void write_rotation(text::JsonWriter& json, std::string_view name, const Pose& pose);
/// foxglove.Pose under "pose".
void write_foxglove_pose(text::JsonWriter& json, const Pose& pose);

/// The primitives of one scene entity; empty kinds are written too, because viewers need them.
struct Entity {
  std::string id{};
  std::string frame = "world";
  std::string lines{};      ///< JSON of the elements of the array
  std::string triangles{};  ///< same
  std::string cubes{};      ///< same
};
void write_entity(text::JsonWriter& json, const Entity& entity, std::uint64_t unix_ns);
/// foxglove.SceneUpdate with the entities that `write` writes; `all`: in place of every entity of
/// the topic.
std::string scene_update(std::uint64_t unix_ns, bool all,
                         const std::function<void(text::JsonWriter&)>& write);

/// The members "points", "color", "colors" and "indices" of a line or triangle primitive.
void write_vertices(text::JsonWriter& json, std::span<const Point> points, const Colour& colour);
/// JSON of one line strip, for Entity::lines.
std::string line_strip(std::span<const Point> points, double thickness_m, const Colour& colour);

}  // namespace tp100::messages
