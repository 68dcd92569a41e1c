#include "control/tracker.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "core/limits.h"

namespace tp100::control {
namespace {

// The tracks' speed is quantised to a few edges: a sign that is shorter than this is noise.
constexpr double kDisturbedS = 0.015;

using Kind = course::PathSegment::Kind;

// A yaw loop that cannot close the last fraction of a degree must not block the run for ever.
constexpr double kSettleTimeoutS = 2.0;
// A large heading error slows the robot down, but never to a stop.
constexpr double kSlowestShare = 0.25;
// A turn may take this share of the tracks' limit: the rest is for the yaw loop.
constexpr double kTurnShare = 0.85;
// After a disturbance the robot drives slowly until it heads towards its target.
constexpr double kLooksBackRad = 20.0 * kRadPerDeg;

/// ICR offset in a turn in which the slower track has `ratio` times the faster one's speed. [m]
double x_icr_m(const model::TrackParameters& tracks, double ratio) {
  return model::turn_of(tracks, model::Mode::kExtended, model::turn_shape(ratio, 1.0)).x_icr_m;
}

// Ratio of slower to faster track on the spot, and while an error is corrected.
constexpr double kSpot = -1.0, kSteering = 0.4;

std::vector<Corner> corners(const course::Path& path, double x_icr_m) {
  const auto& segments = path.segments();
  std::vector<Corner> result(segments.size() + 1);
  for (std::size_t i = 1; i + 1 < segments.size(); ++i) {
    const course::PathSegment &before = segments[i - 1], &turn = segments[i],
                              &after = segments[i + 1];
    if (before.kind == Kind::kLine && turn.kind == Kind::kPivot && after.kind == Kind::kLine)
      result[i] = Corner{turn, x_icr_m, std::min(before.length_m, after.length_m)};
  }
  return result;
}

}  // namespace

void DisturbanceDetector::restart(std::uint32_t contradictions) {
  contradictions_ = contradictions;
  lasted_s_ = 0.0;
}

bool DisturbanceDetector::update(const DisturbanceSigns& signs, double dt_s) {
  const bool turned =
      std::abs(signs.gyro_radps - signs.tracks_radps) > parameters_.disturbance_radps;
  lasted_s_ = turned ? lasted_s_ + dt_s : 0.0;
  const bool moved = signs.contradictions != contradictions_;
  contradictions_ = signs.contradictions;
  return moved || lasted_s_ >= kDisturbedS;
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

Tracker::Tracker(const Parameters& parameters, const course::Path& path, const DriveModel& drive)
    : parameters_(parameters),
      path_(path),
      drive_(drive),
      corners_(corners(path, x_icr_m(drive.tracks, kSpot))),
      law_(make_law(parameters, drive.limits)),
      progress_(path) {
  for (const course::PathSegment& segment : path_.segments()) {
    if (segment.kind == Kind::kPivot) {
      nominal_duration_s_ +=
          std::abs(segment.end.yaw_rad - segment.begin.yaw_rad) / parameters_.pivot_rate_radps +
          parameters_.pivot_rate_radps / parameters_.pivot_acceleration_radps2 +
          2.0 * parameters_.settle_s;
    } else {
      nominal_duration_s_ += segment.length_m / curve_mps(segment.begin.curvature_1pm);
    }
  }
  nominal_duration_s_ += drive_.speed_mps / parameters_.acceleration_mps2 + parameters_.settle_s;
  restart();
}

void Tracker::restart() {
  progress_.restart();
  recovery_.restart();
  paused_ = false;
  commanded_mps_ = 0.0;
  target_ = Target{};
  begin_segment();
}

void Tracker::resume(double progress_m, double yaw_rad) {
  restart();
  progress_.resume(progress_m, yaw_rad);
  target_.progress_m = progress_m;
  begin_segment();
  if (progress_.segment().kind == Kind::kPivot) pivot_.begin_at(yaw_rad);
}

void Tracker::begin_segment() {
  settled_s_ = 0.0;
  waited_s_ = 0.0;
  stopping_ = false;
  if (progress_.segment().kind == Kind::kPivot) {
    const double max_mps = kTurnShare * drive_.limits.max_track_mps *
                           (1.0 - std::max(drive_.limits.slip_left, drive_.limits.slip_right));
    pivot_.begin(progress_.segment(),
                 max_mps / (drive_.limits.wheelbase_m / 2.0 + corner().radius_m()));
  }
}

void Tracker::next_segment() {
  if (progress_.next())
    begin_segment();
  else
    target_.done = true;
}

bool Tracker::settled(const Twist& twist, bool in_tolerance, double dt_s) {
  const bool standstill =
      std::abs(twist.vx_mps) < kStandstillMps && std::abs(twist.yaw_rate_radps) < kStandstillRadps;
  settled_s_ = standstill && in_tolerance ? settled_s_ + dt_s : 0.0;
  waited_s_ += dt_s;
  return settled_s_ >= parameters_.settle_s || (standstill && waited_s_ >= kSettleTimeoutS);
}

void Tracker::come_to_rest(double yaw_rad) {
  commanded_mps_ = 0.0;
  target_.speed_mps = 0.0;
  target_.yaw_rate_radps = 0.0;
  target_.desired_yaw_rad = yaw_rad;
}

const Target& Tracker::update(const Pose& pose, const Twist& twist, double dt_s, bool disturbed) {
  if (target_.done) {
    come_to_rest(pose.yaw_rad);
    return target_;
  }
  if (disturbed) recovery_.begin();
  if (progress_.segment().kind == Kind::kPivot) {
    turn(pose, twist, dt_s);
  } else {
    // After a disturbance the robot may be behind its earlier position.
    if (disturbed && !stopping_)
      progress_.reproject(pose.x_m, pose.y_m, parameters_.recovery_window_m);
    follow(pose, twist, dt_s);
  }
  target_.recovering = recovery_.active();
  target_.heading_error_rad = wrap_angle(target_.desired_yaw_rad - pose.yaw_rad);
  return target_;
}

double Tracker::off_path_m(double x_m, double y_m, double slack_m) const {
  // The robot may pass a corner beside its point.
  const bool turns = progress_.segment().kind == Kind::kPivot;
  const double reach_m = slack_m + (turns ? corner().reach_m() : 0.0);
  if (turns || reach_m > 0.0)
    return path_.distance(x_m, y_m, target_.progress_m - reach_m, target_.progress_m + reach_m);
  const course::PathPoint here = progress_.here();
  return magnitude(x_m - here.x_m, y_m - here.y_m);
}

void Tracker::follow(const Pose& pose, const Twist& twist, double dt_s) {
  progress_.advance(pose.x_m, pose.y_m);
  const course::PathPoint here = progress_.here();
  const double c = std::cos(here.yaw_rad);
  const double s = std::sin(here.yaw_rad);
  target_.cross_track_m = -s * (pose.x_m - here.x_m) + c * (pose.y_m - here.y_m);
  target_.progress_m = here.s_m;
  target_.off_path_m = off_path_m(pose.x_m, pose.y_m);
  recovery_.update(target_.cross_track_m, wrap_angle(pose.yaw_rad - here.yaw_rad), dt_s);

  const double left_m = progress_.left_m() - corner().stop_before_m();
  stopping_ = stopping_ || left_m <= parameters_.stop_tolerance_m;
  if (stopping_) {
    come_to_rest(pose.yaw_rad);
    if (settled(twist, true, dt_s)) next_segment();
    return;
  }
  if (paused_ && commanded_mps_ <= parameters_.acceleration_mps2 * dt_s) {
    come_to_rest(pose.yaw_rad);
    return;
  }
  steer(pose, twist, here, left_m, dt_s);
}

double Tracker::curve_mps(double curvature_1pm) const {
  const double radii = std::abs(curvature_1pm) * parameters_.full_speed_radius_m;
  return std::max(radii > 1.0 ? drive_.speed_mps / radii : drive_.speed_mps,
                  std::min(parameters_.min_speed_mps, drive_.speed_mps));
}

double Tracker::speed_cap(double left_m) const {
  double cap = drive_.speed_mps;
  if (recovery_.active() && std::abs(target_.heading_error_rad) > kLooksBackRad)
    cap *= parameters_.recovery_speed_share;
  cap = std::min(cap, std::sqrt(2.0 * parameters_.acceleration_mps2 * std::max(left_m, 0.0)));
  // The robot must be slow enough for a curve by the time it begins.
  const double braking_m = commanded_mps_ * commanded_mps_ / (2.0 * parameters_.acceleration_mps2);
  const double curvature = std::max(std::abs(progress_.here().curvature_1pm),
                                    std::abs(progress_.ahead(braking_m).curvature_1pm));
  cap = std::min(cap, curve_mps(curvature));
  return std::max(cap, std::min(parameters_.min_speed_mps, drive_.speed_mps));
}

/// Direction of the reference point's motion on a part of the path, from the heading, left
/// positive.
double Tracker::crab_rad(double curvature_1pm) const {
  if (curvature_1pm == 0.0) return drive_.slip_angle_rad;
  const double half = std::abs(curvature_1pm) * drive_.limits.wheelbase_m / 2.0;
  return -std::atan(x_icr_m(drive_.tracks, (1.0 - half) / (1.0 + half)) * curvature_1pm);
}

void Tracker::steer(const Pose& pose, const Twist& twist, const course::PathPoint& here,
                    double left_m, double dt_s) {
  const double cap_mps = speed_cap(left_m);
  const double step_mps = parameters_.acceleration_mps2 * dt_s;
  const double speed_mps = std::min(cap_mps, commanded_mps_ + (paused_ ? -step_mps : step_mps));

  const course::PathPoint ahead = progress_.ahead(law_->look_ahead_m(speed_mps));
  const double c = std::cos(here.yaw_rad), s = std::sin(here.yaw_rad);
  const double dx = ahead.x_m - here.x_m, dy = ahead.y_m - here.y_m;
  const double heading_rad = wrap_angle(pose.yaw_rad - here.yaw_rad);
  const double crab_rad = this->crab_rad(ahead.curvature_1pm);
  // Turning moves the reference point sideways but not the turning centre: the latter is steered.
  const double swing_m = x_icr_m(drive_.tracks, kSteering) * std::sin(heading_rad + crab_rad);
  const LawOutput steering = law_->steer({
      .cross_track_m = target_.cross_track_m + swing_m,
      .heading_rad = heading_rad,
      .yaw_rate_radps = twist.yaw_rate_radps,
      .speed_mps = speed_mps,
      .curvature_1pm = here.curvature_1pm,
      .crab_rad = crab_rad,
      .ahead = {.along_m = c * dx + s * dy,
                .left_m = -s * dx + c * dy,
                .yaw_rad = ahead.yaw_rad - here.yaw_rad,
                .curvature_1pm = ahead.curvature_1pm},
  });
  target_.desired_yaw_rad = here.yaw_rad + steering.yaw_rad;
  const double error = wrap_angle(target_.desired_yaw_rad - pose.yaw_rad);

  const double share = std::max(kSlowestShare, 1.0 - std::abs(error));
  // The law's turn rate is proportional to speed: a slower robot turns more slowly.
  const double curvature = speed_mps > 0.0 ? steering.yaw_rate_radps / speed_mps : 0.0;
  const double slowed =
      speed_along(std::min(speed_mps, share * cap_mps), error, curvature, drive_.limits);
  commanded_mps_ = speed_mps;
  target_.speed_mps = slowed;
  target_.yaw_rate_radps = curvature * slowed;
}

void Tracker::turn(const Pose& pose, const Twist& twist, double dt_s) {
  const course::PathSegment& segment = progress_.segment();
  commanded_mps_ = 0.0;
  target_.speed_mps = 0.0;
  target_.cross_track_m = 0.0;
  target_.progress_m = segment.begin.s_m;
  target_.off_path_m = off_path_m(pose.x_m, pose.y_m);
  if (paused_ && !pivot_.arrived()) {
    pivot_.halt_at(pose.yaw_rad);
    come_to_rest(pose.yaw_rad);
    return;
  }
  pivot_.update(parameters_, dt_s);
  target_.desired_yaw_rad = pivot_.yaw_rad();
  target_.yaw_rate_radps = pivot_.rate_radps();
  if (!pivot_.arrived()) target_.speed_mps = corner().speed_mps(pose, pivot_.rate_radps());
  const double error = std::abs(wrap_angle(pivot_.yaw_rad() - pose.yaw_rad));
  if (pivot_.arrived() && settled(twist, error < parameters_.pivot_tolerance_rad, dt_s))
    next_segment();
}

}  // namespace tp100::control
