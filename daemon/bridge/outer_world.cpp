#include "bridge/outer_world.h"

#include <cmath>
#include <utility>

#include "core/angle.h"

namespace tp100::bridge {
namespace {

// Steeper ground is called a ramp.
constexpr double kRampRad = 2.0 * kRadPerDeg;
// A robot that was put to the start is no farther from it.
constexpr double kAtStartM = 0.1;
constexpr double kAtStartRad = 10.0 * kRadPerDeg;

terrain::RideState ride_of(const WorldSample& said) {
  terrain::RideState state;
  state.height_m = said.height_m;
  state.pitch_rad = said.pitch_rad;
  state.roll_rad = said.roll_rad;
  state.climbing = said.step_height_m > 0.0;
  state.obstacle = state.climbing                        ? Obstacle::kBlock
                   : std::abs(said.pitch_rad) > kRampRad ? Obstacle::kRamp
                                                         : Obstacle::kNone;
  state.incline = {.slope_rad = -said.pitch_rad,
                   .slip_offset = said.slip_offset,
                   .planar = said.blocked ? 0.0 : std::cos(said.pitch_rad)};
  return state;
}

}  // namespace

Pose Shift::of(const Pose& pose) const {
  Pose out = pose;
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  // Not turned, nothing is rounded.
  out.x_m = (turn_rad == 0.0 ? pose.x_m : c * pose.x_m - s * pose.y_m) + x_m;
  out.y_m = (turn_rad == 0.0 ? pose.y_m : s * pose.x_m + c * pose.y_m) + y_m;
  out.yaw_rad = pose.yaw_rad + turn_rad;
  return out;
}

Shift Shift::between(const Pose& from, const Pose& to) {
  Shift shift;
  shift.turn_rad = wrap_angle(to.yaw_rad - from.yaw_rad);
  const Pose turned = shift.of(from);
  shift.x_m = to.x_m - turned.x_m;
  shift.y_m = to.y_m - turned.y_m;
  return shift;
}

OuterWorld::OuterWorld(const WorldParameters& parameters, Setup setup)
    : parameters_(parameters),
      rules_ground_(parameters.kind != WorldKind::kInternal && setup != Setup::kTerrain) {
  if (rules_ground_) ground_.emplace();
}

void OuterWorld::restart(HostNs now) {
  run_session_ = session_;
  run_began_ns_ = now;
  blocked_s_ = 0.0;
  shift_.reset();
  awaits_start_ = parameters_.kind == WorldKind::kFiles && parameters_.owns_pose;
}

// Text files do not tell which run they speak of.
bool OuterWorld::is_of_run_before(const WorldSample& said) {
  if (!awaits_start_) return false;
  const Step* step = step_at(said.answered_ns);
  if (step == nullptr) return true;
  const Pose& here = step->steering;
  awaits_start_ = std::hypot(said.pose.x_m - here.x_m, said.pose.y_m - here.y_m) > kAtStartM ||
                  std::abs(wrap_angle(said.pose.yaw_rad - here.yaw_rad)) > kAtStartRad;
  return awaits_start_;
}

void OuterWorld::take(const WorldSample& said) {
  if (said.stop && !stop_) stop_pending_ = true;
  stop_ = said.stop;
  session_ = said.session;
  told_blocked_ = said.blocked;
  if (parameters_.owns_pose && (!said.has_pose || is_of_run_before(said))) return;
  answered_ns_ = said.answered_ns;
  if (!rules_ground_) return;
  // A world that owns the pose may leave the ground out.
  if (said.has_ground) {
    ground_ = ride_of(said);
  } else if (said.has_pose) {
    WorldSample ground = said;
    ground.height_m = said.pose.z_m;
    ground.roll_rad = said.pose.roll_rad;
    ground.pitch_rad = said.pose.pitch_rad;
    ground_ = ride_of(ground);
  }
  if (!said.has_pose || said.answered_ns < run_began_ns_) return;
  if (const Step* step = step_at(said.answered_ns))
    shift_ = Shift::between(step->steering, said.pose);
}

void OuterWorld::remember(HostNs now, const Pose& steering) {
  if (!parameters_.owns_pose) return;
  steps_[next_] = {now, steering};
  next_ = (next_ + 1) % steps_.size();
  if (count_ < steps_.size()) ++count_;
}

const OuterWorld::Step* OuterWorld::step_at(HostNs at) const {
  for (std::size_t back = 1; back <= count_; ++back) {
    const Step& step = steps_[(next_ + steps_.size() - back) % steps_.size()];
    if (step.now <= at) return step.now >= run_began_ns_ ? &step : nullptr;
  }
  return nullptr;
}

void OuterWorld::wait(double dt_s) { blocked_s_ = told_blocked_ ? blocked_s_ + dt_s : 0.0; }

bool OuterWorld::fresh(HostNs now) const {
  if (parameters_.kind == WorldKind::kInternal) return true;
  return answered_ns_ && now - *answered_ns_ <= from_s(parameters_.timeout_s);
}

bool OuterWorld::lost(HostNs now) const {
  return !fresh(now) || (parameters_.kind != WorldKind::kInternal && session_ != run_session_);
}

bool OuterWorld::take_stop(bool moving) {
  return std::exchange(stop_pending_, false) || (stop_ && moving);
}

}  // namespace tp100::bridge
