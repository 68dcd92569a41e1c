#pragma once
// The overhead camera as a measurement (expected marker pose, noise, gate), and odometry corrected
// by such a camera, whose samples arrive late.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>

#include "core/estimates.h"
#include "core/sample.h"
#include "core/step_record.h"
#include "estimation/kalman.h"
#include "estimation/motion.h"
#include "estimation/odometry.h"
#include "estimation/parameters.h"

namespace tp100::estimation {

/// A camera over the floor that looks straight down.
struct CameraPlace {
  double x_m = 0.0, y_m = 0.0;  ///< below the lens, world frame
};

/// Expected marker of a robot at (x, y, yaw) on this ground. The marker is raised, tilted with the
/// body, and displaced from the point below the lens in proportion to its height over the plane of
/// the homography. Its direction is that of its two ends as seen. Pure.
Eigen::Vector3d expected_marker(const Eigen::Vector3d& pose, const Ground& ground,
                                const CameraParameters& camera, const CameraPlace& place);

/// Outcome of a sample.
enum class CameraVerdict {
  kUsed,       ///< also the last of many rejected ones in a row, from which the estimate was reset
  kRejected,   ///< beyond the gate
  kRecovered,  ///< the second in a row that finds the robot moved: the estimate was reset
};

/// Accepts or rejects samples and applies them. Its only state is about rejections in a row. No
/// allocation.
class CameraUpdate {
 public:
  CameraUpdate(const CameraParameters& camera, const CameraPlace& place)
      : camera_(camera), place_(place) {}

  /// Applies `seen` to the state at its time of measurement. `twist` is the motion then.
  CameraVerdict apply(FilterState& state, const CameraSample& seen, const Ground& ground,
                      const Twist& twist, const MotionModel& motion);
  /// As after construction, with the NIS of the last sample.
  void resume(double nis) {
    *this = CameraUpdate(camera_, place_);
    nis_ = nis;
  }
  /// NIS of the last sample, before any recovery.
  double nis() const { return nis_; }

 private:
  bool contradicted(const Eigen::Vector3d& innovation);

  CameraParameters camera_;
  CameraPlace place_;
  double nis_ = 0.0;
  int contradictions_ = 0;
  int rejections_ = 0;
  Eigen::Vector3d contradiction_ = Eigen::Vector3d::Zero();
};

/// A motion and the state at its end.
struct RewindEntry {
  Motion motion{};
  FilterState after{};
};

/// The last motions with the state after each, so that a late measurement is applied at its own
/// time. Ring of fixed size, oldest first. When full, it drops the oldest. No allocation.
class RewindBuffer {
 public:
  /// 0.8 s of samples at 200 Hz.
  static constexpr std::size_t kCapacity = 160;

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  void clear() { size_ = 0; }
  RewindEntry& operator[](std::size_t index) { return steps_[(first_ + index) % kCapacity]; }
  const RewindEntry& operator[](std::size_t index) const {
    return steps_[(first_ + index) % kCapacity];
  }
  RewindEntry& back() { return (*this)[size_ - 1]; }
  const RewindEntry& back() const { return (*this)[size_ - 1]; }

  void push(const RewindEntry& step) {
    if (size_ == kCapacity) {
      first_ = (first_ + 1) % kCapacity;
      --size_;
    }
    ++size_;
    back() = step;
  }
  /// Puts `step` before the one at `index`, which must not be 0. Returns its index; that is one
  /// less if the buffer was full.
  std::size_t insert(std::size_t index, const RewindEntry& step) {
    if (size_ == kCapacity) --index;
    push(RewindEntry{});
    for (std::size_t i = size_ - 1; i > index; --i) (*this)[i] = (*this)[i - 1];
    (*this)[index] = step;
    return index;
  }
  /// Index of the first step that ends at or after `at_ns`; size() if there is none.
  std::size_t find(HostNs at_ns) const {
    std::size_t index = size_;
    while (index > 0 && (*this)[index - 1].motion.end_ns >= at_ns) --index;
    return index;
  }

 private:
  std::array<RewindEntry, kCapacity> steps_{};
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

/// Fuses odometry and camera; without a camera it equals odometry. No allocation; safe in the
/// real-time thread. A camera sample costs a prediction for each interval since it was taken (about
/// fifteen at 60 ms).
class PoseFilter {
 public:
  PoseFilter(const model::TrackParameters& tracks, const FilterParameters& noise,
             const CameraParameters& camera, const CameraPlace& place);

  /// A run begins at `start`. With a fresh camera the position is known better than that, and only
  /// the branch of yaw is taken from `start`. Bias and slip are kept.
  void begin(const Pose& start, HostNs now);
  /// The samples were interrupted (a new session, a new boot): the time between is unknown.
  void interrupt();

  CarriedFilter carried() const;
  /// What carried() returns after begin() with these arguments; the estimate itself stays.
  CarriedFilter carried_from(const Pose& start, HostNs now) const;
  /// As after construction, with this state. Camera samples from before it will be rejected.
  void resume(const CarriedFilter& state);

  /// One interval.
  void advance(const FilterInput& in);
  /// The robot stands still: its gyro shows its bias. Applied at the end of the last interval.
  void standstill(const RestRate& rest);
  /// A camera sample of any age. A sample newer than the newest interval waits for it.
  void camera(const CameraSample& seen);

  /// State at the end of the newest interval. z, roll and pitch are the ground's.
  Pose pose() const;
  const Twist& twist() const { return odometry_.twist(); }
  /// In the world frame, with the error common to all images.
  PlanarCovariance pose_covariance() const;
  /// A camera sample was used since the last interruption.
  bool camera_known() const { return camera_known_; }
  /// Age of the last camera sample used; infinite before the first. [s]
  double camera_age_s(HostNs now) const;
  const FilterState& state() const { return odometry_.state(); }
  /// How often the camera contradicted the estimate and was accepted since the run began.
  std::uint32_t recoveries() const { return recoveries_; }
  /// Everything else to publish at host time `now`.
  FilterFigures figures(HostNs now) const;

 private:
  static constexpr std::size_t kWaiting = 4;

  bool camera_sees(HostNs now) const;
  void apply_waiting();
  bool apply(const CameraSample& seen);

  Odometry odometry_;
  CameraUpdate camera_;
  double shared_sd_m_;
  double branch_rad_ = 0.0;  ///< full turns between the filter's yaw and the course's
  RewindBuffer past_{};
  std::array<CameraSample, kWaiting> waiting_{};
  std::size_t waiting_count_ = 0;
  HostNs camera_ns_ = 0;  ///< of the last sample used
  HostNs last_seen_ns_ = 0;
  bool camera_known_ = false;
  NisMean nis_{};
  double shift_scale_ = 1.0;  ///< see Motion
  std::uint32_t used_ = 0, rejected_ = 0, recoveries_ = 0;
};

}  // namespace tp100::estimation
