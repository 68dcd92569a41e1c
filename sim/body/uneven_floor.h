#pragma once
// Variation of floor and robot by seed, if the floor is uneven (course::Floor).

#include <cstdint>
#include <optional>

#include "core/pose.h"
#include "course/robot_file.h"

namespace tp100::sim {

/// How the floor at one place differs from its mean.
struct FloorVariation {
  double friction_factor = 1.0;
  double slip_offset = 0.0;  ///< added to the track deficit
};

/// Friction and slip as two independent random fields over the floor: unbounded, and functions of
/// the place alone. Over seeds, each has mean 0 and the stated standard deviation at every place,
/// and no value beyond 3.5 of them. The fields are normal numbers on a lattice of correlation_m
/// that is turned by a random angle, interpolated smoothly; with tiles, one number per tile is
/// added.
class UnevenFloor {
 public:
  UnevenFloor() = default;  ///< an even floor
  /// Even if `values.floor` says so.
  UnevenFloor(const course::Emulated& values, std::uint64_t seed);

  FloorVariation at(double x_m, double y_m) const;

 private:
  std::optional<course::EmulatedVariation> variation_;  // none: even
  std::uint64_t seed_ = 0;
  double cos_ = 1.0, sin_ = 0.0, origin_x_m_ = 0.0, origin_y_m_ = 0.0;  // of the lattice
};

/// The robot of the run with this seed: tension of the tracks, payload, battery and scale of the
/// gyro vary. Unchanged if the floor is even.
course::Emulated sampled(const course::Emulated& values, std::uint64_t seed);

/// True pose of a robot placed by hand at `start`; exactly `start` if the floor is even.
Pose placed(const Pose& start, const course::Emulated& values, std::uint64_t seed);

}  // namespace tp100::sim
