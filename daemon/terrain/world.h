#pragma once
// The virtual world: how the robot would stand on the course's ramps and blocks. Statics only: how
// it gets onto a block and falls off it is the step climb model's.

#include <optional>
#include <vector>

#include "core/pose.h"
#include "core/underfoot.h"
#include "course/robot.h"
#include "course/terrain.h"
#include "terrain/slice.h"

namespace tp100::terrain {

/// How the robot stands.
struct Footing {
  double height_m = 0.0;   ///< of the reference point above the floor
  double slope_rad = 0.0;  ///< climb angle along the heading, nose-up positive
  double pitch_rad = 0.0;  ///< the same as REP-103 has it: nose-up negative
  double roll_rad = 0.0;   ///< left side up positive
  Obstacle obstacle = Obstacle::kNone;
  const course::Surface* surface = nullptr;  ///< under the reference point; null: ordinary floor
};

/// A block on the line of the heading.
struct BlockAhead {
  const course::Block* block = nullptr;
  double distance_m = 0.0;  ///< from the reference point to the near edge, negative once past it
  double depth_m = 0.0;     ///< along the heading
};

/// Built once; queries allocate nothing, take bounded time and are safe in the real-time thread.
class World {
 public:
  World(const course::Terrain& terrain, const course::ShapeValues& shape);

  /// How the robot stands at x, y and yaw of `pose`. Each belt is a straight line between two
  /// wheels of the belt's radius that rests on what lies under it: on the two contacts between
  /// which the centre of mass lies, which may be the wheels or an edge between them. Pitch is the
  /// mean of both belts, roll their difference in height. Near an edge it can stand in two ways:
  /// the one next to `pose.pitch_rad`, its pitch until now, is taken. Tipping over takes no time
  /// here. A pose that is not finite stands on the level floor.
  Footing at(const Pose& pose) const;

  /// Height of floor, ramp or block at a place.
  double height_m(double x_m, double y_m) const;

  /// The nearest block ahead of the rear end of a robot at `pose`, at most `within_m` ahead of its
  /// reference point.
  std::optional<BlockAhead> next_block(const Pose& pose, double within_m) const;

  /// Blocks that next_block() points into.
  const std::vector<course::Block>& blocks() const { return terrain_.blocks; }

  bool flat() const { return pieces_.empty(); }

 private:
  struct Piece {
    Outline outline;
    Obstacle obstacle;
  };
  struct Rest {
    double slope_rad;
    double height_m;  // of the reference point
    Obstacle obstacle;
  };
  bool near(const Outline& outline, double x_m, double y_m) const;
  Rest rest(double x_m, double y_m, double cos_yaw, double sin_yaw, double slope_rad) const;

  course::Terrain terrain_;
  course::ShapeValues shape_;
  std::vector<Piece> pieces_;
};

}  // namespace tp100::terrain
