#include "bridge/perception.h"

#include <algorithm>
#include <optional>

namespace tp100::bridge {
namespace {

constexpr double kSpeedLagS = 0.04;
// A camera that was used this recently sees the robot.
constexpr double kCameraNowS = 0.15;

// Noise of the gyro at rest: of one sample, and of the mean over the first still window with what
// the warm-up adds.
constexpr double kRestSampleSdRadps = 0.003;
constexpr double kRestWindowSdRadps = 0.0005;

model::TrackModel make_model(const Parameters& parameters) {
  if (parameters.paper_model) return {paper_parameters(parameters.model), model::Mode::kPaper};
  return {track_parameters(parameters), model::Mode::kExtended};
}

/// The camera hangs near the middle of the fence.
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

Perception::Perception(const Parameters& parameters, const course::Course* course)
    : parameters_(parameters),
      tracks_(parameters.drive.counts_per_metre, parameters.model.gyro_scale),
      standstill_(parameters.estimation),
      attitude_(parameters.estimation.attitude),
      slope_(parameters.estimation.attitude),
      leans_on_(parameters.shape.axle_spacing_m),
      grounds_(parameters, course),
      track_model_(make_model(parameters)),
      odometry_(track_parameters(parameters)),
      filter_(track_parameters(parameters), parameters.estimation.filter,
              parameters.estimation.camera, camera_place(parameters, course)) {}

void Perception::restart() {
  tracks_.restart();
  standstill_.restart();
  filter_.interrupt();
}

void Perception::begin(const Pose& start, HostNs now) {
  track_model_.reset(start);
  odometry_.reset(start);
  filter_.begin(start, now);
  grounds_.restart();
  grip_.restart();
}

void Perception::take(const Sample& next, bool running) {
  standstill_.update(next, tracks_.gyro_z_radps(next));
  const std::optional<Interval> step = tracks_.update(next);
  sample_ = next;
  has_sample_ = true;
  if (!step) return;
  interval_ = *step;
  update_attitude(running);
  update_grounds();
  const double dt_s = interval_.dt_s;
  track_model_.advance(interval_.belts.left_mps, interval_.belts.right_mps, dt_s, grounds_.model());
  const double rate = heading_rate_radps();
  if (gyro_steers() && interval_.gyro_fresh) {
    odometry_.advance(interval_.belts, rate, dt_s, grounds_.odometry());
  } else {
    odometry_.advance_without_gyro(interval_.belts, dt_s, grounds_.odometry());
  }
  update_filter(rate);
  update_grip(running);
  update_speeds(rate);
}

void Perception::take(const CameraSample& seen) {
  if (parameters_.setup != Setup::kBench) filter_.camera(seen);
}

Pose Perception::steering_pose() const {
  switch (parameters_.steering) {
    case Steering::kModel:
      return track_model_.pose();
    case Steering::kOdometry:
      return odometry_.pose();
    case Steering::kFused:
      return filter_.pose();
  }
  return {};
}

const Twist& Perception::steering_twist() const {
  switch (parameters_.steering) {
    case Steering::kModel:
      return track_model_.twist();
    case Steering::kOdometry:
      return odometry_.twist();
    case Steering::kFused:
      break;
  }
  return filter_.twist();
}

/// By the belts, their usual slip taken off.
double Perception::way_m() const {
  return (interval_.belts.left_mps * (1.0 - parameters_.model.slip_left) +
          interval_.belts.right_mps * (1.0 - parameters_.model.slip_right)) /
         2.0 * interval_.dt_s;
}

// Where the body leans, its own z axis is not the world's.
double Perception::heading_rate_radps() const {
  const double body_z_radps = interval_.gyro_z_radps - standstill_.bias_radps();
  const bool leans = parameters_.setup == Setup::kTerrain && slope_.state() != Slope::kFlat;
  return leans ? attitude_.yaw_rate_radps(body_z_radps) : body_z_radps;
}

// Steered by the paper's constants, a robot still turns by its own.
double Perception::encoder_yaw_rate_radps() const {
  if (!parameters_.paper_model) return track_model_.twist().yaw_rate_radps;
  return model::body_twist(track_parameters(parameters_), model::Mode::kExtended,
                           interval_.belts.left_mps, interval_.belts.right_mps)
      .yaw_rate_radps;
}

bool Perception::on_obstacle() const {
  if (parameters_.setup != Setup::kTerrain) return false;
  const Underfoot under = grounds_.underfoot();
  return under.climbing || under.obstacle != Obstacle::kNone;
}

void Perception::update_attitude(bool running) {
  if (sample_.imu_age != 0) return;
  const double dt_s = interval_.dt_s;
  // A robot is put on a level start; later rest may be on a ramp.
  if (standstill_.still() && !running)
    attitude_.level(sample_.gyro_radps, sample_.accel_mps2, dt_s);
  attitude_.update(sample_.gyro_radps, sample_.accel_mps2, dt_s);
  slope_.update(attitude_.pitch_rad(), dt_s);
  leans_on_.update(attitude_.pitch_rad(), slope_.state(), way_m());
}

void Perception::update_grounds() {
  grounds_.advance({.model = track_model_.pose(),
                    .odometry = odometry_.pose(),
                    .fused = filter_.pose(),
                    .steering = steering_pose(),
                    .belts = interval_.belts,
                    .dt_s = interval_.dt_s,
                    .imu = {attitude_.roll_rad(), attitude_.pitch_rad()}});
}

void Perception::update_filter(double rate_radps) {
  filter_.advance({.end_ns = sample_.measured_ns,
                   .dt_s = interval_.dt_s,
                   .belts = interval_.belts,
                   .gyro_z_radps = rate_radps + standstill_.bias_radps(),
                   .gyro = gyro_steers() && interval_.gyro_fresh,
                   .ground = grounds_.fused()});
  if (!standstill_.still()) return;
  if (bias_taken_) {
    filter_.rest(tracks_.gyro_z_radps(sample_), kRestSampleSdRadps);
  } else {
    bias_taken_ = true;
    filter_.rest(standstill_.bias_radps(), kRestWindowSdRadps);
  }
}

void Perception::update_grip(bool running) {
  if (!running) {
    grip_.restart();
    return;
  }
  grip_.update({.dt_s = interval_.dt_s,
                .way_m = way_m(),
                .fused = filter_.pose(),
                .camera = filter_.camera_age_s(sample_.measured_ns) < kCameraNowS,
                .climbing = grounds_.underfoot().climbing,
                .mapped_pitch_rad = grounds_.mapped_pitch_rad(),
                .measured_pitch_rad = attitude_.pitch_rad()});
}

void Perception::update_speeds(double rate_radps) {
  const double share = std::min(1.0, interval_.dt_s / kSpeedLagS);
  const auto follow = [share](double& value, double target) { value += (target - value) * share; };
  const Twist& steering = steering_twist();
  follow(speeds_.steering.vx_mps, steering.vx_mps);
  follow(speeds_.steering.vy_mps, steering.vy_mps);
  follow(speeds_.steering.yaw_rate_radps, steering.yaw_rate_radps);
  follow(speeds_.belts.left_mps, interval_.belts.left_mps);
  follow(speeds_.belts.right_mps, interval_.belts.right_mps);
  follow(speeds_.encoder_yaw_rate_radps, encoder_yaw_rate_radps());
  follow(speeds_.gyro_yaw_rate_radps, rate_radps);
}

void Perception::write(Snapshot& snapshot, HostNs now) const {
  snapshot.sample = sample_;
  snapshot.has_sample = has_sample_;
  snapshot.age_us = (now - sample_.measured_ns) / kNsPerUs;
  snapshot.model = track_model_.pose();
  snapshot.model_twist = track_model_.twist();
  snapshot.odometry = odometry_.pose();
  snapshot.odometry_twist = odometry_.twist();
  snapshot.fused = filter_.fused(now);
  grounds_.stand(snapshot.model, snapshot.odometry, snapshot.fused.pose);
  snapshot.world = world_pose();
  snapshot.underfoot = grounds_.underfoot();
  snapshot.underfoot.traction = grip_.state();
  snapshot.left_mps = interval_.belts.left_mps;
  snapshot.right_mps = interval_.belts.right_mps;
  snapshot.slip_left = track_model_.slip().left;
  snapshot.slip_right = track_model_.slip().right;
  snapshot.gyro_bias_radps = standstill_.bias_radps();
  snapshot.imu_roll_rad = attitude_.roll_rad();
  snapshot.imu_pitch_rad = attitude_.pitch_rad();
  snapshot.imu_slope = slope_.state();
  snapshot.imu_obstacle = leans_on_.state();
}

}  // namespace tp100::bridge
