#include "terrain/terrain_follower.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arithmetic.h"

namespace tp100::terrain {
namespace {

// Search distance for a block, and greatest error of a pose when the nose rises next to one.
constexpr double kAheadM = 0.3;
constexpr double kMapErrorM = 0.08;
// This close to a block, only a riser causes a nose-up pitch this large.
constexpr double kNoseUpRad = 3.0 * kRadPerDeg;
// If approached at a larger angle, the tracks touch one after the other: only statics apply.
constexpr double kSquareRad = 30.0 * kRadPerDeg;
// Backed off the block by this much, the climb is over.
constexpr double kBackedOffM = 0.01;
// Horizontal distance per distance is bounded: a falling body moves without any track travel.
constexpr double kMinDistanceM = 1e-6;
constexpr double kMaxPlanar = 30.0;
// A measured attitude below this is noise, not terrain.
constexpr double kLevelRad = 2.0 * kRadPerDeg;
// A climb detected late is caught up with in steps of this size, over at most this distance.
constexpr double kNoticeStepM = 2e-4, kNoticedM = 0.05, kNoticeMps = 0.1;

bool far(const Pose& pose, const Outline& block) {
  return magnitude(pose.x_m - block.place.x_m, pose.y_m - block.place.y_m) >
         kAheadM + block.length_m() / 2.0;
}

}  // namespace

model::ClimbGeometry climb_geometry(const course::ShapeValues& shape) {
  return {.axle_spacing_m = shape.axle_spacing_m,
          .wheel_radius_m = shape.wheel_radius_m,
          .com_forward_m = shape.axle_spacing_m / 2.0 + shape.com_forward_m,
          .com_height_m = shape.com_height_m,
          .body_length_m = shape.length_m,
          .body_height_m = shape.height_m};
}

TerrainFollower::TerrainFollower(const World& world, const course::ShapeValues& shape)
    : world_(&world) {
  const model::ClimbGeometry geometry = climb_geometry(shape);
  for (const Outline& piece : world.pieces()) {
    const model::BlockShape block{piece.height_m(), piece.length_m()};
    if (piece.obstacle == ObstacleClass::kBlock && block.height_m <= model::climb_limit_m(geometry))
      climbs_.push_back({model::StepClimb(geometry, block), &piece});
  }
}

void TerrainFollower::restart() {
  active_ = nullptr;
  behind_ = nullptr;
  ahead_m_ = 0.0;
  state_ = ContactState{};
}

bool TerrainFollower::begin_climb(const Pose& pose, const std::optional<Attitude>& measured) {
  if (behind_ != nullptr && far(pose, *behind_)) behind_ = nullptr;
  const std::optional<BlockAhead> next = world_->next_block(pose, kAheadM);
  if (!next || next->block == behind_) return false;
  const auto found = std::find_if(climbs_.begin(), climbs_.end(),
                                  [&](const Climb& c) { return c.block == next->block; });
  if (found == climbs_.end()) return false;
  const double askew = wrap_angle(pose.yaw_rad - next->block->place.heading_rad);
  if (std::abs(std::sin(askew)) > std::sin(kSquareRad)) return false;
  const double past_touch_m = -next->distance_m - found->climb.touch_x_m();
  if (std::abs(past_touch_m) > kMapErrorM) return false;
  if (measured ? measured->pitch_rad > -kNoseUpRad : past_touch_m < 0.0) return false;
  active_ = &*found;
  active_->climb.begin(0.0);
  if (!measured) return true;
  // The nose is up already: the climb is advanced to that pitch, over which the robot covered less
  // horizontal distance than on level ground.
  model::StepClimb& climb = active_->climb;
  while (climb.state().pitch_rad > measured->pitch_rad && climb.state().travel_m < kNoticedM)
    climb.advance(kNoticeStepM, kNoticeStepM / kNoticeMps);
  ahead_m_ = climb.state().reference_m.x - climb.touch_x_m() - climb.state().travel_m;
  return true;
}

void TerrainFollower::climb(double distance_m, double dt_s) {
  const double before_m = active_->climb.state().reference_m.x;
  const model::ClimbState& now = active_->climb.advance(distance_m, dt_s);
  const double ahead_m = now.reference_m.x - before_m + std::exchange(ahead_m_, 0.0);
  state_.incline = {
      .slope_rad = -now.pitch_rad,
      .horizontal_fraction = std::abs(distance_m) < kMinDistanceM
                                 ? 1.0
                                 : std::clamp(ahead_m / distance_m, -kMaxPlanar, kMaxPlanar)};
  state_.height_m = now.reference_m.z;
  state_.pitch_rad = now.pitch_rad;
  state_.roll_rad = 0.0;
  state_.obstacle = ObstacleClass::kBlock;
  state_.climbing = true;
  const bool backed_off = now.phase == model::ClimbPhase::kApproach && now.travel_m < -kBackedOffM;
  if (now.phase != model::ClimbPhase::kDown && !backed_off) return;
  behind_ = backed_off ? nullptr : active_->block;
  active_ = nullptr;
}

void TerrainFollower::follow_map(const Pose& pose, const std::optional<Attitude>& measured) {
  Pose at = pose;
  at.pitch_rad = measured ? measured->pitch_rad : state_.pitch_rad;
  const ContactPose contact_pose = world_->at(at);
  state_.height_m = contact_pose.height_m;
  state_.pitch_rad = contact_pose.pitch_rad;
  state_.roll_rad = contact_pose.roll_rad;
  state_.obstacle = contact_pose.obstacle;
  state_.climbing = false;
  state_.incline = model::inclined(measured ? -measured->pitch_rad : contact_pose.slope_rad);
  if (contact_pose.surface != nullptr)
    state_.incline.slip_offset = contact_pose.surface->slip_offset;
}

const ContactState& TerrainFollower::advance(const Pose& pose, double distance_m, double dt_s,
                                             std::optional<Attitude> measured) {
  if (measured && std::abs(measured->pitch_rad) < kLevelRad &&
      std::abs(measured->roll_rad) < kLevelRad)
    measured = Attitude{};
  if (active_ != nullptr || begin_climb(pose, measured)) {
    climb(distance_m, dt_s);
  } else {
    follow_map(pose, measured);
  }
  if (measured) {
    state_.pitch_rad = measured->pitch_rad;
    state_.roll_rad = measured->roll_rad;
  }
  return state_;
}

}  // namespace tp100::terrain
