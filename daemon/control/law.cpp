#include "control/law.h"

#include <algorithm>
#include <cmath>

#include "control/lqr.h"
#include "core/arithmetic.h"

namespace tp100::control {
namespace {

/// The desired-yaw law: the tangent a little ahead, minus atan(k_e e / (v + v_s)) (Hoffmann and
/// others, Autonomous automobile trajectory tracking for off-road driving, 2007), minus the slip
/// angle. It looks ahead only by the robot's lag and cuts no corner.
class Stanley final : public Law {
 public:
  explicit Stanley(const Parameters& parameters) : parameters_(parameters) {}

  double look_ahead_m(double speed_mps) const override { return speed_mps * parameters_.preview_s; }
  LawOutput steer(const PathErrors& errors) const override {
    const double gain =
        parameters_.cross_track_gain_1ps / (errors.speed_mps + parameters_.soft_speed_mps);
    const double wish = std::atan(gain * errors.cross_track_m);
    const double approach =
        std::clamp(wish, -parameters_.max_approach_rad, parameters_.max_approach_rad);
    LawOutput steering;
    steering.yaw_rad = errors.ahead.yaw_rad - approach - errors.crab_rad;
    steering.yaw_rate_radps = errors.ahead.curvature_1pm * errors.speed_mps;
    // The desired yaw changes as the robot comes nearer; without this term it would lag and
    // overshoot.
    if (wish == approach) {
      const double closing_mps = errors.speed_mps * std::sin(errors.heading_rad + errors.crab_rad);
      const double steepness =
          gain / (1.0 + gain * gain * errors.cross_track_m * errors.cross_track_m);
      steering.yaw_rate_radps -= steepness * closing_mps;
    }
    return steering;
  }
  void retune(const Parameters& parameters) override { parameters_ = parameters; }

 private:
  Parameters parameters_;
};

/// Pure pursuit: the circle through the robot that meets the path at a point ahead has the
/// curvature 2 y / Ld^2 (Coulter 1992). Regulated: Ld grows with the speed, the tracker's speed
/// falls in curves. It cuts corners by about curvature Ld^2 / 8, so Ld is a length for small
/// arenas.
class PurePursuit final : public Law {
 public:
  PurePursuit(const Parameters& parameters, const TrackLimits& limits)
      : parameters_(parameters), yaw_kp_(limits.yaw_kp) {}

  double look_ahead_m(double speed_mps) const override {
    return std::clamp(speed_mps * parameters_.pursuit_s, parameters_.pursuit_min_m,
                      std::max(parameters_.pursuit_min_m, parameters_.pursuit_max_m));
  }
  LawOutput steer(const PathErrors& errors) const override {
    // The robot moves along its heading plus the slip angle: that is the direction of the circle.
    const double course_over_ground_rad = errors.heading_rad + errors.crab_rad;
    const double c = std::cos(course_over_ground_rad), s = std::sin(course_over_ground_rad);
    const double left_m = errors.ahead.left_m - errors.cross_track_m;
    const double forward = c * errors.ahead.along_m + s * left_m;
    const double sideways = -s * errors.ahead.along_m + c * left_m;
    const double distance = std::max(magnitude(forward, sideways), parameters_.pursuit_min_m);
    // A point behind the robot is treated as if it were abeam.
    const double y = forward < 0.0 ? std::copysign(distance, sideways)
                                   : std::clamp(sideways, -distance, distance);
    const double curvature = 2.0 * y / (distance * distance);

    LawOutput steering;
    steering.yaw_rate_radps = errors.curvature_1pm * errors.speed_mps;
    const double remaining_radps = curvature * errors.speed_mps - steering.yaw_rate_radps;
    const double approach_rad =
        course_over_ground_rad - errors.ahead.yaw_rad + remaining_radps / yaw_kp_;
    steering.yaw_rad =
        errors.ahead.yaw_rad - errors.crab_rad +
        std::clamp(approach_rad, -parameters_.max_approach_rad, parameters_.max_approach_rad);
    return steering;
  }
  void retune(const Parameters& parameters) override { parameters_ = parameters; }

 private:
  Parameters parameters_;
  double yaw_kp_;
};

}  // namespace

std::unique_ptr<Law> make_law(const Parameters& parameters, const TrackLimits& limits) {
  switch (parameters.law) {
    case LawName::kStanley:
      break;
    case LawName::kPurePursuit:
      return std::make_unique<PurePursuit>(parameters, limits);
    case LawName::kLqr:
      return std::make_unique<Lqr>(parameters, limits);
  }
  return std::make_unique<Stanley>(parameters);
}

}  // namespace tp100::control
