#include "sim/sensors/overhead_camera.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "core/time.h"

namespace tp100::sim {
namespace {

constexpr double kShortestDelayS = 0.005;

}  // namespace

OverheadCamera::OverheadCamera(const course::EmulatedCamera& values, double middle_x_m,
                               double middle_y_m, std::uint64_t seed)
    : values_(values), x_m_(middle_x_m + values.offset_x_m), y_m_(middle_y_m + values.offset_y_m) {
  // A stream of its own, different from those of other sensors with this seed.
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                         0x0CA3E7A5u};
  random_.seed(sequence);
  const double direction = 2.0 * kPi * uniform();
  bias_x_m_ = values_.bias_m * std::cos(direction);
  bias_y_m_ = values_.bias_m * std::sin(direction);
  first_frame_s_ = uniform() / values_.rate_hz;
}

OverheadCamera::Image OverheadCamera::image(const Pose& body, double forward_m, double up_m) const {
  const double cr = std::cos(body.roll_rad), sr = std::sin(body.roll_rad);
  const double cp = std::cos(body.pitch_rad), sp = std::sin(body.pitch_rad);
  const double cy = std::cos(body.yaw_rad), sy = std::sin(body.yaw_rad);
  // Roll, then pitch, then yaw.
  const double left = -sr * up_m, raised = cr * up_m;
  const double ahead = cp * forward_m + sp * raised;
  const double z = body.z_m - sp * forward_m + cp * raised;
  const double x = body.x_m + cy * ahead - sy * left;
  const double y = body.y_m + sy * ahead + cy * left;
  const double stretch = (values_.height_m - values_.marker_height_m) / (values_.height_m - z);
  const double image_x = (x - x_m_) * stretch, image_y = (y - y_m_) * stretch;
  const double tangent2 =
      (image_x * image_x + image_y * image_y) / (values_.height_m * values_.height_m);
  const double distorted = 1.0 + values_.distortion * tangent2;
  return {x_m_ + image_x * distorted, y_m_ + image_y * distorted};
}

void OverheadCamera::look(const Pose& truth, HostNs now_ns) {
  const double due_s = first_frame_s_ + static_cast<double>(frames_) / values_.rate_hz;
  if (to_s(now_ns) < due_s) return;
  ++frames_;
  const bool dropped = uniform() < values_.dropped;
  const bool outlier = uniform() < values_.outliers;
  const double half = values_.marker_size_m / 2.0;
  const Image middle = image(truth, 0.0, values_.marker_height_m);
  const Image front = image(truth, half, values_.marker_height_m);
  const Image back = image(truth, -half, values_.marker_height_m);
  CameraSample sample;
  sample.x_m = middle.x_m + bias_x_m_ + values_.noise_m * normal();
  sample.y_m = middle.y_m + bias_y_m_ + values_.noise_m * normal();
  sample.yaw_rad = wrap_angle(std::atan2(front.y_m - back.y_m, front.x_m - back.x_m) +
                              values_.noise_rad * normal());
  sample.measured_ns = now_ns + from_s(values_.stamp_lag_s + values_.stamp_error_s * normal());
  sample.sequence = frames_;
  const double delay_s =
      std::max(kShortestDelayS, values_.delay_s + values_.delay_jitter_s * normal());
  if (outlier) {
    sample.x_m += values_.outlier_m * (2.0 * uniform() - 1.0);
    sample.y_m += values_.outlier_m * (2.0 * uniform() - 1.0);
    sample.yaw_rad = kPi * (2.0 * uniform() - 1.0);
  }
  const double seen_s = due_s - first_frame_s_ - values_.blind_from_s;
  const bool outside =
      values_.view_m > 0.0 && magnitude(truth.x_m - x_m_, truth.y_m - y_m_) > values_.view_m;
  if (dropped || outside || (seen_s >= 0.0 && seen_s < values_.blind_s)) return;
  HostNs at_ns = now_ns + from_s(delay_s);
  if (!under_way_.empty()) at_ns = std::max(at_ns, under_way_.back().at_ns);
  under_way_.push_back({at_ns, sample});
}

std::optional<CameraSample> OverheadCamera::take(HostNs now_ns) {
  if (under_way_.empty() || under_way_.front().at_ns > now_ns) return std::nullopt;
  const CameraSample sample = under_way_.front().sample;
  under_way_.pop_front();
  return sample;
}

}  // namespace tp100::sim
