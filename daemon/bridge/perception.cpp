#include "bridge/perception.h"

#include <algorithm>
#include <optional>

namespace tp100::bridge {
namespace {

constexpr double kSpeedLagS = 0.04;
// The camera counts as seeing the robot for this long after its last accepted sample.
constexpr double kCameraNowS = 0.15;

model::TrackModel make_model(const Parameters& parameters) {
  if (parameters.paper_model) return {paper_parameters(parameters.model), model::Mode::kPaper};
  return {parameters.model, model::Mode::kExtended};
}

/// The point below the lens: the middle of the fence, plus the configured offset.
estimation::CameraPlace camera_place(const Parameters& parameters, const course::Course* course) {
  estimation::CameraPlace place{parameters.estimation.camera.offset_x_m,
                                parameters.estimation.camera.offset_y_m};
  if (course != nullptr) {
    place.x_m += (course->fence.min_x_m + course->fence.max_x_m) / 2.0;
    place.y_m += (course->fence.min_y_m + course->fence.max_y_m) / 2.0;
  }
  return place;
}

}  // namespace

std::optional<Interval> SampleIntervals::update(const Sample& sample) {
  if (!has_last_) {
    has_last_ = true;
    last_ = sample;
    return std::nullopt;
  }
  if (sample.device_us <= last_.device_us) return std::nullopt;
  Interval interval;
  interval.dt_s = static_cast<double>(sample.device_us - last_.device_us) * 1e-6;
  const auto speed = [&](std::int64_t counts) {
    return static_cast<double>(counts) * metres_per_count_ / interval.dt_s;
  };
  interval.tracks.left_mps = speed(sample.left_counts - last_.left_counts);
  interval.tracks.right_mps = speed(sample.right_counts - last_.right_counts);
  interval.gyro_z_radps = (gyro_z_radps(sample) + gyro_z_radps(last_)) / 2.0;
  interval.gyro_fresh = sample.imu_age == 0 && last_.imu_age == 0;
  interval.warming_degc = sample.temperature_degc - last_.temperature_degc;
  last_ = sample;
  return interval;
}

Perception::Perception(const Parameters& parameters, const course::Course* course)
    : parameters_(parameters),
      intervals_(parameters.drive.counts_per_metre, parameters.model.gyro_scale),
      standstill_(parameters.estimation),
      obstacle_class_(parameters.shape.axle_spacing_m),
      terrain_contacts_(parameters, course),
      track_model_(make_model(parameters)),
      model_covariance_(parameters.model, filter_noise(parameters)),
      odometry_(parameters.model, filter_noise(parameters)),
      filter_(parameters.model, filter_noise(parameters), parameters.estimation.camera,
              camera_place(parameters, course)) {}

void Perception::restart() {
  intervals_.restart();
  standstill_.restart();
  model_covariance_.interrupt();
  odometry_.interrupt();
  filter_.interrupt();
}

void Perception::begin(const Pose& start, HostNs now) {
  track_model_.begin(start);
  model_covariance_.begin();
  odometry_.begin(start);
  filter_.begin(start, now);
  terrain_contacts_.restart();
  traction_estimator_.restart();
}

bool Perception::at_rest() const {
  return at_standstill() && slope_.state() == Slope::kFlat &&
         obstacle_class_.state() == ObstacleClass::kNone && terrain_contacts_.level();
}

void Perception::carry(CarriedState& state) const {
  state.sample = sample_;
  state.has_sample = has_sample_;
  state.continues = intervals_.has_last();
  state.model = track_model_.pose();
  state.model_covariance = model_covariance_.carried();
  state.odometry = odometry_.carried();
  const Transform2d& transform = terrain_contacts_.transform();
  state.virtual_x_m = transform.x_m;
  state.virtual_y_m = transform.y_m;
  state.virtual_turn_rad = transform.turn_rad;
  state.filter = filter_.carried();
  state.attitude = attitude_.carried();
  state.gyro_bias_radps = standstill_.bias_radps();
  state.gyro_bias_known = standstill_.bias_known();
}

void Perception::level(const std::optional<Pose>& at, HostNs now, CarriedState& state) const {
  state.virtual_x_m = state.virtual_y_m = state.virtual_turn_rad = 0.0;
  state.model.z_m = state.model.roll_rad = state.model.pitch_rad = 0.0;
  if (!at) return;
  state.model = {.x_m = at->x_m, .y_m = at->y_m, .yaw_rad = at->yaw_rad};
  state.model_covariance = model_covariance_.carried_from_start();
  state.odometry = odometry_.carried_from(state.model);
  state.filter = filter_.carried_from(state.model, now);
}

void Perception::resume(const CarriedState& state) {
  intervals_.restart();
  if (state.continues) intervals_.resume(state.sample);
  standstill_.resume(state.gyro_bias_radps, state.gyro_bias_known);
  attitude_.resume(state.attitude);
  slope_ = {};
  obstacle_class_.restart();
  terrain_contacts_.resume({state.virtual_x_m, state.virtual_y_m, state.virtual_turn_rad});
  traction_estimator_.restart();
  track_model_ = make_model(parameters_);
  track_model_.begin(state.model);
  model_covariance_.resume(state.model_covariance);
  odometry_.resume(state.odometry);
  filter_.resume(state.filter);
  sample_ = state.sample;
  has_sample_ = state.has_sample;
  interval_ = {};
  speeds_ = {};
}

void Perception::take(const Sample& next, bool running) {
  standstill_.update(next, intervals_.gyro_z_radps(next));
  const std::optional<Interval> step = intervals_.update(next);
  sample_ = next;
  has_sample_ = true;
  if (!step) return;
  interval_ = *step;
  update_attitude(running);
  update_terrain_contacts();
  const Pose before = track_model_.pose();
  track_model_.advance(interval_.tracks.left_mps, interval_.tracks.right_mps, interval_.dt_s,
                       terrain_contacts_.incline(PoseSource::kModel));
  const double rate = heading_rate_radps();
  update_estimates(rate);
  model_covariance_.advance(before, track_model_.pose(), odometry_.motion(),
                            odometry_.slip_variance());
  update_traction(running);
  update_speeds(rate);
}

void Perception::take(const CameraSample& seen) {
  if (parameters_.setup != Setup::kStand) filter_.camera(seen);
}

Estimate Perception::estimate(PoseSource source) const {
  switch (source) {
    case PoseSource::kModel:
      return {track_model_.pose(), track_model_.twist(), model_covariance_.pose()};
    case PoseSource::kOdometry:
      return {odometry_.pose(), odometry_.twist(), odometry_.pose_covariance()};
    case PoseSource::kFused:
      break;
  }
  return {filter_.pose(), filter_.twist(), filter_.pose_covariance()};
}

PerSource<Estimate> Perception::estimates() const {
  PerSource<Estimate> all;
  for (const PoseSource source : kPoseSources) all[source] = estimate(source);
  return all;
}

/// Distance by the tracks, their usual slip subtracted.
double Perception::distance_m() const {
  const auto [left, right] = model::over_ground(
      interval_.tracks, {parameters_.model.slip_left, parameters_.model.slip_right});
  return (left + right) / 2.0 * interval_.dt_s;
}

// Where the body is tilted, its own z axis is not the world's.
double Perception::heading_rate_radps() const {
  const double body_z_radps = interval_.gyro_z_radps - standstill_.bias_radps();
  const bool tilted = parameters_.setup == Setup::kTerrain && slope_.state() != Slope::kFlat;
  return tilted ? attitude_.yaw_rate_radps(body_z_radps) : body_z_radps;
}

// Even if the model runs with the paper's constants, the real robot turns according to its own.
double Perception::encoder_yaw_rate_radps() const {
  if (!parameters_.paper_model) return track_model_.twist().yaw_rate_radps;
  return model::body_twist(parameters_.model, model::Mode::kExtended, interval_.tracks.left_mps,
                           interval_.tracks.right_mps)
      .yaw_rate_radps;
}

bool Perception::camera_sees() const {
  return filter_.camera_age_s(sample_.measured_ns) < kCameraNowS;
}

bool Perception::on_obstacle() const {
  if (parameters_.setup != Setup::kTerrain) return false;
  const TerrainContact under = terrain_contacts_.terrain_contact();
  return under.climbing || under.obstacle != ObstacleClass::kNone;
}

void Perception::update_attitude(bool running) {
  if (sample_.imu_age != 0) return;
  const double dt_s = interval_.dt_s;
  // A robot is placed on a level start; a later standstill may be on a ramp.
  if (standstill_.still() && !running)
    attitude_.level(sample_.gyro_radps, sample_.accel_mps2, dt_s);
  attitude_.update(sample_.gyro_radps, sample_.accel_mps2, dt_s);
  slope_.update(attitude_.pitch_rad(), dt_s);
  obstacle_class_.update(attitude_.pitch_rad(), slope_.state(), distance_m());
}

void Perception::update_terrain_contacts() {
  terrain_contacts_.advance({.estimates = estimates(),
                             .tracks = interval_.tracks,
                             .dt_s = interval_.dt_s,
                             .imu = {attitude_.roll_rad(), attitude_.pitch_rad()}});
}

void Perception::update_estimates(double rate_radps) {
  estimation::FilterInput in{.end_ns = sample_.measured_ns,
                             .dt_s = interval_.dt_s,
                             .tracks = interval_.tracks,
                             .gyro_z_radps = rate_radps + standstill_.bias_radps(),
                             .gyro = gyro_steers() && interval_.gyro_fresh,
                             .warming_degc = interval_.warming_degc,
                             .ground = terrain_contacts_.ground(PoseSource::kOdometry)};
  odometry_.advance(in);
  in.ground = terrain_contacts_.ground(PoseSource::kFused);
  filter_.advance(in);
  if (!standstill_.rest()) return;
  odometry_.standstill(*standstill_.rest());
  filter_.standstill(*standstill_.rest());
}

void Perception::update_traction(bool running) {
  if (!running) {
    traction_estimator_.restart();
    return;
  }
  traction_estimator_.update({.dt_s = interval_.dt_s,
                              .distance_m = distance_m(),
                              .fused = filter_.pose(),
                              .camera = camera_sees(),
                              .climbing = terrain_contacts_.terrain_contact().climbing,
                              .mapped_pitch_rad = terrain_contacts_.mapped_pitch_rad(),
                              .measured_pitch_rad = attitude_.pitch_rad()});
}

void Perception::update_speeds(double rate_radps) {
  const double share = std::min(1.0, interval_.dt_s / kSpeedLagS);
  const auto follow = [share](double& value, double target) { value += (target - value) * share; };
  const Twist steering = estimate(parameters_.steering).twist;
  follow(speeds_.steering.vx_mps, steering.vx_mps);
  follow(speeds_.steering.vy_mps, steering.vy_mps);
  follow(speeds_.steering.yaw_rate_radps, steering.yaw_rate_radps);
  follow(speeds_.tracks.left_mps, interval_.tracks.left_mps);
  follow(speeds_.tracks.right_mps, interval_.tracks.right_mps);
  follow(speeds_.encoder_yaw_rate_radps, encoder_yaw_rate_radps());
  follow(speeds_.gyro_yaw_rate_radps, rate_radps);
}

void Perception::write(Snapshot& snapshot, HostNs now) const {
  snapshot.sample = sample_;
  snapshot.has_sample = has_sample_;
  snapshot.age_us = (now - sample_.measured_ns) / kNsPerUs;
  snapshot.estimates = estimates();
  snapshot.odometry_twist_covariance = odometry_.twist_covariance();
  snapshot.filter = filter_.figures(now);
  terrain_contacts_.set_attitude(snapshot.estimates);
  snapshot.world = world_pose();
  snapshot.terrain_contact = terrain_contacts_.terrain_contact();
  snapshot.terrain_contact.traction = traction_estimator_.state();
  snapshot.left_mps = interval_.tracks.left_mps;
  snapshot.right_mps = interval_.tracks.right_mps;
  snapshot.slip_left = track_model_.slip().left;
  snapshot.slip_right = track_model_.slip().right;
  snapshot.gyro_bias_radps = standstill_.bias_radps();
  snapshot.imu_roll_rad = attitude_.roll_rad();
  snapshot.imu_pitch_rad = attitude_.pitch_rad();
  snapshot.imu_slope = slope_.state();
  snapshot.imu_obstacle = obstacle_class_.state();
}

}  // namespace tp100::bridge
