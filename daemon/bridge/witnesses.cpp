#include "bridge/witnesses.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"

namespace tp100::bridge {
namespace {

// Share of its way by which the robot of an external world may differ from the real one: a world
// that knows only the tracks' speeds misses their slip; on a slope it slips more and goes up
// instead of forward; a block may hold it.
constexpr double kLevelShare = 0.25;
constexpr double kSlopeShare = 0.5;
constexpr double kClimbingShare = 1.0;
// More than the ramps and blocks of any bundled course explain. A world that claims more of them
// has led the robot off its real floor.
constexpr double kMostObstacleLagM = 0.15;
// The same of the real robot's way over real ramps and blocks, of which odometry knows the slip
// less well than its covariance says.
constexpr double kRealShare = 0.15;
// The same where the robot's slip is unknown.
constexpr double kUnknownShare = 0.5;
// The same of its turns.
constexpr double kTurnShare = 0.1;
// Camera and odometry agree within these.
constexpr double kAgreeM = 0.04;
constexpr double kAgreeRad = 3.0 * kRadPerDeg;

double share_of(const terrain::ContactState& on) {
  if (on.climbing || on.incline.horizontal_fraction == 0.0) return kClimbingShare;
  const bool level = on.obstacle == ObstacleClass::kNone && on.incline.slip_offset == 0.0;
  return level ? kLevelShare : kSlopeShare;
}

}  // namespace

void WitnessPoses::begin() {
  begun_at_ = perception_.to_world();
  corrected_ = {};
  counts_from_.reset();
  slip_m_ = lag_m_ = lag_rad_ = obstacle_lag_m_ = 0.0;
}

// Nobody knows how accurately a robot was placed that is driven without a start. Its world is where
// the robot is assumed to be, too.
void WitnessPoses::continue_run() {
  if (external_.ground() && !counts_from_)
    counts_from_ = perception_.estimate(PoseSource::kOdometry);
}

void WitnessPoses::advance(double dt_s) {
  const Twist& twist = perception_.speeds().steering;
  const double way_m = std::abs(twist.vx_mps) * dt_s;
  if (identifies_) {
    slip_m_ += kUnknownShare * way_m;
  } else if (perception_.on_obstacle()) {
    slip_m_ += kRealShare * way_m;
  }
  if (perception_.camera_known()) follow_camera();
  const auto& ground = external_.ground();
  if (!ground) return;
  const double share = share_of(*ground);
  lag_m_ += share * way_m;
  if (share > kLevelShare)
    obstacle_lag_m_ = std::min(obstacle_lag_m_ + share * way_m, kMostObstacleLagM);
  lag_rad_ += kTurnShare * std::abs(twist.yaw_rate_radps) * dt_s;
}

Pose WitnessPoses::odometry() const {
  return corrected_.of(perception_.estimate(PoseSource::kOdometry).pose);
}

/// With odometry's deviations: a camera that is wrong does not know of it.
control::Witness WitnessPoses::witness(const Pose& pose, const Pose& other) const {
  const Estimate now = perception_.estimate(PoseSource::kOdometry);
  const Estimate then = counts_from_.value_or(Estimate{});
  const PlanarCovariance &all = now.covariance, &old = then.covariance;
  // The error of the heading then has grown with the distance since.
  const double dx_m = now.pose.x_m - then.pose.x_m, dy_m = now.pose.y_m - then.pose.y_m;
  const double xx = old.xx - 2.0 * dy_m * old.x_yaw + square(dy_m) * old.yaw_yaw;
  const double yy = old.yy + 2.0 * dx_m * old.y_yaw + square(dx_m) * old.yaw_yaw;
  const auto sd = [](double variance) { return std::sqrt(std::max(0.0, variance)); };
  return {.pose = pose,
          .other = other,
          .sd_m = sd(std::max(all.xx - xx, all.yy - yy)),
          .sd_rad = sd(all.yaw_yaw - old.yaw_yaw)};
}

void WitnessPoses::follow_camera() {
  const Pose fused = perception_.estimate(PoseSource::kFused).pose;
  const Pose at = odometry();
  const control::Witness one = witness(at, fused);
  const bool agree = magnitude(at.x_m - fused.x_m, at.y_m - fused.y_m) < kAgreeM + slip_m_ &&
                     std::abs(wrap_angle(at.yaw_rad - fused.yaw_rad)) < kAgreeRad;
  if (one.sd_m < kCertainM || !agree) return;
  const Estimate now = perception_.estimate(PoseSource::kOdometry);
  corrected_ = Transform2d::between(now.pose, fused);
  counts_from_ = now;
  slip_m_ = 0.0;
}

control::Witnesses WitnessPoses::now(const control::Tracker* tracker) const {
  control::Witnesses all;
  if (parameters_.setup == Setup::kStand) return all;
  const bool external = external_.ground().has_value();
  const Transform2d& to_world = external ? begun_at_ : perception_.to_world();
  const auto add = [&](control::Witness one, std::optional<Fault> contradiction) {
    one.contradiction = contradiction;
    one.obstacle_lag_m = obstacle_lag_m_ + slip_m_;
    // Where the world is another one, progress is that of its robot.
    const double slack_m = external ? control::Envelope::kContradictionM + lag_m_ : 0.0;
    if (tracker != nullptr)
      one.off_path_m = tracker->off_path_m(one.pose.x_m, one.pose.y_m, slack_m);
    all.push(one);
  };
  const PoseSource steering = parameters_.steering;
  const Pose by_odometry = to_world.of(odometry());
  const Pose fused = to_world.of(perception_.estimate(PoseSource::kFused).pose);
  if (external) {
    control::Witness floor =
        witness(to_world.of(perception_.steering_pose()), perception_.world_pose());
    floor.lag_m = lag_m_;
    floor.lag_rad = lag_rad_;
    add(floor, Fault::world_against_odometry);
  }
  if (steering == PoseSource::kModel) add(witness(by_odometry, by_odometry), std::nullopt);
  if (!perception_.camera_known()) return all;
  control::Witness seen =
      steering == PoseSource::kFused ? witness(by_odometry, fused) : witness(fused, by_odometry);
  seen.lag_m = slip_m_;
  add(seen, Fault::camera_against_odometry);
  return all;
}

}  // namespace tp100::bridge
