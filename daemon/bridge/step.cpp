#include "bridge/step.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "bridge/grip.h"
#include "bridge/grounds.h"
#include "bridge/live_parameters.h"
#include "bridge/outer_world.h"
#include "bridge/tracks.h"
#include "control/arming.h"
#include "control/belt_limits.h"
#include "control/monitor.h"
#include "control/recovery.h"
#include "control/tracker.h"
#include "core/angle.h"
#include "core/error.h"
#include "estimation/attitude_filter.h"
#include "estimation/obstacle_state.h"
#include "estimation/odometry.h"
#include "estimation/pose_filter.h"
#include "estimation/slope_state.h"
#include "estimation/standstill.h"
#include "model/track_model.h"

namespace tp100::bridge {
namespace {

// Belt speeds over one sample interval are a few edges; control looks at them through this lag.
constexpr double kSpeedLagS = 0.04;
// Nobody saw what happened in a longer gap between two steps: it does not count as having lasted.
constexpr double kLongestSeenS = 0.05;
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

control::Drive drive_of(const Parameters& parameters, double speed_mps) {
  // A pose that knows of no turning centre is not steered by it.
  const bool by_paper = parameters.paper_model && parameters.steering == Steering::kModel;
  return {.speed_mps = speed_mps,
          .slip_angle_rad = parameters.model.slip_angle_straight_rad,
          .tracks = by_paper ? paper_parameters(parameters.model) : track_parameters(parameters),
          .limits = {.wheelbase_m = parameters.model.wheelbase_m,
                     .slip_left = parameters.model.slip_left,
                     .slip_right = parameters.model.slip_right,
                     .max_track_mps = parameters.drive.max_track_mps,
                     .yaw_kp = parameters.drive.yaw_kp,
                     .max_yaw_radps = parameters.drive.max_yaw_radps}};
}

/// First-order lag.
void follow(double& value, double target, double dt_s) {
  value += (target - value) * std::min(1.0, dt_s / kSpeedLagS);
}

}  // namespace

struct Step::State {
  State(const Parameters& p, std::shared_ptr<const course::Course> c)
      : parameters(p),
        course(std::move(c)),
        tracks(p.drive.counts_per_metre, p.model.gyro_scale),
        standstill(p.estimation),
        attitude(p.estimation.attitude),
        slope(p.estimation.attitude),
        leans_on(p.shape.axle_spacing_m),
        grounds(p, course.get()),
        outer(p.world, p.setup),
        track_model(make_model(p)),
        odometry(track_parameters(p)),
        filter(track_parameters(p), p.estimation.filter, p.estimation.camera,
               camera_place(p, course.get())),
        disturbance(p.control) {
    if (course == nullptr) return;
    path.emplace(*course);
    tracker.emplace(p.control, *path, drive_of(p, course->speed_mps));
    monitor.emplace(p.control, course->fence, tracker->nominal_duration_s());
  }

  bool gyro_steers() const { return parameters.setup != Setup::kBench; }
  Pose steering_pose() const;
  const Twist& newest_steering_twist() const;
  void take_attitude(const Interval& step);
  double way_m(const Interval& step) const;
  double heading_rate_radps(double body_z_radps) const;
  void take_grounds(const Interval& step);
  void take_grip(const Interval& step);
  void filter_sample(const Interval& step, double rate_radps);
  void take_sample(const Sample& sample);
  void take_changes(std::span<const ParameterChange> changes);
  void take_requests(std::span<const OperatorRequest> requests);
  void take_world(std::span<const WorldSample> said, double dt_s);
  void heed_stop();
  void begin_run(HostNs now);
  void steer(double dt_s);
  void command(const Inputs& in, HostNs now);
  control::Observation observe(HostNs now, double dt_s) const;
  void publish(HostNs now);

  Parameters parameters;
  std::shared_ptr<const course::Course> course;
  std::optional<course::Path> path;
  Tracks tracks;
  estimation::Standstill standstill;
  estimation::AttitudeFilter attitude;
  estimation::SlopeState slope;
  estimation::ObstacleState leans_on;
  Grounds grounds;
  OuterWorld outer;
  Grip grip;
  model::TrackModel track_model;
  estimation::Odometry odometry;
  estimation::PoseFilter filter;
  std::optional<control::Tracker> tracker;
  std::optional<control::Monitor> monitor;
  control::Disturbance disturbance;
  control::Arming arming;

