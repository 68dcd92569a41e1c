#include "bridge/step.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "bridge/external_world.h"
#include "bridge/onward.h"
#include "bridge/parameters.h"
#include "bridge/perception.h"
#include "bridge/witnesses.h"
#include "control/arming.h"
#include "control/hand_drive.h"
#include "control/monitor.h"
#include "control/track_limits.h"
#include "control/tracker.h"
#include "core/arithmetic.h"
#include "core/limits.h"
#include "core/sample.h"
#include "core/start_rule.h"

namespace tp100::bridge {
namespace {

bool same_place(const Pose& one, const Pose& other) {
  return one.x_m == other.x_m && one.y_m == other.y_m && one.yaw_rad == other.yaw_rad;
}

}  // namespace

struct Step::State {
  State(const Parameters& p, std::shared_ptr<const course::Course> c)
      : parameters(p),
        course(std::move(c)),
        perception(parameters, course.get()),
        external(p.world, p.setup),
        witnesses(parameters, perception, external, course != nullptr && course->identifies),
        disturbance(p.control),
        hand_drive(course == nullptr ? std::nullopt : std::optional(course->fence)) {
    if (course != nullptr) {
      path.emplace(*course);
      perception.begin(course->start, 0);
      tracker.emplace(p.control, *path, drive_of(p, course->speed_mps));
    }
    monitor.emplace(p.control, fence_of(course.get()),
                    tracker ? tracker->nominal_duration_s() : 0.0,
                    monitored_robot(p, course.get()));
  }

  void resume(const CarriedState& carried);
  void take_changes(std::span<const ParameterChange> changes);
  // Why a start was refused at once.
  StartRefusal take_requests(std::span<const OperatorRequest> requests);
  void take_world(std::span<const WorldSample> received, double dt_s);
  FaultMask aborts(const StepInputs& in, HostNs now, double dt_s);
  StartRefusal refusal(const StepInputs& in, HostNs now) const;
  std::optional<double> onward_m() const;
  StartPlaces places(const std::optional<double>& onward) const;
  void begin(HostNs now);
  void steer(HostNs now, double dt_s);
  void aim(double desired_yaw_rad, double yaw_rate_radps, double speed_mps);
  void drive_by_hand(HostNs now, double dt_s);
  void command(const StepInputs& in, HostNs now);
  control::Observation observe(HostNs now, double dt_s) const;
  void publish(StartRefusal refusal, HostNs now);

  Parameters parameters;
  std::shared_ptr<const course::Course> course;
  std::optional<course::Path> path;
  Perception perception;
  ExternalWorld external;
  WitnessPoses witnesses;
  std::optional<control::Tracker> tracker;
  std::optional<control::Monitor> monitor;
  control::DisturbanceDetector disturbance;
  control::HandDrive hand_drive;
  control::Arming arming;
  control::Pause pause;

