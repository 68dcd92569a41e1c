#pragma once
// Interface of the emulated robot's body. It shares no code with the model under test and is the
// only truth used for scoring.

#include <array>
#include <cstdint>
#include <memory>

#include "core/pose.h"
#include "core/time.h"
#include "course/robot_file.h"
#include "course/terrain.h"

namespace tp100::sim {

/// Physics step. [ns]
inline constexpr HostNs kPhysicsStepNs = 1'000'000;
inline constexpr double kPhysicsStepS = static_cast<double>(kPhysicsStepNs) * 1e-9;
inline constexpr double kGravityMps2 = 9.81;

/// Exact state of the body.
struct BodyState {
  Pose pose{};                           ///< reference point: centre of the tracks' footprint
  std::array<double, 3> velocity_mps{};  ///< of the reference point, world frame
  std::array<double, 3> rate_radps{};    ///< body frame
  std::array<double, 3>
      specific_force_mps2{};  ///< body frame, at the centre of mass; +g on z at standstill
  double left_load_n = 0.0;   ///< force of the ground on the track, against driving
  double right_load_n = 0.0;
};

/// One body on two tracks. Bodies do not influence each other; the same calls give the same bits.
class Body {
 public:
  virtual ~Body() = default;

  /// Advances kPhysicsStepNs with tracks at these encoder-side speeds.
  virtual void step(double left_track_mps, double right_track_mps) = 0;
  /// Rotates the tracks by this distance, which moves their worn stretches.
  virtual void turn_tracks(double left_m, double right_m) = 0;
  /// Begins a disturbance: `sideways_m` to the robot's left and `yaw_rad`, spread evenly over
  /// `duration_s`.
  virtual void disturbance(double sideways_m, double yaw_rad, double duration_s) = 0;
  virtual bool disturbed() const = 0;
  virtual const BodyState& state() const = 0;
};

/// Makes the body with the contact law of `values` at `start`: on the floor, or with height and
/// tilt if `start` is on `terrain`. `on_stand`: the tracks spin freely and the body does not move.
/// `seed` determines an uneven floor. Throws UserError if that body cannot stand on this terrain.
std::unique_ptr<Body> make_body(const course::Emulated& values, const Pose& start, bool on_stand,
                                const course::Terrain& terrain = {}, std::uint64_t seed = 1);

}  // namespace tp100::sim
