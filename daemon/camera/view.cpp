#include "camera/view.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>

#include "camera/marker_detector.h"
#include "core/arithmetic.h"
#include "core/error.h"
#include "course/bundled_files.h"
#include "text/key.h"

namespace tp100::camera {
namespace {

using text::Choice;
using text::Key;

constexpr std::size_t kMaxPoints = 256;
constexpr text::Range kIds{0, 1023};
constexpr text::Range kPlaces{-100, 100};
constexpr text::Range kPixels{0, 16384};

std::span<const Key<View>> camera_keys() {
  using T = View;
  static const std::array<Key<T>, 2> kKeys = {{
      {"lens", &T::lens, {}, "Lens file (--calibrate-lens makes it), relative to this file"},
      {"delay_ms",
       &T::delay_s,
       {0, 500},
       "Of a device: from the middle of the exposure to its driver's time stamp",
       1e-3},
  }};
  return kKeys;
}

std::span<const Key<View>> marker_keys() {
  using T = View;
  static const std::array<Key<T>, 5> kKeys = {{
      {"dictionary",
       Choice<T>{dictionary_names(),
                 [](const T& v) {
                   const auto& names = dictionary_names();
                   return static_cast<std::size_t>(
                       std::find(names.begin(), names.end(), v.dictionary) - names.begin());
                 },
                 [](T& v, std::size_t i) { v.dictionary = dictionary_names()[i]; }},
       {},
       "ArUco dictionary of all markers, on the robot and on the floor"},
      {"id", &T::marker_id, {0, 1023}, "Marker on the robot's back"},
      {"size_m", &T::marker_size_m, {0.01, 1.0}, "Side of its black square"},
      {"height_m", &T::marker_height_m, {0, 1.0}, "Marker above the floor on the upright robot"},
      {"turned_deg",
       &T::marker_turned_rad,
       {-180, 180},
       "The marker's top edge points this far to the left of the robot's front",
       kRadPerDeg},
  }};
  return kKeys;
}

std::span<const Key<ImageStream>> image_keys() {
  using T = ImageStream;
  static const std::array<Key<T>, 2> kKeys = {{
      {"rate_hz",
       &T::rate_hz,
       {0, 30},
       "Images for the page and the recording a second, sent to where the poses are sent; 0: none. "
       "The daemon takes at most camera.image_hz of them"},
      {"width_px", &T::width_px, {64, 1920}, "Wider images are reduced to this width"},
  }};
  return kKeys;
}

cv::Point2d to_point(const std::array<double, 2>& values) { return {values[0], values[1]}; }

std::vector<FloorMarker> read_markers(text::TomlTable& root, const View& view) {
  std::vector<FloorMarker> markers;
  for (text::TomlTable& table : root.tables("floor_marker")) {
    FloorMarker marker;
    marker.id = static_cast<int>(table.required_number("id", kIds));
    if (table.integer("id", 0, kIds) == view.marker_id)
      table.fail("id", "floor marker " + std::to_string(marker.id) + " is the robot's own");
    for (const FloorMarker& other : markers)
      if (other.id == marker.id)
        table.fail("id", "floor marker " + std::to_string(marker.id) + " is listed twice");
    marker.world_m = to_point(table.required_numbers({"x_m", "y_m"}, kPlaces));
    markers.push_back(marker);
  }
  return markers;
}

std::vector<FloorPoint> read_points(text::TomlTable& root) {
  std::vector<FloorPoint> points;
  for (text::TomlTable& table : root.tables("floor_point")) {
    FloorPoint point;
    point.pixel = to_point(table.required_numbers({"u_px", "v_px"}, kPixels));
    point.world_m = to_point(table.required_numbers({"x_m", "y_m"}, kPlaces));
    points.push_back(point);
  }
  return points;
}

}  // namespace

View parse_view(const std::string& text, const std::string& file) {
  const text::TomlDocument document(text, file);
  text::TomlTable root = document.root();
  View view;
  text::read_keys(root, camera_keys(), view);
  text::TomlTable marker = root.table("marker");
  text::read_keys(marker, marker_keys(), view);
  text::TomlTable images = root.table("image");
  text::read_keys(images, image_keys(), view.images);
  view.floor_markers = read_markers(root, view);
  view.floor_points = read_points(root);
  root.finish();
  if (view.lens.empty()) root.fail("lens", "no lens file; make one with --calibrate-lens");
  if (view.floor_markers.size() > kMaxPoints || view.floor_points.size() > kMaxPoints)
    root.fail("floor_point", "more than " + std::to_string(kMaxPoints) + " points on the floor");
  if (!view.floor_markers.empty() && !view.floor_points.empty())
    root.fail("floor_point", "give floor_marker or floor_point, not both");
  if (view.floor_markers.size() < 4 && view.floor_points.size() < 4)
    root.fail("floor_marker", "fewer than four points on the floor; four corners make a plane");
  return view;
}

std::string write_view(const View& view) {
  std::string text = text::toml_comment(
      "What an overhead camera looks at: tp100-camera SOURCE --view THIS FILE. Places are in the "
      "course's frame: x forward, y to the left, both on the floor. The end of a key's name gives "
      "its unit.");
  text += "\n" + text::write_keys(camera_keys(), view);
  text += "\n[marker]\n" + text::write_keys(marker_keys(), view);
  text += "\n[image]\n" + text::write_keys(image_keys(), view.images);
  text +=
      "\n" + text::toml_comment(
                 "Four or more markers that lie on the floor, with the positions of their centres. "
                 "Or [[floor_point]] with u_px, v_px (a pixel of the image, 0 is the middle "
                 "of the first) and x_m, y_m.");
  const auto place = [](const cv::Point2d& world_m) {
    return "x_m = " + text::toml_number(world_m.x) + "\ny_m = " + text::toml_number(world_m.y) +
           "\n";
  };
  for (const FloorMarker& marker : view.floor_markers)
    text += "[[floor_marker]]\nid = " + std::to_string(marker.id) + "\n" + place(marker.world_m);
  for (const FloorPoint& point : view.floor_points)
    text += "[[floor_point]]\nu_px = " + text::toml_number(point.pixel.x) +
            "\nv_px = " + text::toml_number(point.pixel.y) + "\n" + place(point.world_m);
  return text;
}

View read_view(const std::string& path) {
  const course::TextFile file = course::read_text_file(path);
  View view = parse_view(file.text, file.path);
  view.lens = (std::filesystem::path(path).parent_path() / view.lens).string();
  return view;
}

}  // namespace tp100::camera
