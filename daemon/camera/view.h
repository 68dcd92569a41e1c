#pragma once
// A view file as data: the marker that an overhead camera looks for, and the floor points that map
// its images to world positions. config/view.toml is the commented example.

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "camera/floor_plane.h"

namespace tp100::camera {

/// A marker on the floor with its centre at a known position.
struct FloorMarker {
  int id = 0;
  cv::Point2d world_m;
};

/// Images to be shown to people, beside the poses.
struct ImageStream {
  double rate_hz = 5.0;  ///< at most; 0: none are sent
  int width_px = 480;    ///< at most; larger ones are reduced
};

struct View {
  std::string lens;      ///< lens file, relative to the view file's folder
  double delay_s = 0.0;  ///< devices: from the middle of the exposure to the driver's time stamp
  std::string dictionary = "4x4_50";
  int marker_id = 0;
  double marker_size_m = 0.10;    ///< side of the black square
  double marker_height_m = 0.06;  ///< above the floor on the upright robot
  /// Its top edge points this far to the left of the robot's front.
  double marker_turned_rad = 0.0;
  ImageStream images{};
  std::vector<FloorMarker> floor_markers;
  std::vector<FloorPoint> floor_points;  ///< instead of markers: pixels measured in an image
};

/// Parses a view file. `file` is only used in messages; `lens` is returned as written. Throws
/// UserError (file:line:column), also for fewer than four floor points. Pure.
View parse_view(const std::string& text, const std::string& file);

/// A commented file that parse_view reads back.
std::string write_view(const View& view);

/// Reads a view file; its lens path is made relative to the working directory.
View read_view(const std::string& path);

}  // namespace tp100::camera