  control::Target target{};
  bool at_fence = false;
  bool moved = false;            // see PlaceFacts
  std::optional<double> from_m;  // where on the path the run that is about to begin goes on
  HostNs last_step_ns = 0, run_began_ns = 0;
  std::uint32_t session_number = 0;
  Outputs out{};
};

Step::Step(const Parameters& parameters, std::shared_ptr<const course::Course> course) {
  require_consistent(parameters, course.get());
  state_ = std::make_unique<State>(parameters, std::move(course));
}
Step::~Step() = default;
Step::Step(Step&&) noexcept = default;
Step& Step::operator=(Step&&) noexcept = default;

double Step::nominal_duration_s() const {
  return state_->tracker ? state_->tracker->nominal_duration_s() : 0.0;
}

bool Step::at_rest() const {
  const State& s = *state_;
  return s.parameters.world.kind == WorldKind::kInternal && s.arming.at_rest() &&
         s.perception.at_rest();
}

CarriedState Step::carried() const {
  const State& s = *state_;
  CarriedState carried;
  carried.session_number = s.session_number;
  carried.run_state = s.arming.state();
  carried.faults = s.arming.faults();
  carried.parameters = live_values(s.parameters);
  carried.cross_track_m = s.target.cross_track_m;
  carried.progress_m = s.target.progress_m;
  carried.moved = s.moved;
  s.perception.carry(carried);
  return carried;
}

bool Step::changeable() const {
  const State& s = *state_;
  return s.parameters.world.kind == WorldKind::kInternal && s.arming.at_rest() &&
         s.perception.at_standstill();
}

CarriedState Step::restart_state(const std::optional<Pose>& at, HostNs now) const {
  CarriedState state = carried();
  if (state.run_state == RunState::kFinished) state.run_state = RunState::kIdle;
  state.cross_track_m = state.progress_m = 0.0;
  // To place it at the start is to say that it stands there.
  if (at) state.moved = state_->course == nullptr || !same_place(*at, state_->course->start);
  state_->perception.level(at, now, state);
  return state;
}

// Tracker, monitor and disturbance detector are not restored: they restart with each run.
void Step::State::resume(const CarriedState& carried) {
  last_step_ns = run_began_ns = 0;
  pause.restart();
  session_number = carried.session_number;
  arming.resume(carried.run_state, carried.faults);
  target = {};
  target.cross_track_m = carried.cross_track_m;
  target.progress_m = carried.progress_m;
  moved = carried.moved;
  perception.resume(carried);
  witnesses.begin();
  take_changes({carried.parameters.begin(), carried.parameters.end()});
}

void Step::State::take_changes(std::span<const ParameterChange> changes) {
  const bool busy = under_way(arming.state());
  for (const ParameterChange& change : changes) apply(change, busy, parameters);
  if (changes.empty()) return;
  perception.steering_changed();
  if (tracker) tracker->retune(parameters.control);
}

StartRefusal Step::State::take_requests(std::span<const OperatorRequest> requests) {
  StartRefusal refused = StartRefusal::kNone;
  for (const OperatorRequest request : requests) {
    switch (request) {
      case OperatorRequest::kStart:
      case OperatorRequest::kStartPlaced:
      case OperatorRequest::kContinue: {
        if (under_way(arming.state())) break;
        const std::optional<double> onward = onward_m();
        refused = path ? refusal_of(places(onward), request) : StartRefusal::kNoCourse;
        if (refused != StartRefusal::kNone) break;
        from_m = request == OperatorRequest::kContinue ? onward : std::nullopt;
        arming.start();
        break;
      }
      case OperatorRequest::kDrive:
        arming.drive();
        break;
      case OperatorRequest::kHold:
        arming.hold();
        break;
      case OperatorRequest::kPause:
        if (arming.state() == RunState::kRunning) pause.begin();
        break;
      case OperatorRequest::kResume:
        pause.end();
        break;
      case OperatorRequest::kStop:
        arming.stop();
        break;
    }
  }
  return refused;
}

std::optional<double> Step::State::onward_m() const {
  if (!path) return std::nullopt;
  return bridge::onward_m(*path, perception.world_pose(), target.progress_m,
                          parameters.control.max_cross_track_m);
}

StartPlaces Step::State::places(const std::optional<double>& onward) const {
  if (!path) return {};
  PlaceFacts facts{.start = course->start,
                   .shown = perception.world_pose(),
                   .seen_now = perception.camera_sees(),
                   .moved = moved || perception.contradictions() > 0,
                   .on_path = onward.has_value()};
  if (perception.camera_known())
    facts.seen = perception.to_world().of(perception.estimate(PoseSource::kFused).pose);
  return start_places(facts);
}

void Step::State::take_world(std::span<const WorldSample> received, double dt_s) {
  for (const WorldSample& one : received) external.take(one);
  external.wait(std::min(dt_s, kLongestSeenS));
  perception.set_external_terrain({external.ground(), external.transform()});
}

FaultMask Step::State::aborts(const StepInputs& in, HostNs now, double dt_s) {
  FaultMask faults = 0;
  const bool running = armed(arming.state());
  if (running && perception.has_sample()) {
    faults = monitor->update(observe(now, dt_s));
    if (!perception.fresh(now))
      faults |= fault_bit(in.samples.empty() ? Fault::link_lost : Fault::samples_stale);
    if (perception.imu_stale()) faults |= fault_bit(Fault::imu_stale);
  }
  if (running ? external.lost(now) : !external.fresh(now)) faults |= fault_bit(Fault::world_lost);
  return faults;
}

StartRefusal Step::State::refusal(const StepInputs& in, HostNs now) const {
  if (in.session != SessionState::kReady) return StartRefusal::kNoSession;
  if (!perception.fresh(now)) return StartRefusal::kNoSample;
  const Sample& sample = perception.sample();
  if (motors_on(sample)) return StartRefusal::kMotorsOn;
  if ((sample.faults & ~kKnownRobotFaults) != 0) return StartRefusal::kUnknownFault;
  if (control::tilted(sample, parameters.control)) return StartRefusal::kTilted;
  if (perception.imu_stale()) return StartRefusal::kNoImu;
  if (perception.gyro_steers() && !perception.gyro_bias_known()) return StartRefusal::kNotStill;
  if (!external.fresh(now)) return StartRefusal::kNoWorld;
  return StartRefusal::kNone;
}

void Step::State::begin(HostNs now) {
  const bool by_hand = arming.state() == RunState::kDriving;
  moved = by_hand || (from_m && moved);
  if (by_hand || from_m) {
    perception.continue_run();
    witnesses.continue_run();
  } else {
    perception.begin(course->start, now);
    witnesses.begin();
    tracker->restart();
  }
  if (by_hand) hand_drive.restart(now);
  if (by_hand) target.progress_m = 0.0;
  if (!by_hand && from_m) tracker->resume(*from_m, perception.world_pose().yaw_rad);
  external.restart(now);
  disturbance.restart(perception.contradictions());
  monitor->restart();
  run_began_ns = now;
  pause.restart();
}

control::Observation Step::State::observe(HostNs now, double dt_s) const {
  const Speeds& speeds = perception.speeds();
  return {.sample = &perception.sample(),
          .pose = perception.world_pose(),
          .left_mps = speeds.tracks.left_mps,
          .right_mps = speeds.tracks.right_mps,
          .encoder_yaw_rate_radps = speeds.encoder_yaw_rate_radps,
          .gyro_yaw_rate_radps = speeds.gyro_yaw_rate_radps,
          .gyro_in_use = perception.gyro_steers(),
          .pitch_rad = perception.pitch_rad(),
          .on_obstacle = perception.on_obstacle(),
          .immobilised = perception.immobilised() || external.blocked(),
          .by_hand = arming.state() == RunState::kDriving,
          .others = witnesses.now(arming.state() == RunState::kRunning ? &*tracker : nullptr),
          .recoveries = perception.contradictions(),
          .commanded = out.command_valid,
          .target = target,
          .commanded_left_mps = out.snapshot.commanded_left_mps,
          .commanded_right_mps = out.snapshot.commanded_right_mps,
          .elapsed_s = to_s(now - run_began_ns) - pause.total_s(),
          .dt_s = std::min(dt_s, kLongestSeenS)};
}

// Sets the target of a step without a path.
void Step::State::aim(double desired_yaw_rad, double yaw_rate_radps, double speed_mps) {
  target.speed_mps = speed_mps;
  target.yaw_rate_radps = yaw_rate_radps;
  target.desired_yaw_rad = desired_yaw_rad;
  target.heading_error_rad = desired_yaw_rad - perception.world_pose().yaw_rad;
  target.recovering = false;
}

void Step::State::drive_by_hand(HostNs now, double dt_s) {
  const Pose pose = perception.world_pose();
  const control::HandCommand wanted =
      hand_drive.update({.pose = pose,
                         .measured_yaw_rate_radps = perception.speeds().steering.yaw_rate_radps,
                         .position_sd_m = perception.steering_sd_m(),
                         .limits = drive_of(parameters, 0.0).limits,
                         .braking_mps2 = parameters.drive.max_track_mps2,
                         .others = witnesses.now(nullptr)},
                        parameters.control, now, std::min(dt_s, kLongestSeenS));
  aim(wanted.desired_yaw_rad, wanted.yaw_rate_radps, wanted.speed_mps);
  at_fence = wanted.at_fence;
}

void Step::State::steer(HostNs now, double dt_s) {
  at_fence = false;
  if (arming.state() == RunState::kDriving) return drive_by_hand(now, dt_s);
  const Pose pose = perception.world_pose();
  if (arming.state() == RunState::kRunning) {
    const Speeds& speeds = perception.speeds();
    const bool gyro = perception.gyro_steers();
    const bool disturbed = disturbance.update(
        {.gyro_radps = gyro ? speeds.gyro_yaw_rate_radps : 0.0,
         .tracks_radps = gyro ? speeds.encoder_yaw_rate_radps : 0.0,
         .contradictions =
             parameters.steering == PoseSource::kFused ? perception.contradictions() : 0},
        dt_s);
    tracker->pause(pause.active());
    target = tracker->update(pose, speeds.steering, dt_s, disturbed);
    return;
  }
  aim(pose.yaw_rad, 0.0, 0.0);
}

void Step::State::command(const StepInputs& in, HostNs now) {
  const Sample& sample = perception.sample();
  const std::int64_t age_ns = now - sample.measured_ns;
  out.command_valid = in.session == SessionState::kReady && in.clock.valid &&
                      perception.has_sample() && age_ns <= from_s(parameters.max_sample_age_s);
  Command& command = out.command;
  command.answers = sample.sequence;
  command.answered_us = sample.device_us;
  command.pose = perception.steering_pose();
  // The desired yaw is in the course's world, so the yaw that the robot compares must be, too.
  command.pose.yaw_rad = perception.world_pose().yaw_rad;
  command.desired_yaw_rad = target.desired_yaw_rad;
  command.yaw_rate_radps = target.yaw_rate_radps;
  command.speed_mps = target.speed_mps;
  command.gyro_bias_radps = perception.gyro_bias_radps();
  command.expiry_us = in.clock.valid ? in.clock.to_device(now) +
                                           static_cast<DeviceUs>(parameters.command_life_s * 1e6)
                                     : 0;
}

void Step::State::publish(StartRefusal refusal, HostNs now) {
  Snapshot& snapshot = out.snapshot;
  snapshot.now_ns = now;
  perception.write(snapshot, now);
  snapshot.command = out.command;
  const control::TrackLimits limits = drive_of(parameters, 0.0).limits;
  const auto commanded = control::skid_steer(limits).tracks_for(
      target.speed_mps,
      control::turn_asked(target.heading_error_rad, target.yaw_rate_radps, limits));
  snapshot.commanded_left_mps = commanded.left;
  snapshot.commanded_right_mps = commanded.right;
  snapshot.cross_track_m = target.cross_track_m;
  snapshot.heading_error_rad = target.heading_error_rad;
  snapshot.progress_m = target.progress_m;
  snapshot.recovering = target.recovering;
  snapshot.steering = parameters.steering;
  snapshot.run_state = arming.state();
  snapshot.drive_refusal = snapshot.run_state == RunState::kDriving ? StartRefusal::kDriven
                           : under_way(snapshot.run_state)          ? StartRefusal::kUnderWay
                                                                    : refusal;
  snapshot.start_refusal = course == nullptr ? StartRefusal::kNoCourse : snapshot.drive_refusal;
  snapshot.start_places = {};
  snapshot.onward_m = 0.0;
  if (!under_way(snapshot.run_state)) {
    const std::optional<double> onward = onward_m();
    snapshot.start_places = places(onward);
    snapshot.onward_m = onward.value_or(0.0);
  }
  snapshot.at_fence = at_fence;
  snapshot.pause_left_s = snapshot.run_state == RunState::kRunning ? pause.left_s() : 0.0;
  snapshot.faults = (perception.has_sample() ? perception.sample().faults : 0) | arming.faults();
}

const Outputs& Step::operator()(const StepInputs& in, HostNs now) {
  State& s = *state_;
  for (const CarriedState& carried : in.restart) s.resume(carried);
  const double dt_s = s.last_step_ns == 0 ? 0.0 : to_s(now - s.last_step_ns);
  s.last_step_ns = now;

  const bool new_session = in.session_number != s.session_number;
  if (new_session || in.robot_rebooted) {
    s.session_number = in.session_number;
    s.perception.restart();
  }
  if (in.session != SessionState::kReady && in.session != SessionState::kSyncing) {
    s.perception.lose_sample();
  }
  s.take_world(in.world, dt_s);
  for (const Sample& sample : in.samples) s.perception.take(sample, armed(s.arming.state()));
  for (const CameraSample& sample : in.camera) s.perception.take(sample);
  s.take_changes(in.changes);
  const StartRefusal refused = s.take_requests(in.requests);
  if (s.pause.update(dt_s) && s.arming.state() == RunState::kRunning) s.arming.hold();
  // After the operator's requests, so that a start does not override a world that requests a stop.
  if (s.external.take_stop(under_way(s.arming.state()))) s.arming.stop();
  for (const VelocityInput& input : in.velocities) s.hand_drive.take(input, now);

  s.witnesses.advance(std::min(dt_s, kLongestSeenS));
  const FaultMask aborts = s.aborts(in, now, dt_s);
  const StartRefusal refusal = s.refusal(in, now);
  s.out.request = s.arming.update(
      {.session = in.session,
       .sample = s.perception.fresh(now) ? &s.perception.sample() : nullptr,
       .refusal = refusal,
       .new_session = new_session,
       .rebooted = in.robot_rebooted,
       .answer = in.answer,
       .aborts = aborts,
       .done = s.arming.state() == RunState::kDriving ? s.hand_drive.silent(now)
                                                      : armed(s.arming.state()) && s.target.done},
      dt_s);
  s.out.refused = refused != StartRefusal::kNone ? refused : s.arming.refused();
  s.out.waits_for = refusal;
  s.out.disarming = s.arming.disarming();
  if (s.arming.just_began()) s.begin(now);
  s.steer(now, dt_s);
  s.command(in, now);
  s.publish(refusal, now);
  s.external.remember(now, s.perception.steering_pose());
  return s.out;
}

}  // namespace tp100::bridge
