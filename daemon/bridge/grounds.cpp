#include "bridge/grounds.h"

#include <cmath>

namespace tp100::bridge {
namespace {

void place(const terrain::RideState& on, Pose& pose) {
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
      return {.ramps = {}, .blocks = {}, .surfaces = terrain.surfaces};
    case Setup::kBench:
      break;
  }
  return {};
}

Grounds::Grounds(const Parameters& parameters, const course::Course* course)
    : setup_(parameters.setup),
      steering_(parameters.steering),
      tracks_(track_parameters(parameters)),
      floor_(course == nullptr ? course::Terrain{} : floor_of(course->terrain, setup_),
             parameters.shape),
      world_(course == nullptr ? course::Terrain{} : course->terrain, parameters.shape),
      model_(floor_, parameters.shape),
      odometry_(floor_, parameters.shape),
      fused_(floor_, parameters.shape),
      virtual_(world_, parameters.shape) {}

void Grounds::restart() {
  for (terrain::Ride* ride : {&model_, &odometry_, &fused_, &virtual_}) ride->restart();
  mapped_pitch_rad_.reset();
  shift_ = {};
  shift_told_ = false;
}

double Grounds::way_m(const GroundInput& in, const model::Incline& incline) const {
  return model::body_twist(tracks_, model::Mode::kExtended, in.belts.left_mps, in.belts.right_mps,
                           incline)
             .vx_mps *
         in.dt_s;
}

void Grounds::tell(const GroundTold& told) {
  told_ = told.ride;
  if (!told.shift) return;
  shift_ = *told.shift;
  shift_told_ = true;
}

void Grounds::advance(const GroundInput& in) {
  std::optional<terrain::Attitude> attitude;
  if (real()) attitude = in.imu;
  const auto ride = [&](terrain::Ride& on, const Pose& pose) {
    on.advance(pose, way_m(in, on.state().incline), in.dt_s, attitude);
  };
  ride(model_, in.model);
  ride(odometry_, in.odometry);
  ride(fused_, in.fused);
  if (world_.flat() && !told_) return;
  if (real()) {
    Pose expected = in.steering;
    expected.pitch_rad = mapped_pitch_rad_.value_or(0.0);
    mapped_pitch_rad_ = world_.at(expected).pitch_rad;
    return;
  }
  if (shift_told_) return;
  const double along_m = way_m(in, world_stands().incline);
  if (!told_) virtual_.advance(world(in.steering), along_m, in.dt_s);
  const double ahead_m =
      along_m * world_stands().incline.planar - way_m(in, steering_stands().incline);
  shift_.x_m += ahead_m * std::cos(in.steering.yaw_rad);
  shift_.y_m += ahead_m * std::sin(in.steering.yaw_rad);
}

const terrain::RideState& Grounds::steering_stands() const {
  switch (steering_) {
    case Steering::kModel:
      return model_.state();
    case Steering::kOdometry:
      return odometry_.state();
    case Steering::kFused:
      break;
  }
  return fused_.state();
}

estimation::Ground Grounds::fused() const {
  const terrain::RideState& on = fused_.state();
  return {.planar = on.incline.planar,
          .z_m = on.height_m,
          .roll_rad = on.roll_rad,
          .pitch_rad = on.pitch_rad,
          .slip = model::slip_on(tracks_, model::Mode::kExtended, on.incline),
          .hold_slip = on.climbing};
}

const terrain::RideState& Grounds::world_stands() const {
  if (real()) return steering_stands();
  return told_ ? *told_ : virtual_.state();
}

Pose Grounds::world(const Pose& steering) const {
  Pose pose = shift_.of(steering);
  place(world_stands(), pose);
  return pose;
}

void Grounds::stand(Pose& model, Pose& odometry, Pose& fused) const {
  place(real() ? model_.state() : world_stands(), model);
  place(real() ? odometry_.state() : world_stands(), odometry);
  place(real() ? fused_.state() : world_stands(), fused);
}

Underfoot Grounds::underfoot() const {
  const terrain::RideState& on = world_stands();
  return {.pitch_source = real()  ? PitchSource::kImu
                          : told_ ? PitchSource::kExternal
                                  : PitchSource::kVirtual,
          .obstacle = on.obstacle,
          .climbing = on.climbing,
          .slope_rad = -on.pitch_rad,
          .slip_offset = on.incline.slip_offset};
}

}  // namespace tp100::bridge
