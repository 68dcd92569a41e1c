#pragma once
// The emulated robot's body: one rigid body on two belts, contact physics by ODE. It shares no code
// with the model under test. The only truth that scoring uses.

#include <array>
#include <cstdint>
#include <memory>

#include "core/pose.h"
#include "course/robot.h"
#include "course/terrain.h"

namespace tp100::sim {

/// Physics step. [ns]
inline constexpr std::int64_t kPhysicsStepNs = 1'000'000;

/// What the body does, exactly.
struct BodyState {
  Pose pose{};                           ///< reference point: centre of the belts' footprint
  std::array<double, 3> velocity_mps{};  ///< of the reference point, world frame
  std::array<double, 3> rate_radps{};    ///< body frame
  std::array<double, 3>
      specific_force_mps2{};  ///< body frame, at the centre of mass; +g on z at rest
  double left_load_n = 0.0;   ///< force that the ground puts on the belt against driving
  double right_load_n = 0.0;
};

/// One body in one ODE world. Worlds do not influence each other; the same calls give the same
/// bits.
class Body {
 public:
  /// Standing at `start`: on the floor, or with its height and tilt if it stands on `terrain`.
  /// `on_stand`: the belts spin free and nothing moves.
  Body(const course::EmulatedBody& values, const Pose& start, bool on_stand,
       const course::Terrain& terrain = {});
  ~Body();
  Body(Body&&) noexcept;

  /// Advances kPhysicsStepNs with belts at these encoder-side speeds (the belt deficit is applied
  /// inside).
  void step(double left_belt_mps, double right_belt_mps);
  /// Belts that came to rest this much farther round: worn stretches lie elsewhere.
  void turn_belts(double left_m, double right_m);
  /// Begins a push: `sideways_m` to the robot's left and `yaw_rad`, spread evenly over
  /// `duration_s`.
  void shove(double sideways_m, double yaw_rad, double duration_s);
  bool shoving() const;
  const BodyState& state() const;

  /// Messages that the solver has printed in this process, of all bodies; 0 in a sound run.
  static std::uint64_t solver_messages();

 private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace tp100::sim
