#pragma once
// Measured motion of real robots: the files of tests/data/real.

#include <array>
#include <string>
#include <vector>

#include "course/bundled_files.h"

namespace tp100::sim {

/// Measurements of the robot's own sensors during one interval.
struct SensedSpeeds {
  double left_mps = 0.0, right_mps = 0.0;  ///< of the tracks, or of the wheels of a side
  double gyro_radps = 0.0;                 ///< 0 without a gyro
};

/// One measured motion. Its truth is forward, left and yaw: the twist of a stationary point
/// [m/s, m/s, rad/s], or the end of a window in the frame of its beginning [m, m, rad].
struct RealMotion {
  int row = 0, column = 0;  ///< place in the grid of left and right speeds; window and step
  double dt_s = 0.0;        ///< of each interval; 0 for a stationary point, which has one
  std::vector<SensedSpeeds> speeds;
  std::array<double, 3> truth{};
  double path_m = 0.0;  ///< length of a window's path
};

struct RealRobot {
  std::string name;
  double gauge_m = 0.0;
  std::vector<RealMotion> motions;

  /// The motions are stationary points, not windows.
  bool stationary() const { return motions.front().dt_s == 0.0; }
};

/// The tracked robot MAXXII: stationary points, nine right speeds for every left one. Throws
/// UserError "file:line: what". Pure.
RealRobot parse_maxxii(const course::TextFile& file);

/// Clearpath's Husky: windows of a drive. Yaw is made continuous; the speeds of an interval are the
/// mean of its two samples. Throws UserError "file:line: what". Pure.
RealRobot parse_husky(const course::TextFile& file);

/// Reads both from the bundled files. Throws UserError that names a missing or corrupted file.
std::vector<RealRobot> read_real_robots();

}  // namespace tp100::sim
