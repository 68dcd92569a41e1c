#pragma once
// Recovery: from the moment at which a disturbance is noticed until the robot is back on the path.

#include <cstdint>

#include "control/parameters.h"

namespace tp100::control {

/// What may tell of a disturbance in one step.
struct DisturbanceSigns {
  double gyro_radps = 0.0;  ///< yaw rates, bias removed; equal ones say nothing
  double belts_radps = 0.0;
  std::uint32_t contradictions = 0;  ///< so far: the camera was believed against the estimate
};

/// Someone pushes or turns the robot: the gyro feels a turn that the belts do not make, or the
/// camera sees the robot elsewhere. No allocation; safe in the real-time thread.
class Disturbance {
 public:
  explicit Disturbance(const Parameters& parameters) : parameters_(parameters) {}

  /// A run begins: what was before does not count.
  void restart(std::uint32_t contradictions);
  /// True in every step in which a disturbance is seen.
  bool update(const DisturbanceSigns& signs, double dt_s);

 private:
  Parameters parameters_;
  std::uint32_t contradictions_ = 0;
  double lasted_s_ = 0.0;
};

/// Over once the robot has been within kRecoveredM and kRecoveredRad of the path for
/// kRecoveredForS. No allocation; safe in the real-time thread.
class Recovery {
 public:
  static constexpr double kRecoveredM = 0.01;
  static constexpr double kRecoveredRad = 3.0 * kRadPerDeg;
  static constexpr double kRecoveredForS = 0.5;

  /// A disturbance was seen.
  void begin();
  void restart() { active_ = false; }
  /// One step on a line or arc; the heading error is the robot's yaw against the tangent.
  void update(double cross_track_m, double heading_rad, double dt_s);
  bool active() const { return active_; }

 private:
  bool active_ = false;
  double inside_s_ = 0.0;
};

}  // namespace tp100::control
