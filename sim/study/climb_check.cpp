#include "sim/study/climb_check.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "model/step_climb.h"
#include "sim/body/body.h"
#include "terrain/climbable.h"

namespace tp100::sim {
namespace {

constexpr double kRunUpM = 0.05;
constexpr double kBehindM = 0.10;
constexpr double kLittleCreep = 0.005;
constexpr double kGrip = 1.2;

course::EmulatedBody gripping(course::EmulatedBody body) {
  body.belt_deficit_left = body.belt_deficit_right = 0.0;
  body.creep_left = body.creep_right = kLittleCreep;
  body.friction = kGrip;
  return body;
}

}  // namespace

ClimbCheck check_climb_pitch(const course::Robot& robot, double height_m, double depth_m,
                             double belt_mps) {
  const course::EmulatedBody values = gripping(robot.emulated.body);
  model::StepClimb climb(terrain::climb_geometry(robot.shape),
                         {.height_m = height_m, .depth_m = depth_m}, model::RiserForm::kBeltHolds,
                         model::TipStart::kLiftOff);
  climb.reset(kRunUpM);
  course::Block block{};
  block.place.x_m = kRunUpM - climb.touch_x_m() + depth_m / 2.0;
  block.height_m = height_m;
  block.depth_m = depth_m;
  block.width_m = 4.0 * values.gauge_m;
  course::Terrain terrain;
  terrain.blocks.push_back(block);
  Body body(values, {}, false, terrain);

  const double way_m = kRunUpM + depth_m + 2.0 * values.length_m + kBehindM;
  const double dt_s = 1e-9 * static_cast<double>(kPhysicsStepNs);
  const auto steps = static_cast<std::size_t>(way_m / belt_mps / dt_s);
  ClimbCheck check;
  check.height_m = height_m;
  double squares = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    body.step(belt_mps, belt_mps);
    const model::ClimbState& state = climb.advance(belt_mps * dt_s, dt_s);
    const double off = state.pitch_rad - body.state().pose.pitch_rad;
    const bool level = state.phase == model::ClimbPhase::kApproach ||
                       (state.phase == model::ClimbPhase::kDown && std::abs(off) < 1e-3);
    if (level) continue;
    check.pitch_max_rad = std::max(check.pitch_max_rad, std::abs(off));
    squares += off * off;
    ++count;
  }
  if (count > 0) check.pitch_rms_rad = std::sqrt(squares / static_cast<double>(count));
  check.crossed = body.state().pose.x_m > block.place.x_m + depth_m / 2.0;
  return check;
}

}  // namespace tp100::sim
