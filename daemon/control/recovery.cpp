#include "control/recovery.h"

#include <cmath>

namespace tp100::control {
namespace {

// The belts' speed is known to a few edges: shorter than this is noise.
constexpr double kPushedS = 0.015;

}  // namespace

void Disturbance::restart(std::uint32_t contradictions) {
  contradictions_ = contradictions;
  lasted_s_ = 0.0;
}

bool Disturbance::update(const DisturbanceSigns& signs, double dt_s) {
  const bool turned = std::abs(signs.gyro_radps - signs.belts_radps) > parameters_.push_radps;
  lasted_s_ = turned ? lasted_s_ + dt_s : 0.0;
  const bool moved = signs.contradictions != contradictions_;
  contradictions_ = signs.contradictions;
  return moved || lasted_s_ >= kPushedS;
}

void Recovery::begin() {
  active_ = true;
  inside_s_ = 0.0;
}

void Recovery::update(double cross_track_m, double heading_rad, double dt_s) {
  if (!active_) return;
  const bool inside =
      std::abs(cross_track_m) < kRecoveredM && std::abs(heading_rad) < kRecoveredRad;
  inside_s_ = inside ? inside_s_ + dt_s : 0.0;
  active_ = inside_s_ < kRecoveredForS;
}

}  // namespace tp100::control
