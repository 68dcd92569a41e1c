#pragma once
// A robot's way over the course's ramps and blocks, interval by interval: where it stands, how it
// leans, and how much of its way goes ahead in the plane.

#include <cstddef>
#include <optional>
#include <vector>

#include "core/pose.h"
#include "core/underfoot.h"
#include "model/incline.h"
#include "model/step_climb.h"
#include "terrain/world.h"

namespace tp100::terrain {

/// How the robot stands at the end of the last interval, and what the ground did during it.
struct RideState {
  /// Its slope is minus the pitch on ramps and blocks alike. Eq 6 has no slip on a block; the
  /// emulated body on the paper's block (37 mm) has: while the nose is up the belts push against
  /// 0.41 of the weight in the mean and slip 0.212 where they slip 0.160 on the level (0.203 by the
  /// slope table), while it hangs down behind the block the weight pushes with 0.22 and they slip
  /// 0.154 (0.118 by the table, whose downhill part is ours).
  model::Incline incline{};
  double height_m = 0.0;  ///< of the reference point
  double pitch_rad = 0.0;
  double roll_rad = 0.0;
  Obstacle obstacle = Obstacle::kNone;
  bool climbing = false;  ///< between touching a block and lying flat behind it
};

/// Attitude of a real body on real terrain. REP-103 signs. [rad]
struct Attitude {
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
};

/// Follows one pose. Ramps are statics (World), blocks the step climb model. No allocation after
/// construction; bounded time; safe in the real-time thread.
class Ride {
 public:
  /// `world` must outlive the ride and stay where it is. Blocks beyond the climb limit are statics
  /// only; whether the course may be driven at all is require_climbable's question.
  Ride(const World& world, const course::ShapeValues& shape);

  /// Somewhere else, on none of the obstacles.
  void restart();

  /// One interval of `dt_s` that begins at `pose` with `way_m` along the ground, slip taken off.
  /// Without `measured` the map alone says when a block is touched. With it the body is real: the
  /// climb begins when the nose rises next to a block, and slopes are the measured ones.
  const RideState& advance(const Pose& pose, double way_m, double dt_s,
                           std::optional<Attitude> measured = std::nullopt);

  const RideState& state() const { return state_; }

 private:
  struct Climb {
    model::StepClimb climb;
    const course::Block* block;
  };

  bool begin_climb(const Pose& pose, const std::optional<Attitude>& measured);
  void climb(double way_m, double dt_s);
  void stand(const Pose& pose, const std::optional<Attitude>& measured);

  const World* world_;
  std::vector<Climb> climbs_;
  Climb* active_ = nullptr;
  const course::Block* behind_ = nullptr;  ///< the block that was left last, until it is far
  double ahead_m_ = 0.0;  ///< what the poses are ahead of a climb that was noticed late; negative
  RideState state_{};
};

}  // namespace tp100::terrain
