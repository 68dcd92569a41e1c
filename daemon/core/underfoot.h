#pragma once
// What the robot stands on, as every step publishes it.

#include <cstdint>

namespace tp100 {

/// Where pitch and roll of the published poses come from; follows from the set-up.
enum class PitchSource : std::uint8_t {
  kVirtual,   ///< the virtual world (bench, flat)
  kImu,       ///< the robot's own IMU (terrain)
  kExternal,  ///< an external world (udp, files)
};

/// What carries the robot.
enum class Obstacle : std::uint8_t {
  kNone,   ///< the level floor alone
  kRamp,   ///< a ramp, at least in part; its flat top included
  kBlock,  ///< a block, at least in part
};

/// Whether the belts still move the robot.
enum class Traction : std::uint8_t {
  kGripping,     ///< slip within its bound, or nothing to judge by
  kSlipping,     ///< slip beyond its bound
  kImmobilised,  ///< the belts run and the robot hardly moves
};

/// The ground under the steering pose.
struct Underfoot {
  PitchSource pitch_source = PitchSource::kVirtual;
  Obstacle obstacle = Obstacle::kNone;  ///< by the course's map
  bool climbing = false;                ///< between touching a block and lying flat behind it
  double slope_rad = 0.0;               ///< climb angle, nose-up positive
  double slip_offset = 0.0;             ///< of the surface, added to both slip ratios
  Traction traction = Traction::kGripping;
};

}  // namespace tp100
