#pragma once
// Linear quadratic regulator on cross-track error, heading error and turn rate. The robot's turn
// rate follows with a lag, so the plant is e' = v psi, psi' = w, w' = (u - w) / T around the path's
// own turn; gains come from the discrete Riccati equation, solved at set-up for a range of speeds.

#include <array>

#include "control/law.h"

namespace tp100::control {

class Lqr final : public Law {
 public:
  Lqr(const Parameters& parameters, const TrackLimits& limits);

  /// u = -(cross_track e + heading psi + rate w), w being the turn rate beyond the path's own.
  struct Gains {
    double cross_track = 0.0;  ///< [rad/s/m]
    double heading = 0.0;      ///< [1/s]
    double rate = 0.0;         ///< [1]
  };
  /// Gains at a speed: linear between the solved speeds, outside them those of the nearest.
  Gains gains(double speed_mps) const;

  double look_ahead_m(double speed_mps) const override;
  LawOutput steer(const PathErrors& errors) const override;
  /// The gains stay as they were solved.
  void retune(const Parameters& parameters) override { parameters_ = parameters; }

 private:
  static constexpr std::size_t kSpeeds = 12;
  Parameters parameters_;
  double yaw_kp_;
  std::array<Gains, kSpeeds> gains_{};
};

}  // namespace tp100::control
