#pragma once
// The emulated robot's body: one rigid body on two tracks, contact physics by ODE. It shares no
// code with the model under test and is the only truth used for scoring.

#include <array>
#include <cstdint>
#include <memory>

#include "core/pose.h"
#include "course/robot.h"
#include "course/terrain.h"

namespace tp100::sim {

/// Physics step. [ns]
inline constexpr std::int64_t kPhysicsStepNs = 1'000'000;

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

/// One body in one ODE world. Worlds do not influence each other; the same calls give the same
/// bits.
class Body {
 public:
  /// The body at `start`: on the floor, or with height and tilt if `start` is on `terrain`.
  /// `on_stand`: the tracks spin free and the body does not move.
  Body(const course::EmulatedBody& values, const Pose& start, bool on_stand,
       const course::Terrain& terrain = {});
  ~Body();
  Body(Body&&) noexcept;

  /// Advances kPhysicsStepNs with tracks at these encoder-side speeds (the track deficit is applied
  /// inside).
  void step(double left_track_mps, double right_track_mps);
  /// Rotates the tracks by this distance: worn stretches lie elsewhere.
  void turn_tracks(double left_m, double right_m);
  /// Begins a disturbance: `sideways_m` to the robot's left and `yaw_rad`, spread evenly over
  /// `duration_s`.
  void disturbance(double sideways_m, double yaw_rad, double duration_s);
  bool disturbed() const;
  const BodyState& state() const;

  /// Messages that the solver has printed in this process, of all bodies; 0 in a sound run.
  static std::uint64_t solver_messages();

 private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace tp100::sim
