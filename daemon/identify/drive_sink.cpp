#include "identify/drive_sink.h"

#include <string>

#include "core/error.h"

namespace tp100::identify {
namespace {

constexpr double kSecondsPerUs = 1e-6;
// Eleven hours at 200 Hz.
constexpr std::size_t kMostSamples = 8'000'000;

}  // namespace

Drive recorded_drive(const record::Recording& recording) {
  DriveSink sink;
  recording.visit({.step = [&](const StepRecord& record) {
    sink.take(record);
    if (sink.drive().samples.size() + sink.drive().camera.size() > kMostSamples)
      throw SetupError(recording.path() + ": more than " + std::to_string(kMostSamples) +
                       " samples are too many for one drive; record shorter ones");
  }});
  return sink.drive();
}

void DriveSink::take(const StepRecord& record) {
  if (record.robot_rebooted) {
    drive_ = {};
    measured_ns_.clear();
    truth_.clear();
  }
  for (std::size_t i = 0; i < record.sample_count; ++i) {
    const Sample& sample = record.samples[i];
    const double t_s = static_cast<double>(sample.device_us) * kSecondsPerUs;
    if (!drive_.samples.empty() && t_s <= drive_.samples.back().t_s) continue;
    drive_.samples.push_back({t_s, sample.left_counts, sample.right_counts, sample.gyro_radps[2]});
    measured_ns_.push_back(sample.measured_ns);
    truth_.emplace_back();
  }
  if (!record.clock.valid) return;
  for (std::size_t i = 0; i < record.camera_count; ++i) {
    const CameraSample& seen = record.camera[i];
    const double t_s =
        static_cast<double>(record.clock.to_device(seen.measured_ns)) * kSecondsPerUs;
    if (!drive_.camera.empty() && t_s <= drive_.camera.back().t_s) continue;
    drive_.camera.push_back({t_s, seen.x_m, seen.y_m, seen.yaw_rad});
  }
}

void DriveSink::take_truth(HostNs at, const Pose& truth) {
  for (std::size_t i = measured_ns_.size(); i-- > 0 && measured_ns_[i] >= at;)
    if (measured_ns_[i] == at) truth_[i] = truth;
}

}  // namespace tp100::identify
