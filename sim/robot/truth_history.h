#pragma once
// The emulated robot's most recent true poses.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/pose.h"
#include "core/time.h"
#include "sim/robot/emulated_robot.h"

namespace tp100::sim {

/// Truth of the last steps, to compare an estimate with the truth at the same instant.
class TruthHistory {
 public:
  void add(HostNs at_ns, const Pose& pose) { at(at_ns) = pose; }
  /// Pose at `at_ns`, at most a quarter second old; interpolated between physics steps.
  Pose find(HostNs at_ns) const {
    const HostNs before = at_ns / kPhysicsStepNs * kPhysicsStepNs;
    const double share = static_cast<double>(at_ns - before) / static_cast<double>(kPhysicsStepNs);
    const Pose& a = history_[index(before)];
    const Pose& b = history_[index(before + kPhysicsStepNs)];
    return {.x_m = std::lerp(a.x_m, b.x_m, share),
            .y_m = std::lerp(a.y_m, b.y_m, share),
            .z_m = std::lerp(a.z_m, b.z_m, share),
            .roll_rad = std::lerp(a.roll_rad, b.roll_rad, share),
            .pitch_rad = std::lerp(a.pitch_rad, b.pitch_rad, share),
            .yaw_rad = std::lerp(a.yaw_rad, b.yaw_rad, share)};
  }

 private:
  static std::size_t index(HostNs at_ns) {
    return static_cast<std::size_t>(at_ns / kPhysicsStepNs) % kSize;
  }
  Pose& at(HostNs at_ns) { return history_[index(at_ns)]; }

  static constexpr std::size_t kSize = 256;
  std::array<Pose, kSize> history_{};
};

}  // namespace tp100::sim
