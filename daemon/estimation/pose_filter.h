#pragma once
// Pose, gyro bias and slip from encoders, gyro and, where there is one, an overhead camera that
// answers late: an extended Kalman filter over filter_state.h.

#include <array>

#include "core/fused.h"
#include "estimation/camera_update.h"
#include "estimation/motion.h"
#include "estimation/nis.h"
#include "estimation/rewind_buffer.h"

namespace tp100::estimation {

/// One sample interval, as bridge::Tracks finds it.
struct FilterInput {
  HostNs end_ns = 0;  ///< when its last sample was measured, host's clock
  double dt_s = 0.0;  ///< device time
  BeltSpeeds belts{};
  double gyro_z_radps = 0.0;  ///< mean, calibrated scale, bias included
  bool gyro = false;          ///< may be used: fresh, and not on a bench
  Ground ground{};
};

/// No allocation; safe in the real-time thread. A camera sample costs a prediction for each
/// interval since it was taken (about fifteen at 60 ms).
class PoseFilter {
 public:
  PoseFilter(const model::TrackParameters& tracks, const FilterParameters& noise,
             const CameraParameters& camera, const CameraPlace& place);

  /// A run begins at `start`. With a fresh camera the place is known better than that: then only
  /// the branch of yaw is taken from it. Bias and slip are kept.
  void begin(const Pose& start, HostNs now);
  /// The samples broke off (a new session, a new boot): nothing is known of the time between.
  void interrupt();

  /// One interval.
  void advance(const FilterInput& in);
  /// The robot stands still: its gyro shows its bias. Applied at the end of the last interval.
  void rest(double gyro_z_radps, double sd_radps);
  /// A camera sample of any age. One that is newer than the newest interval waits for it.
  void camera(const CameraSample& seen);

  /// State at the end of the newest interval. z, roll and pitch are the ground's.
  Pose pose() const;
  const Twist& twist() const { return twist_; }
  /// Since the last camera sample that was used was taken; infinite before the first. [s]
  double camera_age_s(HostNs now) const;
  const FilterState& state() const { return state_; }
  /// How often since the run began the camera contradicted the estimate and was believed.
  std::uint32_t recoveries() const { return recoveries_; }
  /// Everything to publish at host time `now`.
  Fused fused(HostNs now) const;

 private:
  static constexpr std::size_t kWaiting = 4;

  void restart_from(const FilterState& state);
  void add_to_window(Motion& motion);
  void apply_waiting();
  bool apply(const CameraSample& seen);

  MotionModel motion_;
  CameraUpdate camera_;
  FilterParameters noise_;
  model::Slip prior_;
  FilterState state_{};
  Twist twist_{};
  Ground ground_{};
  double branch_rad_ = 0.0;  ///< full turns between the filter's yaw and the course's
  RewindBuffer past_{};
  model::TurnWatch turn_watch_{};
  Residual window_{};
  double window_s_ = 0.0;
  std::array<CameraSample, kWaiting> waiting_{};
  std::size_t waiting_count_ = 0;
  HostNs camera_ns_ = 0;  ///< of the last sample used
  HostNs last_seen_ns_ = 0;
  bool camera_known_ = false;
  NisMean nis_{};
  std::uint32_t used_ = 0, rejected_ = 0, recoveries_ = 0;
};

}  // namespace tp100::estimation
