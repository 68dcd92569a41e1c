#include "bridge/external_world.h"

#include <cmath>
#include <utility>

#include "core/arithmetic.h"

namespace tp100::bridge {
namespace {

// Steeper ground counts as a ramp.
constexpr double kRampRad = 2.0 * kRadPerDeg;
// A robot placed at the start is at most this far from it.
constexpr double kAtStartM = 0.1;
constexpr double kAtStartRad = 10.0 * kRadPerDeg;

terrain::ContactState contact_state_of(const WorldSample& received) {
  terrain::ContactState state;
  state.height_m = received.height_m;
  state.pitch_rad = received.pitch_rad;
  state.roll_rad = received.roll_rad;
  state.climbing = received.step_height_m > 0.0;
  state.obstacle = state.climbing                            ? ObstacleClass::kBlock
                   : std::abs(received.pitch_rad) > kRampRad ? ObstacleClass::kRamp
                                                             : ObstacleClass::kNone;
  state.incline = {.slope_rad = -received.pitch_rad,
                   .slip_offset = received.slip_offset,
                   .horizontal_fraction = received.blocked ? 0.0 : std::cos(received.pitch_rad)};
  return state;
}

}  // namespace

ExternalWorld::ExternalWorld(const WorldParameters& parameters, Setup setup)
    : parameters_(parameters),
      sets_terrain_(parameters.kind != WorldKind::kInternal && setup != Setup::kTerrain) {
  if (sets_terrain_) ground_.emplace();
}

void ExternalWorld::restart(HostNs now) {
  run_session_ = session_;
  run_began_ns_ = now;
  blocked_s_ = 0.0;
  transform_.reset();
  awaits_start_ = parameters_.kind == WorldKind::kFiles && parameters_.owns_pose;
}

// Text files do not name the run that they belong to.
bool ExternalWorld::is_of_run_before(const WorldSample& received) {
  if (!awaits_start_) return false;
  const PublishedStep* step = step_at(received.answered_ns);
  if (step == nullptr) return true;
  const Pose& here = step->steering;
  awaits_start_ =
      magnitude(received.pose.x_m - here.x_m, received.pose.y_m - here.y_m) > kAtStartM ||
      std::abs(wrap_angle(received.pose.yaw_rad - here.yaw_rad)) > kAtStartRad;
  return awaits_start_;
}

void ExternalWorld::take(const WorldSample& received) {
  if (received.stop && !stop_) stop_pending_ = true;
  stop_ = received.stop;
  session_ = received.session;
  reported_blocked_ = received.blocked;
  if (parameters_.owns_pose && (!received.has_pose || is_of_run_before(received))) return;
  answered_ns_ = received.answered_ns;
  if (!sets_terrain_) return;
  // A world that owns the pose may leave the ground out.
  if (received.has_ground) {
    ground_ = contact_state_of(received);
  } else if (received.has_pose) {
    WorldSample ground = received;
    ground.height_m = received.pose.z_m;
    ground.roll_rad = received.pose.roll_rad;
    ground.pitch_rad = received.pose.pitch_rad;
    ground_ = contact_state_of(ground);
  }
  if (!received.has_pose || received.answered_ns < run_began_ns_) return;
  if (const PublishedStep* step = step_at(received.answered_ns))
    transform_ = Transform2d::between(step->steering, received.pose);
}

void ExternalWorld::remember(HostNs now, const Pose& steering) {
  if (!parameters_.owns_pose) return;
  steps_[next_] = {now, steering};
  next_ = (next_ + 1) % steps_.size();
  if (count_ < steps_.size()) ++count_;
}

const ExternalWorld::PublishedStep* ExternalWorld::step_at(HostNs at) const {
  for (std::size_t back = 1; back <= count_; ++back) {
    const PublishedStep& step = steps_[(next_ + steps_.size() - back) % steps_.size()];
    if (step.now <= at) return step.now >= run_began_ns_ ? &step : nullptr;
  }
  return nullptr;
}

void ExternalWorld::wait(double dt_s) { blocked_s_ = reported_blocked_ ? blocked_s_ + dt_s : 0.0; }

bool ExternalWorld::fresh(HostNs now) const {
  if (parameters_.kind == WorldKind::kInternal) return true;
  return answered_ns_ && now - *answered_ns_ <= from_s(parameters_.timeout_s);
}

bool ExternalWorld::lost(HostNs now) const {
  return !fresh(now) || (parameters_.kind != WorldKind::kInternal && session_ != run_session_);
}

bool ExternalWorld::take_stop(bool moving) {
  return std::exchange(stop_pending_, false) || (stop_ && moving);
}

}  // namespace tp100::bridge
