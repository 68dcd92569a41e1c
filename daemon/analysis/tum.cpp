#include "analysis/tum.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace tp100::analysis {

std::string tum_line(double t_s, const Pose& pose) {
  const double cr = std::cos(pose.roll_rad / 2.0), sr = std::sin(pose.roll_rad / 2.0);
  const double cp = std::cos(pose.pitch_rad / 2.0), sp = std::sin(pose.pitch_rad / 2.0);
  const double cy = std::cos(pose.yaw_rad / 2.0), sy = std::sin(pose.yaw_rad / 2.0);
  std::array<char, 200> line{};
  const int length = std::snprintf(
      line.data(), line.size(), "%.6f %.6f %.6f %.6f %.9f %.9f %.9f %.9f\n", t_s, pose.x_m,
      pose.y_m, pose.z_m, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
      cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy);
  return {line.data(), static_cast<std::size_t>(length)};
}

}  // namespace tp100::analysis
