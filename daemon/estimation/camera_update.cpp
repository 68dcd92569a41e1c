#include "estimation/camera_update.h"

#include <cmath>

#include "core/arithmetic.h"

namespace tp100::estimation {
namespace {

// Two outliers in a row hardly agree; two images of a robot that was moved do.
constexpr double kSameStoryM = 0.03;
constexpr double kSameStoryRad = 10.0 * kRadPerDeg;
// So many in a row between gate and trigger are no coincidence.
constexpr int kRejectionsInARow = 10;
// Of the pitch while climbing a block and falling off it; the raised marker moves with it.
constexpr double kClimbingSdRad = 3.0 * kRadPerDeg;
// A ground's attitude is that at one end of its interval.
constexpr double kAttitudeLateS = 0.005;

}  // namespace

Eigen::Vector3d expected_marker(const Eigen::Vector3d& pose, const Ground& ground,
                                const CameraParameters& camera, const CameraPlace& place) {
  const double c = std::cos(pose[2]), s = std::sin(pose[2]);
  const double forward =
      camera.marker_height_m * std::cos(ground.roll_rad) * std::sin(ground.pitch_rad);
  const double left = -camera.marker_height_m * std::sin(ground.roll_rad);
  const double z =
      ground.z_m + camera.marker_height_m * std::cos(ground.roll_rad) * std::cos(ground.pitch_rad);
  const double from_x = pose[0] + c * forward - s * left - place.x_m;
  const double from_y = pose[1] + s * forward + c * left - place.y_m;
  const double plane = camera.height_m - camera.marker_height_m;
  const double depth = camera.height_m - z;
  const double scale = plane / depth;
  // A step along the marker's own axis, as it moves in the image: its far end is at another
  // height.
  const double level = std::cos(ground.pitch_rad) * scale;
  const double rise = -std::sin(ground.pitch_rad) * scale / depth;
  const double along_x = c * level + from_x * rise;
  const double along_y = s * level + from_y * rise;
  const double turned = std::atan2(along_y * c - along_x * s, along_x * c + along_y * s);
  return {place.x_m + from_x * scale, place.y_m + from_y * scale, pose[2] + turned};
}

bool CameraUpdate::contradicted(const Eigen::Vector3d& innovation) {
  const Eigen::Vector3d change = innovation - contradiction_;
  const bool same_story = magnitude(change[0], change[1]) < kSameStoryM &&
                          std::abs(wrap_angle(change[2])) < kSameStoryRad;
  contradictions_ = contradictions_ > 0 && same_story ? contradictions_ + 1 : 1;
  contradiction_ = innovation;
  return contradictions_ >= 2;
}

CameraVerdict CameraUpdate::apply(FilterState& state, const CameraSample& seen,
                                  const Ground& ground, const Twist& twist,
                                  const MotionModel& motion) {
  const Eigen::Vector3d expected = expected_marker(state.mean.head<3>(), ground, camera_, place_);
  Measurement<3> measured;
  measured.innovation << seen.x_m - expected[0], seen.y_m - expected[1],
      wrap_angle(seen.yaw_rad - expected[2]);
  measured.jacobian.setZero();
  measured.jacobian.leftCols<3>().setIdentity();
  const double attitude_sd_rad =
      magnitude(ground.hold_slip ? kClimbingSdRad : 0.0, ground.tilt_radps * kAttitudeLateS);
  const double leaning_sd_m = camera_.marker_height_m * attitude_sd_rad;
  const double place_variance = square(camera_.position_sd_m) + square(leaning_sd_m) +
                                square(twist.vx_mps * camera_.time_sd_s);
  const double yaw_variance =
      square(camera_.yaw_sd_rad) + square(twist.yaw_rate_radps * camera_.time_sd_s);
  measured.noise = Eigen::Vector3d(place_variance, place_variance, yaw_variance).asDiagonal();

  nis_ = normalized_innovation(state, measured);
  if (nis_ <= kNisGate) {
    contradictions_ = 0;
    rejections_ = 0;
    update(state, measured);
    return CameraVerdict::kUsed;
  }
  ++rejections_;
  if (nis_ > kNisTrigger ? contradicted(measured.innovation) : rejections_ >= kRejectionsInARow) {
    contradictions_ = 0;
    rejections_ = 0;
    motion.disturb(state);
    update(state, measured);
    return CameraVerdict::kRecovered;
  }
  return CameraVerdict::kRejected;
}

}  // namespace tp100::estimation
