#include "bridge/terrain_contacts.h"

#include <algorithm>
#include <cmath>

namespace tp100::bridge {
namespace {

void place(const terrain::ContactState& on, Pose& pose) {
  pose.z_m = on.height_m;
  pose.roll_rad = on.roll_rad;
  pose.pitch_rad = on.pitch_rad;
}

}  // namespace

course::Terrain floor_of(const course::Terrain& terrain, Setup setup) {
  switch (setup) {
    case Setup::kTerrain:
      return terrain;
    case Setup::kFlat:
      return {.obstacles = {}, .surfaces = terrain.surfaces};
    case Setup::kStand:
      break;
  }
  return {};
}

TerrainContacts::TerrainContacts(const Parameters& parameters, const course::Course* course)
    : setup_(parameters.setup),
      steering_(parameters.steering),
      tracks_(parameters.model),
      floor_(course == nullptr ? course::Terrain{} : floor_of(course->terrain, setup_),
             parameters.shape),
      world_(course == nullptr ? course::Terrain{} : course->terrain, parameters.shape),
      followers_(same_for_all(terrain::TerrainFollower(floor_, parameters.shape))),
      virtual_(world_, parameters.shape) {}

void TerrainContacts::restart() {
  for (terrain::TerrainFollower& follower : followers_.values) follower.restart();
  virtual_.restart();
  mapped_pitch_rad_.reset();
  transform_ = {};
  transform_received_ = false;
}

bool TerrainContacts::level() const {
  const auto level = [](const terrain::TerrainFollower& follower) {
    const terrain::ContactState& on = follower.state();
    return !on.climbing && on.obstacle == ObstacleClass::kNone && on.height_m == 0.0 &&
           on.pitch_rad == 0.0 && on.roll_rad == 0.0;
  };
  return std::all_of(followers_.values.begin(), followers_.values.end(), level) &&
         level(virtual_) && !transform_received_;
}

double TerrainContacts::distance_m(const TerrainInput& in, const model::Incline& incline) const {
  return model::body_twist(tracks_, model::Mode::kExtended, in.tracks.left_mps, in.tracks.right_mps,
                           incline)
             .vx_mps *
         in.dt_s;
}

void TerrainContacts::set_external_terrain(const ExternalTerrain& external) {
  external_ = external.contact;
  if (!external.transform) return;
  transform_ = *external.transform;
  transform_received_ = true;
}

void TerrainContacts::advance(const TerrainInput& in) {
  std::optional<terrain::Attitude> attitude;
  if (real()) attitude = in.imu;
  for (const PoseSource source : kPoseSources) {
    terrain::TerrainFollower& follower = followers_[source];
    follower.advance(in.estimates[source].pose, distance_m(in, follower.state().incline), in.dt_s,
                     attitude);
  }
  if (world_.flat() && !external_) return;
  const Pose& steering = in.estimates[steering_].pose;
  if (real()) {
    Pose expected = steering;
    expected.pitch_rad = mapped_pitch_rad_.value_or(0.0);
    mapped_pitch_rad_ = world_.at(expected).pitch_rad;
    return;
  }
  if (transform_received_) return;
  const double along_m = distance_m(in, world_contact().incline);
  if (!external_) virtual_.advance(world(steering), along_m, in.dt_s);
  const double ahead_m = along_m * world_contact().incline.horizontal_fraction -
                         distance_m(in, followers_[steering_].state().incline);
  transform_.x_m += ahead_m * std::cos(steering.yaw_rad);
  transform_.y_m += ahead_m * std::sin(steering.yaw_rad);
}

estimation::Ground TerrainContacts::ground(PoseSource source) const {
  const terrain::ContactState& on = followers_[source].state();
  return {.horizontal_fraction = on.incline.horizontal_fraction,
          .z_m = on.height_m,
          .roll_rad = on.roll_rad,
          .pitch_rad = on.pitch_rad,
          .slip = model::slip_on(tracks_, model::Mode::kExtended, on.incline),
          .hold_slip = on.climbing};
}

const terrain::ContactState& TerrainContacts::world_contact() const {
  if (real()) return followers_[steering_].state();
  return external_ ? *external_ : virtual_.state();
}

Pose TerrainContacts::world(const Pose& steering) const {
  Pose pose = transform_.of(steering);
  place(world_contact(), pose);
  return pose;
}

void TerrainContacts::set_attitude(PerSource<Estimate>& estimates) const {
  for (const PoseSource source : kPoseSources)
    place(real() ? followers_[source].state() : world_contact(), estimates[source].pose);
}

TerrainContact TerrainContacts::terrain_contact() const {
  const terrain::ContactState& on = world_contact();
  return {.pitch_source = real()      ? PitchSource::kImu
                          : external_ ? PitchSource::kExternal
                                      : PitchSource::kVirtual,
          .obstacle = on.obstacle,
          .climbing = on.climbing,
          .slope_rad = -on.pitch_rad,
          .slip_offset = on.incline.slip_offset};
}

}  // namespace tp100::bridge
