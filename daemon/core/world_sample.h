#pragma once
// What an external world (a game engine, a simulator) said: one message.

#include <cstdint>

#include "core/pose.h"
#include "core/time.h"

namespace tp100 {

/// In the frame of the course, REP-103, already checked: finite and in range.
struct WorldSample {
  std::uint32_t session = 0;  ///< +1 each time a world was welcomed; another one is a world anew
  /// The step whose pose it answers (its `now`); a file answers nothing: when it was read.
  HostNs answered_ns = 0;
  bool stop = false;  ///< the world wants the robot to stand still, as an operator's stop
  bool has_ground = false;
  double height_m = 0.0;  ///< of the reference point above the floor
  double roll_rad = 0.0;
  double pitch_rad = 0.0;      ///< nose-up negative
  double slip_offset = 0.0;    ///< of the surface, added to both slip ratios
  double step_height_m = 0.0;  ///< of the block that the belts touch; 0: none
  bool blocked = false;        ///< the robot cannot go on, whatever its belts do
  bool has_pose = false;       ///< only a world that owns the pose says it
  Pose pose{};
};

}  // namespace tp100
