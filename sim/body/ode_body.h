#pragma once
// One rigid body on two tracks, contact physics by ODE: floor, ramps and blocks.

#include <cstdint>
#include <memory>

#include "core/pose.h"
#include "course/robot_file.h"
#include "course/terrain.h"
#include "sim/body/body.h"
#include "sim/body/uneven_floor.h"

namespace tp100::sim {

/// One body in one ODE world. It applies each track's deficit: the track's surface is slower than
/// its encoder indicates.
class OdeBody final : public Body {
 public:
  /// Parameters as for make_body; any terrain.
  OdeBody(const course::EmulatedBody& values, const Pose& start, bool on_stand,
          const course::Terrain& terrain = {}, const UnevenFloor& floor = {});
  ~OdeBody() override;
  OdeBody(OdeBody&&) noexcept;

  void step(double left_track_mps, double right_track_mps) override;
  void turn_tracks(double left_m, double right_m) override;
  void disturbance(double sideways_m, double yaw_rad, double duration_s) override;
  bool disturbed() const override;
  const BodyState& state() const override;

  /// Number of messages that the solver has printed in this process, for all bodies; 0 in a sound
  /// run.
  static std::uint64_t solver_messages();

 private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace tp100::sim
