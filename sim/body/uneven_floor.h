#pragma once
// What a seed draws of floor and robot where the floor is uneven (course::Floor).

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

/// Friction and slip as two independent random fields over the floor, without end and without
/// memory. Each has mean 0 and the stated standard deviation over seeds at every place, and no
/// value beyond 3.5 of them. The fields are normal numbers on a lattice of correlation_m that is
/// turned by a random angle, interpolated smoothly; with tiles, a number a tile is added.
class UnevenFloor {
 public:
  UnevenFloor() = default;  ///< an even one
  /// Even if `values.floor` is.
  UnevenFloor(const course::Emulated& values, std::uint64_t seed);

  FloorVariation at(double x_m, double y_m) const;

 private:
  std::optional<course::EmulatedVariation> variation_;  // nothing: even
  std::uint64_t seed_ = 0;
  double cos_ = 1.0, sin_ = 0.0, origin_x_m_ = 0.0, origin_y_m_ = 0.0;  // of the lattice
};

/// The robot as it is in the run with this seed: tension of the tracks, payload, battery and scale
/// of the gyro. As it is in its file if the floor is even.
course::Emulated sampled(const course::Emulated& values, std::uint64_t seed);

/// Where the robot stands that was to be placed at `start`; there exactly if the floor is even.
Pose placed(const Pose& start, const course::Emulated& values, std::uint64_t seed);

}  // namespace tp100::sim