  Sample sample{};
  bool has_sample = false;
  bool bias_taken = false;
  Interval interval{};
  Twist steering_twist{};
  double left_mps = 0.0, right_mps = 0.0;
  double encoder_rate_radps = 0.0, gyro_rate_radps = 0.0;
  control::Target target{};
  HostNs last_step_ns = 0, run_began_ns = 0;
  std::uint32_t session_number = 0;
  Outputs out{};
};

Step::Step(const Parameters& parameters, std::shared_ptr<const course::Course> course) {
  if (course != nullptr && course->speed_mps > parameters.drive.max_track_mps) {
    throw SetupError("course " + course->name + ": speed_mps " + std::to_string(course->speed_mps) +
                     " is above this robot's drive.max_track_mps " +
                     std::to_string(parameters.drive.max_track_mps) +
                     "; lower the course's speed or use another robot");
  }
  if (parameters.world.owns_pose && parameters.world.kind != WorldKind::kInternal &&
      parameters.setup == Setup::kTerrain) {
    throw SetupError(
        "world.authority = \"world\": on set-up terrain the robot is where it really is; use flat "
        "or bench, or authority = \"bridge\"");
  }
  state_ = std::make_unique<State>(parameters, std::move(course));
}
Step::~Step() = default;
Step::Step(Step&&) noexcept = default;

Pose Step::State::steering_pose() const {
  switch (parameters.steering) {
    case Steering::kModel:
      return track_model.pose();
    case Steering::kOdometry:
      return odometry.pose();
    case Steering::kFused:
      return filter.pose();
  }
  return {};
}

const Twist& Step::State::newest_steering_twist() const {
  switch (parameters.steering) {
    case Steering::kModel:
      return track_model.twist();
    case Steering::kOdometry:
      return odometry.twist();
    case Steering::kFused:
      break;
  }
  return filter.twist();
}

/// By the belts, their usual slip taken off.
double Step::State::way_m(const Interval& step) const {
  return (step.belts.left_mps * (1.0 - parameters.model.slip_left) +
          step.belts.right_mps * (1.0 - parameters.model.slip_right)) /
         2.0 * step.dt_s;
}

void Step::State::take_attitude(const Interval& step) {
  if (sample.imu_age != 0) return;
  const double dt_s = step.dt_s;
  // A robot is put on a level start; later rest may be on a ramp.
  if (standstill.still() && arming.state() != RunState::kRunning)
    attitude.level(sample.gyro_radps, sample.accel_mps2, dt_s);
  attitude.update(sample.gyro_radps, sample.accel_mps2, dt_s);
  slope.update(attitude.pitch_rad(), dt_s);
  leans_on.update(attitude.pitch_rad(), slope.state(), way_m(step));
}

// Where the body leans, its own z axis is not the world's.
double Step::State::heading_rate_radps(double body_z_radps) const {
  const bool leans = parameters.setup == Setup::kTerrain && slope.state() != Slope::kFlat;
  return leans ? attitude.yaw_rate_radps(body_z_radps) : body_z_radps;
}

void Step::State::take_grounds(const Interval& step) {
  grounds.advance({.model = track_model.pose(),
                   .odometry = odometry.pose(),
                   .fused = filter.pose(),
                   .steering = steering_pose(),
                   .belts = step.belts,
                   .dt_s = step.dt_s,
                   .imu = {attitude.roll_rad(), attitude.pitch_rad()}});
}

void Step::State::take_grip(const Interval& step) {
  if (arming.state() != RunState::kRunning) {
    grip.restart();
    return;
  }
  const Underfoot on = grounds.underfoot();
  grip.update({.dt_s = step.dt_s,
               .way_m = way_m(step),
               .fused = filter.pose(),
               .camera = filter.camera_age_s(sample.measured_ns) < kCameraNowS,
               .climbing = on.climbing,
               .mapped_pitch_rad = grounds.mapped_pitch_rad(),
               .measured_pitch_rad = attitude.pitch_rad()});
}

void Step::State::filter_sample(const Interval& step, double rate_radps) {
  filter.advance({.end_ns = sample.measured_ns,
                  .dt_s = step.dt_s,
                  .belts = step.belts,
                  .gyro_z_radps = rate_radps + standstill.bias_radps(),
                  .gyro = gyro_steers() && step.gyro_fresh,
                  .ground = grounds.fused()});
  if (!standstill.still()) return;
  if (bias_taken) {
    filter.rest(tracks.gyro_z_radps(sample), kRestSampleSdRadps);
  } else {
    bias_taken = true;
    filter.rest(standstill.bias_radps(), kRestWindowSdRadps);
  }
}

void Step::State::take_sample(const Sample& next) {
  standstill.update(next, tracks.gyro_z_radps(next));
  const std::optional<Interval> step = tracks.update(next);
  sample = next;
  has_sample = true;
  if (!step) return;
  interval = *step;
  const double dt = step->dt_s;
  take_attitude(*step);
  take_grounds(*step);
  track_model.advance(step->belts.left_mps, step->belts.right_mps, dt, grounds.model());
  const double rate = heading_rate_radps(step->gyro_z_radps - standstill.bias_radps());
  if (gyro_steers() && step->gyro_fresh) {
    odometry.advance(step->belts, rate, dt, grounds.odometry());
  } else {
    odometry.advance_without_gyro(step->belts, dt, grounds.odometry());
  }
  filter_sample(*step, rate);
  take_grip(*step);
  const Twist& steering = newest_steering_twist();
  follow(steering_twist.vx_mps, steering.vx_mps, dt);
  follow(steering_twist.vy_mps, steering.vy_mps, dt);
  follow(steering_twist.yaw_rate_radps, steering.yaw_rate_radps, dt);
  follow(left_mps, step->belts.left_mps, dt);
  follow(right_mps, step->belts.right_mps, dt);
  follow(encoder_rate_radps, track_model.twist().yaw_rate_radps, dt);
  follow(gyro_rate_radps, rate, dt);
}

void Step::State::take_changes(std::span<const ParameterChange> changes) {
  const RunState run = arming.state();
  const bool under_way = run == RunState::kArming || run == RunState::kRunning;
  for (const ParameterChange& change : changes) apply(change, under_way, parameters);
  if (changes.empty()) return;
  grounds.steer_by(parameters.steering);
  if (tracker) tracker->retune(parameters.control);
}

void Step::State::take_requests(std::span<const OperatorRequest> requests) {
  for (const OperatorRequest request : requests) {
    switch (request) {
      case OperatorRequest::kStart:
        arming.start();
        break;
      case OperatorRequest::kHold:
        arming.hold();
        break;
      case OperatorRequest::kStop:
        arming.stop();
        break;
    }
  }
}

void Step::State::take_world(std::span<const WorldSample> said, double dt_s) {
  for (const WorldSample& one : said) outer.take(one);
  outer.wait(std::min(dt_s, kLongestSeenS));
  grounds.tell({outer.ground(), outer.shift()});
}

// After the operator: a start does not get past a world that says stop.
void Step::State::heed_stop() {
  const RunState state = arming.state();
  if (outer.take_stop(state == RunState::kArming || state == RunState::kRunning)) arming.stop();
}

void Step::State::begin_run(HostNs now) {
  track_model.reset(course->start);
  odometry.reset(course->start);
  filter.begin(course->start, now);
  grounds.restart();
  outer.restart(now);
  grip.restart();
  tracker->restart();
  disturbance.restart(filter.recoveries());
  monitor->restart();
  run_began_ns = now;
}

control::Observation Step::State::observe(HostNs now, double dt_s) const {
  const control::BeltLimits limits = drive_of(parameters, 0.0).limits;
  const control::Belts belts = control::belts_for(
      target.speed_mps,
      control::turn_asked(target.heading_error_rad, target.yaw_rate_radps, limits), limits);
  return {.sample = &sample,
          .pose = grounds.world(steering_pose()),
          .left_mps = left_mps,
          .right_mps = right_mps,
          .encoder_yaw_rate_radps = encoder_rate_radps,
          .gyro_yaw_rate_radps = gyro_rate_radps,
          .gyro_in_use = gyro_steers(),
          .immobilised = grip.state() == Traction::kImmobilised || outer.blocked(),
          .target = target,
          .commanded_left_mps = belts.left_mps,
          .commanded_right_mps = belts.right_mps,
          .elapsed_s = to_s(now - run_began_ns),
          .dt_s = std::min(dt_s, kLongestSeenS)};
}

void Step::State::steer(double dt_s) {
  const Pose pose = grounds.world(steering_pose());
  if (arming.state() == RunState::kRunning) {
    const bool disturbed = disturbance.update(
        {.gyro_radps = gyro_steers() ? gyro_rate_radps : 0.0,
         .belts_radps = gyro_steers() ? encoder_rate_radps : 0.0,
         .contradictions = parameters.steering == Steering::kFused ? filter.recoveries() : 0},
        dt_s);
    target = tracker->update(pose, steering_twist, dt_s, disturbed);
    return;
  }
  target.speed_mps = 0.0;
  target.yaw_rate_radps = 0.0;
  target.desired_yaw_rad = pose.yaw_rad;
  target.heading_error_rad = 0.0;
  target.recovering = false;
}

void Step::State::command(const Inputs& in, HostNs now) {
  const std::int64_t age_ns = now - sample.measured_ns;
  out.command_valid = in.session == SessionState::kReady && in.clock.valid && has_sample &&
                      age_ns <= from_s(parameters.max_sample_age_s);
  Command& command = out.command;
  command.answers = sample.sequence;
  command.answered_us = sample.device_us;
  command.pose = steering_pose();
  command.pose.yaw_rad = grounds.world(command.pose).yaw_rad;
  command.desired_yaw_rad = target.desired_yaw_rad;
  command.yaw_rate_radps = target.yaw_rate_radps;
  command.speed_mps = target.speed_mps;
  command.gyro_bias_radps = standstill.bias_radps();
  command.expiry_us = in.clock.valid ? in.clock.to_device(now) +
                                           static_cast<DeviceUs>(parameters.command_life_s * 1e6)
                                     : 0;
}

void Step::State::publish(HostNs now) {
  Snapshot& snapshot = out.snapshot;
  snapshot.now_ns = now;
  snapshot.sample = sample;
  snapshot.has_sample = has_sample;
  snapshot.age_us = (now - sample.measured_ns) / kNsPerUs;
  snapshot.model = track_model.pose();
  snapshot.model_twist = track_model.twist();
  snapshot.odometry = odometry.pose();
  snapshot.odometry_twist = odometry.twist();
  snapshot.fused = filter.fused(now);
  grounds.stand(snapshot.model, snapshot.odometry, snapshot.fused.pose);
  snapshot.world = grounds.world(steering_pose());
  snapshot.underfoot = grounds.underfoot();
  snapshot.underfoot.traction = grip.state();
  snapshot.left_mps = interval.belts.left_mps;
  snapshot.right_mps = interval.belts.right_mps;
  snapshot.slip_left = track_model.slip().left;
  snapshot.slip_right = track_model.slip().right;
  snapshot.gyro_bias_radps = standstill.bias_radps();
  snapshot.imu_roll_rad = attitude.roll_rad();
  snapshot.imu_pitch_rad = attitude.pitch_rad();
  snapshot.imu_slope = slope.state();
  snapshot.imu_obstacle = leans_on.state();
  snapshot.command = out.command;
  snapshot.cross_track_m = target.cross_track_m;
  snapshot.heading_error_rad = target.heading_error_rad;
  snapshot.progress_m = target.progress_m;
  snapshot.recovering = target.recovering;
  snapshot.steering = parameters.steering;
  snapshot.run_state = arming.state();
  snapshot.faults = (has_sample ? sample.faults : 0) | arming.faults();
}

const Outputs& Step::operator()(const Inputs& in, HostNs now) {
  State& s = *state_;
  const double dt_s = s.last_step_ns == 0 ? 0.0 : to_s(now - s.last_step_ns);
  s.last_step_ns = now;

  const bool new_session = in.session_number != s.session_number;
  if (new_session || in.robot_rebooted) {
    s.session_number = in.session_number;
    s.tracks.restart();
    s.standstill.restart();
    s.filter.interrupt();
  }
  if (in.session != SessionState::kReady && in.session != SessionState::kSyncing) {
    s.has_sample = false;
  }
  s.take_world(in.world, dt_s);
  for (const Sample& sample : in.samples) s.take_sample(sample);
  // On a bench the robot that the camera sees stays where it is.
  if (s.parameters.setup != Setup::kBench) {
    for (const CameraSample& seen : in.camera) s.filter.camera(seen);
  }
  s.take_changes(in.changes);
  s.take_requests(in.requests);
  s.heed_stop();

  FaultMask aborts = 0;
  const bool running = s.arming.state() == RunState::kRunning;
  if (running && s.has_sample) {
    aborts = s.monitor->update(s.observe(now, dt_s));
    const double age_s = to_s(now - s.sample.measured_ns);
    // A little late is answered with silence, which the robot bridges; this late is a broken link.
    // Without any sample it is the session that says when the link is lost.
    if (age_s > 0.2 && !in.samples.empty()) aborts |= fault_bit(Fault::samples_stale);
  }
  const bool world_lost = running ? s.outer.lost(now) : !s.outer.fresh(now);
  if (world_lost) aborts |= fault_bit(Fault::world_lost);
  s.out.request = s.arming.update({.session = in.session,
                                   .sample = s.has_sample ? &s.sample : nullptr,
                                   .ready_to_run = s.course != nullptr && !world_lost &&
                                                   (!s.gyro_steers() || s.standstill.bias_known()),
                                   .new_session = new_session,
                                   .rebooted = in.robot_rebooted,
                                   .request_refused = in.request_refused,
                                   .aborts = aborts,
                                   .path_done = running && s.target.done},
                                  dt_s);
  if (s.arming.just_began()) s.begin_run(now);
  s.steer(dt_s);
  s.command(in, now);
  s.publish(now);
  s.outer.remember(now, s.steering_pose());
  return s.out;
}

}  // namespace tp100::bridge
