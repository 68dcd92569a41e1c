#pragma once
// The external world as the step sees it: whether it is fresh, the terrain under the robot there,
// and the robot's pose there.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "bridge/parameters.h"
#include "core/pose.h"
#include "core/sample.h"
#include "terrain/terrain_follower.h"

namespace tp100::bridge {

/// Without an external world every query reports the normal state. No allocation; safe in the
/// real-time thread.
class ExternalWorld {
 public:
  ExternalWorld(const WorldParameters& parameters, Setup setup);

  /// A run begins.
  void restart(HostNs now);
  /// Takes a message of the world.
  void take(const WorldSample& received);
  /// The step at `now` is over and published this steering pose, which the world will answer.
  void remember(HostNs now, const Pose& steering);
  /// Another `dt_s` has passed, with the robot blocked or not as the world last reported.
  void wait(double dt_s);

  /// True if the world has answered a step not older than the time-out, with a pose if the world
  /// owns the pose.
  bool fresh(HostNs now) const;
  /// Not fresh, or not the world with which the run began.
  bool lost(HostNs now) const;
  /// Whether the world stops the robot: while it moves, as long as the world requests a stop; at
  /// rest once for each request.
  bool take_stop(bool moving);
  /// The world has held the robot for half a second.
  bool blocked() const { return blocked_s_ > kBlockedS; }

  /// The terrain received from the world; nothing if the bridge computes its own.
  const std::optional<terrain::ContactState>& ground() const { return ground_; }
  /// Transform from the robot's own floor into the course's world, by the pose that the external
  /// world sent; nothing if the bridge owns the pose, or before a pose was sent in this run.
  const std::optional<Transform2d>& transform() const { return transform_; }

 private:
  static constexpr double kBlockedS = 0.5;
  struct PublishedStep {
    HostNs now = 0;
    Pose steering{};
  };
  const PublishedStep* step_at(HostNs at) const;
  bool is_of_run_before(const WorldSample& received);

  WorldParameters parameters_;
  bool sets_terrain_;  ///< the world decides height and tilt: on stand and flat
  std::array<PublishedStep, 512> steps_{};
  std::size_t next_ = 0, count_ = 0;
  std::optional<HostNs> answered_ns_;
  std::uint32_t session_ = 0, run_session_ = 0;
  HostNs run_began_ns_ = 0;
  bool awaits_start_ = false;
  bool stop_ = false, stop_pending_ = false;
  bool reported_blocked_ = false;
  double blocked_s_ = 0.0;
  std::optional<terrain::ContactState> ground_;
  std::optional<Transform2d> transform_;
};

}  // namespace tp100::bridge
