#include "identify/fitted_run.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "core/statistics.h"

namespace tp100::identify {
namespace {

// Images used if the camera saw nothing of the standstill.
constexpr std::size_t kFirstImages = 5;

}  // namespace

Pose median_of(std::span<const SeenPose> seen) {
  std::vector<double> x, y, sine, cosine;
  for (const SeenPose& pose : seen) {
    x.push_back(pose.x_m);
    y.push_back(pose.y_m);
    sine.push_back(std::sin(pose.yaw_rad));
    cosine.push_back(std::cos(pose.yaw_rad));
  }
  Pose pose;
  pose.x_m = median(x);
  pose.y_m = median(y);
  pose.yaw_rad = std::atan2(median(sine), median(cosine));
  return pose;
}

FittedRun::FittedRun(const RecordedDrive& drive, double counts_per_metre, double gyro_scale)
    : name(drive.name), motion(drive, counts_per_metre), measured(drive.measured) {
  const std::vector<SeenPose>& seen = drive.camera;
  std::size_t resting = 0;
  while (resting < seen.size() && seen[resting].t_s < motion.moves_s()) ++resting;
  const Pose start =
      median_of(std::span(seen).first(std::max(resting, std::min(seen.size(), kFirstImages))));
  const double yaw = start.yaw_rad;
  own = {start.x_m, start.y_m, yaw, yaw};
  for (SeenPose image : seen) {
    if (image.t_s < motion.begin_s() || image.t_s > motion.end_s()) continue;
    const double near = yaw + gyro_scale * motion.gyro_rad(image.t_s);
    image.yaw_rad = near + wrap_angle(image.yaw_rad - near);
    images.push_back(image);
  }
  images_per_s = static_cast<double>(images.size()) / (motion.end_s() - motion.begin_s());
}

Pose FittedRun::predicted(const Pose& driven) const {
  const double c = std::cos(own[2]), s = std::sin(own[2]);
  Pose pose;
  pose.x_m = own[0] + c * driven.x_m - s * driven.y_m;
  pose.y_m = own[1] + s * driven.x_m + c * driven.y_m;
  pose.yaw_rad = own[2] + driven.yaw_rad;
  return pose;
}

Residual FittedRun::residual(const std::vector<Pose>& poses, const SeenPose& seen,
                             double late_s) const {
  return residual(seen, predicted(motion.at(poses, motion.place(seen.t_s - late_s))));
}

}  // namespace tp100::identify
