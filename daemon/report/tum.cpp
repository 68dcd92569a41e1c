#include "report/tum.h"

#include <array>
#include <cstdio>

#include "core/quaternion.h"

namespace tp100::report {

std::string tum_line(double t_s, const Pose& pose) {
  const Quaternion q = quaternion(pose);
  std::array<char, 200> line{};
  const int length =
      std::snprintf(line.data(), line.size(), "%.6f %.6f %.6f %.6f %.9f %.9f %.9f %.9f\n", t_s,
                    pose.x_m, pose.y_m, pose.z_m, q.x, q.y, q.z, q.w);
  return {line.data(), static_cast<std::size_t>(length)};
}

}  // namespace tp100::report
