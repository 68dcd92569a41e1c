#include "report/baselines.h"

#include <cstdlib>

namespace tp100::report {
namespace {

double seconds(const Measured& from, const Measured& to) {
  return static_cast<double>(to.device_us - from.device_us) * 1e-6;
}

}  // namespace

void MeasuredMotion::take(const Sample& sample) {
  const Measured last = now_;
  now_.device_us = sample.device_us;
  now_.left_counts = sample.left_counts;
  now_.right_counts = sample.right_counts;
  const double rate_radps = sample.gyro_radps[2];
  const bool follows = started_ && sample.device_us > last.device_us;
  if (follows) now_.gyro_rad += (gyro_radps_ + rate_radps) / 2.0 * seconds(last, now_);
  started_ = true;
  gyro_radps_ = rate_radps;
  const bool still = follows &&
                     std::abs(now_.left_counts - standstill_.left_counts) <= kStandstillCounts &&
                     std::abs(now_.right_counts - standstill_.right_counts) <= kStandstillCounts;
  if (!still) standstill_ = now_;
  const double standstill_s = seconds(standstill_, now_);
  if (standstill_s >= kBiasStandstillS)
    bias_radps_ = (now_.gyro_rad - standstill_.gyro_rad) / standstill_s;
}

Baselines baselines_of(const course::Robot& robot, double turning_threshold_radps) {
  Baselines baselines{.forms = robot.baselines, .counts_per_metre = robot.drive.counts_per_metre};
  for (std::size_t i = 0; i < model::kBaselines.size(); ++i) {
    const model::ModelForm& form = model::kBaselines[i];
    if (form.fixed != nullptr) baselines.forms[i] = form.fixed(robot.shape.gauge_m);
    if (baselines.forms[i]) baselines.forms[i]->turning_threshold_radps = turning_threshold_radps;
  }
  return baselines;
}

}  // namespace tp100::report
