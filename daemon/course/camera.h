#pragma once
// A camera file (config/cameras) as data: one emulated overhead camera. The daemon never reads it;
// what it assumes of its camera is in the configuration's [camera].

#include <array>
#include <string>

#include "core/arithmetic.h"
#include "text/key.h"

namespace tp100::course {

/// One camera. Its lens looks straight down on the floor.
struct EmulatedCamera {
  double rate_hz = 33.0;
  double delay_s = 0.060;         ///< from the image to the sample's arrival
  double delay_jitter_s = 0.008;  ///< standard deviation of that
  double stamp_error_s = 0.001;   ///< standard deviation of the time stamp
  double stamp_lag_s = 0.0;       ///< the time stamp is later than the image by this, always
  double noise_m = 0.0015;        ///< standard deviation per axis
  double noise_rad = 0.4 * kRadPerDeg;
  double bias_m = 0.0015;     ///< constant error of the position, its direction by the seed
  double dropped = 0.03;      ///< share of the frames without a detection
  double blind_from_s = 0.0;  ///< no detections from here, counted from the first image ...
  double blind_s = 0.0;       ///< ... for this long
  double outliers = 0.0;      ///< share of the frames with a false one
  double outlier_m = 0.3;     ///< a false detection lies this far away at most, in each axis
  double height_m = 2.5;      ///< of the lens above the floor
  double offset_x_m = 0.0;    ///< of the lens from the middle of the course's fence
  double offset_y_m = 0.0;
  double marker_height_m = 0.06;  ///< above the reference point; it measures in this plane
  double marker_size_m = 0.10;
  double distortion = 0.0;  ///< radial error left after calibration, at a distance of height_m
  double view_m = 0.0;      ///< radius of the floor that it sees; 0: all of it
};

/// Keys of an overhead camera's place and of the marker's height, which a camera file and the
/// configuration's [camera] have in common.
template <class T>
std::array<text::Key<T>, 4> camera_mount_keys() {
  return {{
      {"height_m",
       &T::height_m,
       {0.5, 20},
       "Height of the lens above the floor; the camera looks straight down"},
      {"offset_x_m",
       &T::offset_x_m,
       {-10, 10},
       "Position of the lens along the world's x, from the middle of the course's fence"},
      {"offset_y_m", &T::offset_y_m, {-10, 10}, "Same along the world's y"},
      {"marker_height_m",
       &T::marker_height_m,
       {0, 0.4},
       "Height of the marker above the reference point; the camera measures in the plane at this "
       "height"},
  }};
}

/// Parses a camera file. `file` is only used in messages. Throws UserError (file:line:column).
/// Pure: reads no file itself.
EmulatedCamera parse_camera(const std::string& text, const std::string& file);

/// A commented file that parse_camera reads back. `note` becomes the comment at its head.
std::string write_camera(const EmulatedCamera& values, const std::string& note);

}  // namespace tp100::course
