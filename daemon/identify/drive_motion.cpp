#include "identify/drive_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/sample.h"

namespace tp100::identify {
namespace {

// The robot turns a little before the first edge shows it.
constexpr double kBeforeEdgeS = 0.15;
// On soft ground the yaw oscillates about a turn two or three times a second, and the track speeds
// pass through nearly all turn ratios: a wheelbase belongs to the mean of them.
constexpr double kTurnShapeLagS = 0.18;

}  // namespace

DriveMotion::DriveMotion(const RecordedDrive& drive, double counts_per_metre) {
  const std::vector<DriveSample>& samples = drive.samples;
  const DriveSample& first = samples.front();
  std::size_t resting = 0;
  while (resting < samples.size() &&
         std::abs(samples[resting].left_counts - first.left_counts) <= kStandstillCounts &&
         std::abs(samples[resting].right_counts - first.right_counts) <= kStandstillCounts) {
    ++resting;
  }
  moves_s_ = samples[std::min(resting, samples.size() - 1)].t_s;
  std::size_t last = samples.size() - 1;
  while (
      last > 0 &&
      std::abs(samples[last - 1].left_counts - samples.back().left_counts) <= kStandstillCounts &&
      std::abs(samples[last - 1].right_counts - samples.back().right_counts) <= kStandstillCounts) {
    --last;
  }
  stops_s_ = samples[last].t_s;
  double sum = 0.0;
  std::size_t quiet = 0;
  while (quiet < resting && samples[quiet].t_s < moves_s_ - kBeforeEdgeS)
    sum += samples[quiet++].gyro_z_radps;
  has_bias_ = moves_s_ - kBeforeEdgeS - first.t_s >= kBiasStandstillS;
  const double bias = has_bias_ ? sum / static_cast<double>(quiet) : 0.0;

  times_s_.push_back(first.t_s);
  gyro_rad_.push_back(0.0);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const DriveSample& a = samples[i - 1];
    const DriveSample& b = samples[i];
    const double dt_s = b.t_s - a.t_s;
    const double left_m = static_cast<double>(b.left_counts - a.left_counts) / counts_per_metre;
    const double right_m = static_cast<double>(b.right_counts - a.right_counts) / counts_per_metre;
    intervals_.push_back({dt_s, left_m / dt_s, right_m / dt_s});
    times_s_.push_back(b.t_s);
    gyro_rad_.push_back(gyro_rad_.back() + ((a.gyro_z_radps + b.gyro_z_radps) / 2.0 - bias) * dt_s);
    left_m_ += left_m;
    right_m_ += right_m;
  }
}

void DriveMotion::replace_poses(const model::ModelForm& form,
                                const model::TrackParameters& parameters,
                                std::vector<Pose>& all) const {
  model::DeadReckoning reckoning(form, parameters, {}, kTurnShapeLagS);
  all.clear();
  all.reserve(times_s_.size());
  all.push_back(reckoning.pose());
  for (std::size_t i = 0; i < intervals_.size(); ++i) {
    const Interval& interval = intervals_[i];
    const double gyro_radps = (gyro_rad_[i + 1] - gyro_rad_[i]) / interval.dt_s;
    reckoning.advance(interval.left_mps, interval.right_mps, gyro_radps, interval.dt_s);
    all.push_back(reckoning.pose());
  }
}

DriveMotion::Place DriveMotion::place(double t_s) const {
  if (t_s <= times_s_.front()) return {0, 0.0};
  if (t_s >= times_s_.back()) return {times_s_.size() - 2, 1.0};
  const auto after = std::upper_bound(times_s_.begin(), times_s_.end(), t_s);
  const auto index = static_cast<std::size_t>(after - times_s_.begin()) - 1;
  return {index, (t_s - times_s_[index]) / intervals_[index].dt_s};
}

Pose DriveMotion::at(const std::vector<Pose>& poses, const Place& place) {
  const auto [index, share] = place;
  const Pose& a = poses[index];
  const Pose& b = poses[index + 1];
  Pose pose;
  pose.x_m = std::lerp(a.x_m, b.x_m, share);
  pose.y_m = std::lerp(a.y_m, b.y_m, share);
  pose.yaw_rad = std::lerp(a.yaw_rad, b.yaw_rad, share);
  return pose;
}

double DriveMotion::gyro_rad(double t_s) const {
  const auto [index, share] = place(t_s);
  return std::lerp(gyro_rad_[index], gyro_rad_[index + 1], share);
}

}  // namespace tp100::identify
