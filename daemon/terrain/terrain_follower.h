#pragma once
// Follows a robot over the course's obstacles, interval by interval: its height and attitude, and
// the horizontal part of its distance.

#include <cstddef>
#include <optional>
#include <vector>

#include "core/estimates.h"
#include "core/pose.h"
#include "course/robot.h"
#include "model/step_climb.h"
#include "model/track_model.h"
#include "terrain/world.h"

namespace tp100::terrain {

/// The robot's geometry for the step climb model.
model::ClimbGeometry climb_geometry(const course::ShapeValues& shape);

/// The robot's contact at the end of the last interval, and the ground during it.
struct ContactState {
  /// Its slope is minus the pitch on ramps and blocks alike: eq 6 has no slip on a block, but the
  /// tracks of both emulated bodies slip there as on a slope of that pitch.
  model::Incline incline{};
  double height_m = 0.0;  ///< of the reference point
  double pitch_rad = 0.0;
  double roll_rad = 0.0;
  ObstacleClass obstacle = ObstacleClass::kNone;
  bool climbing = false;  ///< between touching a block and lying flat behind it
};

/// Attitude of a real body on real terrain. REP-103 signs. [rad]
struct Attitude {
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
};

/// Follows one pose. Blocks are the step climb model, all else statics (World). No allocation after
/// construction; bounded time; safe in the real-time thread.
class TerrainFollower {
 public:
  /// `world` must outlive the follower and not move. Blocks beyond the climb limit are statics
  /// only; whether the course may be driven at all is decided by require_climbable.
  TerrainFollower(const World& world, const course::ShapeValues& shape);

  /// The robot was moved: it is not on any obstacle.
  void restart();

  /// One interval of `dt_s` that begins at `pose` with `distance_m` along the ground, without slip.
  /// Without `measured` the map alone decides when a block is touched. With it the body is real:
  /// the climb begins when the nose rises next to a block, and slopes are the measured ones.
  const ContactState& advance(const Pose& pose, double distance_m, double dt_s,
                              std::optional<Attitude> measured = std::nullopt);

  const ContactState& state() const { return state_; }

 private:
  struct Climb {
    model::StepClimb climb;
    const Outline* block;
  };

  bool begin_climb(const Pose& pose, const std::optional<Attitude>& measured);
  void climb(double distance_m, double dt_s);
  void follow_map(const Pose& pose, const std::optional<Attitude>& measured);

  const World* world_;
  std::vector<Climb> climbs_;
  Climb* active_ = nullptr;
  const Outline* behind_ = nullptr;  ///< the block that was left last, until it is far away
  double ahead_m_ = 0.0;  ///< how far the poses are ahead of a climb detected late; negative
  ContactState state_{};
};

}  // namespace tp100::terrain
