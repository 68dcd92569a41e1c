#pragma once
// The external world as the step sees it: whether it keeps up, what the robot stands on there, and
// where it says that the robot is.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "bridge/parameters.h"
#include "core/pose.h"
#include "core/world_sample.h"
#include "terrain/ride.h"

namespace tp100::bridge {

/// From the robot's own floor into the course's world: turned about the origin, then moved.
struct Shift {
  double x_m = 0.0;
  double y_m = 0.0;
  double turn_rad = 0.0;
  /// `pose` after the shift; height, pitch and roll stay.
  Pose of(const Pose& pose) const;
  /// The shift that takes `from` to `to`.
  static Shift between(const Pose& from, const Pose& to);
};

/// Without an external world everything here says that all is well. No allocation; safe in the
/// real-time thread.
class OuterWorld {
 public:
  OuterWorld(const WorldParameters& parameters, Setup setup);

  /// A run begins.
  void restart(HostNs now);
  /// What the world said.
  void take(const WorldSample& said);
  /// The step at `now` is over and published this steering pose, which the world will answer.
  void remember(HostNs now, const Pose& steering);
  /// The robot was blocked, or not, for `dt_s` more.
  void wait(double dt_s);

  /// It answered a step not older than the time-out, with the pose if it owns it.
  bool fresh(HostNs now) const;
  /// Not fresh, or another one than at the run's begin.
  bool lost(HostNs now) const;
  /// True once after each change to stop, and as long as it says stop if `moving`.
  bool take_stop(bool moving);
  /// The robot has not been able to go on for half a second.
  bool blocked() const { return blocked_s_ > kBlockedS; }

  /// The ground that it told; nothing if the bridge makes its own.
  const std::optional<terrain::RideState>& ground() const { return ground_; }
  /// Where it has the robot; nothing if the bridge owns the pose, or before it said so in this run.
  const std::optional<Shift>& shift() const { return shift_; }

 private:
  static constexpr double kBlockedS = 0.5;
  struct Step {
    HostNs now = 0;
    Pose steering{};
  };
  const Step* step_at(HostNs at) const;
  bool is_of_run_before(const WorldSample& said);

  WorldParameters parameters_;
  bool rules_ground_;  ///< the real floor is flat
  std::array<Step, 512> steps_{};
  std::size_t next_ = 0, count_ = 0;
  std::optional<HostNs> answered_ns_;
  std::uint32_t session_ = 0, run_session_ = 0;
  HostNs run_began_ns_ = 0;
  bool awaits_start_ = false;
  bool stop_ = false, stop_pending_ = false;
  bool told_blocked_ = false;
  double blocked_s_ = 0.0;
  std::optional<terrain::RideState> ground_;
  std::optional<Shift> shift_;
};

}  // namespace tp100::bridge
