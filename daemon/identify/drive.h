#pragma once
// One recorded drive of a robot, as plain data: the input of identify. Any recording can fill it.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tp100::identify {

/// What the robot measured, device time.
struct DriveSample {
  double t_s = 0.0;
  std::int64_t left_counts = 0;
  std::int64_t right_counts = 0;
  double gyro_z_radps = 0.0;  ///< nominal scale, bias included
};

/// Pose of the robot's marker by a camera, on the plane at the marker's height over a flat floor.
struct SeenPose {
  double t_s = 0.0;  ///< when the image was taken, same clock as the samples
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;  ///< any branch
};

/// Measurements of the whole drive by tape and protractor; only what was measured.
struct HandMeasured {
  std::optional<double> distance_m{};  ///< straight line from start to end
  std::optional<double> ahead_m{};     ///< end from start, along the heading at the start
  std::optional<double> left_m{};      ///< end from start, to the left of that heading
  std::optional<double> turned_rad{};  ///< end heading - start heading, whole turns counted
  /// Of an even board on which the whole drive was straight up, or down if negative; distance_m is
  /// along it, a camera's poses do not count. Nothing: level ground.
  std::optional<double> slope_rad{};
};

/// One drive on flat ground, level unless measured otherwise, from standstill to standstill,
/// without disturbances. Samples and images ascend in time.
struct RecordedDrive {
  std::string name;  ///< for messages and reports
  std::vector<DriveSample> samples;
  std::vector<SeenPose> camera;  ///< empty without a camera
  HandMeasured measured{};
};

}  // namespace tp100::identify
