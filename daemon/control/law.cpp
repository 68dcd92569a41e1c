#include "control/law.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

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

using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

constexpr double kLowestMps = 0.01;
constexpr double kSpeedRatio = 1.5;
constexpr double kStepS = 0.005;
constexpr double kShortestLagS = 0.01;

double speed_of(std::size_t index) {
  return kLowestMps * std::pow(kSpeedRatio, static_cast<double>(index));
}

/// Solution of the discrete Riccati equation by doubling (Chu, Fan, Lin, Wang 2004): each round
/// doubles the horizon.
Matrix riccati(Matrix a, const Vector& b, const Matrix& q, double r) {
  Matrix g = b * b.transpose() / r;
  Matrix h = q;
  constexpr int kRounds = 24;
  for (int i = 0; i < kRounds; ++i) {
    const Matrix w = (Matrix::Identity() + g * h).inverse();
    const Matrix longer_g = g + a * w * g * a.transpose();
    const Matrix longer_h = h + a.transpose() * h * w * a;
    a = a * w * a;
    g = longer_g;
    h = longer_h;
  }
  return h;
}

/// Linear quadratic regulator on cross-track error, heading error and turn rate. The robot's turn
/// rate follows with a lag, so the plant is e' = v psi, psi' = w, w' = (u - w) / T around the
/// path's own turn; gains come from the discrete Riccati equation, solved at set-up for a range of
/// speeds.
class Lqr final : public Law {
 public:
  Lqr(const Parameters& parameters, const TrackLimits& limits);

  double look_ahead_m(double speed_mps) const override { return speed_mps * parameters_.preview_s; }
  LawOutput steer(const PathErrors& errors) const override;
  /// The gains stay as they were solved.
  void retune(const Parameters& parameters) override { parameters_ = parameters; }

 private:
  /// u = -(cross_track e + heading psi + rate w), w being the turn rate beyond the path's own.
  struct Gains {
    double cross_track = 0.0;  ///< [rad/s/m]
    double heading = 0.0;      ///< [1/s]
    double rate = 0.0;         ///< [1]
  };
  static Gains solve(const Parameters& parameters, double speed_mps);
  /// Linear between the solved speeds, outside them those of the nearest.
  Gains gains(double speed_mps) const;

  static constexpr std::size_t kSpeeds = 12;
  Parameters parameters_;
  double yaw_kp_;
  std::array<Gains, kSpeeds> gains_{};
};

Lqr::Gains Lqr::solve(const Parameters& parameters, double speed_mps) {
  const double lag_s = std::max(parameters.preview_s, kShortestLagS);
  Matrix a = Matrix::Identity();
  a(0, 1) = speed_mps * kStepS;
  a(1, 2) = kStepS;
  a(2, 2) = std::exp(-kStepS / lag_s);
  const Vector b(0.0, 0.0, 1.0 - a(2, 2));
  // Bryson's rule: each weight is the inverse square of the acceptable error.
  const auto weight = [](double allowed) { return 1.0 / (allowed * allowed); };
  Matrix q = Matrix::Zero();
  q(0, 0) = weight(parameters.lqr_cross_track_m);
  q(1, 1) = weight(parameters.lqr_heading_rad);
  const double r = weight(parameters.lqr_turn_radps);
  const Matrix p = riccati(a, b, q, r);
  const Eigen::RowVector3d k = b.transpose() * p * a / (r + b.dot(p * b));
  return {k[0], k[1], k[2]};
}

Lqr::Lqr(const Parameters& parameters, const TrackLimits& limits)
    : parameters_(parameters), yaw_kp_(limits.yaw_kp) {
  for (std::size_t i = 0; i < kSpeeds; ++i) gains_[i] = solve(parameters, speed_of(i));
}

Lqr::Gains Lqr::gains(double speed_mps) const {
  std::size_t above = 1;
  while (above + 1 < kSpeeds && speed_of(above) < speed_mps) ++above;
  const double below_mps = speed_of(above - 1);
  const double share =
      std::clamp((speed_mps - below_mps) / (speed_of(above) - below_mps), 0.0, 1.0);
  const Gains& a = gains_[above - 1];
  const Gains& b = gains_[above];
  return {std::lerp(a.cross_track, b.cross_track, share), std::lerp(a.heading, b.heading, share),
          std::lerp(a.rate, b.rate, share)};
}

LawOutput Lqr::steer(const PathErrors& errors) const {
  const Gains k = gains(errors.speed_mps);
  LawOutput steering;
  steering.yaw_rate_radps = errors.ahead.curvature_1pm * errors.speed_mps;
  // Far from the path, the cross-track error may request the steepest approach and no more.
  const double steepest = k.heading * parameters_.max_approach_rad;
  const double approach = std::clamp(k.cross_track * errors.cross_track_m, -steepest, steepest);
  const double course_over_ground_rad = errors.heading_rad + errors.crab_rad - errors.ahead.yaw_rad;
  const double remaining_radps = -(approach + k.heading * course_over_ground_rad +
                                   k.rate * (errors.yaw_rate_radps - steering.yaw_rate_radps));
  const double approach_rad = course_over_ground_rad + remaining_radps / yaw_kp_;
  steering.yaw_rad =
      errors.ahead.yaw_rad - errors.crab_rad +
      std::clamp(approach_rad, -parameters_.max_approach_rad, parameters_.max_approach_rad);
  return steering;
}

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
