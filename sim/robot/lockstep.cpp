#include "sim/robot/lockstep.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bridge/cycle.h"
#include "bridge/external_world.h"
#include "bridge/terrain_contacts.h"
#include "core/error.h"
#include "core/faults.h"
#include "core/time.h"
#include "sim/robot/emulated_robot.h"
#include "sim/robot/options.h"
#include "sim/robot/truth_history.h"
#include "sim/robot/world_client.h"
#include "sim/sensors/overhead_camera.h"
#include "terrain/climbable.h"

namespace tp100::sim {
namespace {

using Clock = std::chrono::steady_clock;

// The robot stands still this long before the host opens the port.
constexpr HostNs kOpenNs = 20 * kNsPerMs;
constexpr double kStandstillS = 0.5;
constexpr HostNs kOldestTruthNs = 200 * kNsPerMs;

class Lockstep {
 public:
  explicit Lockstep(const LockstepSettings& settings);
  /// Power on, port open.
  void open();
  /// One run, from its start to half a second after its end.
  report::RunResult run();
  /// Holds the robot until `from_opening_s` after open(), then takes it back to the start.
  void stand_still_until(double from_opening_s);

 private:
  void turn();
  void judge(RunState state, HostNs end_ns);
  void count(std::chrono::duration<double> wall);
  void advance_robot();
  void step_host();
  void show(CameraSample seen);
  void look();
  void deliver();
  void cable();
  void push();
  void record(const Snapshot& snapshot);
  void publish();
  /// The robot's true pose, seen from where it was put down for this run.
  Pose truth_at(HostNs at_ns) const { return put_back_.of(truth_.find(at_ns)); }
  Pose truth_now() const { return put_back_.of(robot_.truth().pose); }
  bool plugged() const { return robot_.now_ns() >= plugged_ns_; }
  bool stand() const { return settings_.setup == bridge::Setup::kStand; }

  LockstepSettings settings_;
  bridge::Parameters parameters_;
  course::Path path_;
  bridge::Cycle cycle_;
  EmulatedRobot robot_;
  std::optional<OverheadCamera> camera_;
  std::size_t delivered_ = 0;  ///< number of the settings' detections delivered
  std::optional<WorldClient> world_;
  TruthHistory truth_;
  report::MeasuredMotion measured_;
  StepRecord record_{};
  std::vector<std::uint8_t> arriving_;
  HostNs plugged_ns_ = 0;     ///< the port is unplugged until then
  HostNs host_awake_ns_ = 0;  ///< the host is stalled until then
  report::RunResult result_{};
  HostNs period_ns_;
  Transform2d behind_{};    ///< from the real robot to the virtual one
  Transform2d put_back_{};  ///< from where the robot stands to the start of the course
  HostNs opened_ns_ = 0;
  HostNs next_step_ns_ = 0;
  HostNs begin_ns_ = -1;
  std::int64_t last_recorded_us_ = -1;
  DisturbanceInjector disturbance_injector_;
  std::uint64_t steps_ = 0;
  std::chrono::nanoseconds step_time_{0};
  std::chrono::nanoseconds longest_step_{0};
};

bridge::Parameters parameters_of(const LockstepSettings& settings) {
  bridge::Parameters parameters = config::bridge_parameters(settings.configuration, settings.robot);
  parameters.setup = settings.setup;
  parameters.world.kind = settings.external_world || settings.world ? bridge::WorldKind::kUdp
                                                                    : bridge::WorldKind::kInternal;
  return parameters;
}

bridge::Parameters host_parameters(const LockstepSettings& settings) {
  bridge::Parameters parameters = parameters_of(settings);
  if (!settings.host_checks_encoders) {
    parameters.drive.feed_forward = 0.0;
    parameters.control.turn_slip_share = 1.0;
  }
  return parameters;
}

Lockstep::Lockstep(const LockstepSettings& settings)
    : settings_(settings),
      parameters_(parameters_of(settings)),
      path_(settings.course),
      cycle_(bridge::session_settings(parameters_, &settings.course), host_parameters(settings),
             std::make_shared<const course::Course>(settings.course)),
      robot_({.values = settings.robot.emulated,
              .start = settings.course.start,
              .on_stand = settings.setup == bridge::Setup::kStand,
              .terrain = bridge::floor_of(settings.course.terrain, settings.setup),
              .seed = settings.seed,
              .board = settings.board,
              .start_us = settings.start_us,
              .faults = settings.faults}),
      period_ns_(static_cast<std::int64_t>(std::lround(1e3 / settings.configuration.loop.rate_hz)) *
                 kNsPerMs),
      disturbance_injector_(settings.course.disturbances) {
  terrain::require_climbable(settings.course, settings.robot);
  if (period_ns_ < kPhysicsStepNs) period_ns_ = kPhysicsStepNs;
  result_.has_camera = settings.camera || !settings.detections.empty();
  if (result_.has_camera && stand())
    throw UserError("--camera: on a stand it would see a robot that stands still; leave it out");
  if (settings.camera) {
    const course::Fence& fence = settings.course.fence;
    camera_.emplace(*settings.camera, (fence.min_x_m + fence.max_x_m) / 2.0,
                    (fence.min_y_m + fence.max_y_m) / 2.0, settings.seed);
  }
  if (settings.external_world) {
    config::RunSetup run{.configuration = settings.configuration,
                         .robot = settings.robot,
                         .course = std::make_shared<const course::Course>(settings.course),
                         .parameters = parameters_};
    world_.emplace(config::world_run(run), static_cast<std::uint32_t>(settings.seed));
  }
  result_.course = settings.course.name;
  result_.board = to_string(settings.board);
  result_.body = to_string(settings.robot.emulated.contact_law);
  result_.floor = to_string(settings.robot.emulated.floor);
  result_.robot = settings.robot.name;
  result_.setup = bridge::to_string(settings.setup);
  result_.seed = settings.seed;
  result_.baselines =
      report::baselines_of(settings.robot, parameters_.model.turning_threshold_radps);
}

void Lockstep::advance_robot() {
  for (const TimedByte& byte : robot_.advance()) {
    if (!plugged()) continue;
    arriving_.push_back(byte.value);
    // Like the live loop, which wakes up for bytes: a frame gets the time stamp of its end.
    if (byte.value != wire::kDelimiter) continue;
    cycle_.session().receive(arriving_, byte.at_ns);
    arriving_.clear();
  }
  truth_.add(robot_.now_ns(), robot_.truth().pose);
  if (settings_.watch) settings_.watch(robot_);
}

void Lockstep::show(CameraSample seen) {
  if (settings_.misread) settings_.misread(seen);
  cycle_.camera(seen);
}

void Lockstep::look() {
  camera_->look(truth_now(), robot_.now_ns());
  while (const std::optional<CameraSample> seen = camera_->take(robot_.now_ns())) show(*seen);
}

void Lockstep::deliver() {
  while (begin_ns_ >= 0 && delivered_ < settings_.detections.size()) {
    CameraSample sample = settings_.detections[delivered_];
    sample.measured_ns += begin_ns_;
    if (sample.measured_ns + kDetectionDelayNs > robot_.now_ns()) return;
    show(sample);
    ++delivered_;
  }
}

void Lockstep::cable() {
  if (plugged_ns_ > 0 && plugged()) {
    plugged_ns_ = 0;
    robot_.reset(PowerUp::kExternal);
    cycle_.session().open(robot_.now_ns());
  }
  if (const std::optional<double> away_s = robot_.take_fault(fault_kind("unplug"))) {
    plugged_ns_ = robot_.now_ns() + from_s(*away_s);
    arriving_.clear();
    cycle_.session().close(robot_.now_ns());
  }
  if (const std::optional<double> stall_ms = robot_.take_fault(fault_kind("host-stall")))
    host_awake_ns_ = robot_.now_ns() + from_s(*stall_ms * 1e-3);
}

void Lockstep::push() {
  const course::Disturbance* disturbance = disturbance_injector_.update(robot_);
  if (disturbance == nullptr) return;
  const double now_s = to_s(robot_.now_ns() - begin_ns_);
  result_.disturbances.push_back({now_s, now_s + disturbance->duration_s});
  if (settings_.on_disturbance) settings_.on_disturbance(robot_.now_ns());
}

void Lockstep::record(const Snapshot& snapshot) {
  if (!snapshot.has_sample || snapshot.sample.device_us == last_recorded_us_) return;
  const HostNs measured_ns = snapshot.sample.measured_ns;
  if (measured_ns < begin_ns_ || measured_ns > robot_.now_ns()) return;
  last_recorded_us_ = snapshot.sample.device_us;
  const Pose& steering = snapshot.estimates[parameters_.steering].pose;
  const Pose truth = stand() ? steering : truth_at(measured_ns);
  behind_ = Transform2d::between(steering, snapshot.world);
  result_.points.push_back({.t_s = to_s(measured_ns - begin_ns_),
                            .truth = truth,
                            .world = behind_.of(truth),
                            .estimates = poses_of(snapshot.estimates),
                            .sd = report::sd_of(snapshot.estimates),
                            .progress_m = snapshot.progress_m,
                            .recovering = snapshot.recovering,
                            .imu_pitch_rad = snapshot.imu_pitch_rad,
                            .slope = snapshot.imu_slope,
                            .obstacle_class = snapshot.imu_obstacle,
                            .measured = measured_.now()});
}

void Lockstep::publish() {
  if (settings_.sinks.empty() && settings_.truth_sinks.empty() && !world_ && !settings_.world)
    return;
  cycle_.record(record_);
  if (settings_.world) cycle_.world(settings_.world(record_));
  if (world_) {
    world_->exchange(record_, robot_.now_ns(),
                     [this](const WorldSample& received) { cycle_.world(received); });
  }
  for (messages::Sink* sink : settings_.sinks) sink->take(record_);
  if (stand()) return;
  for (const Sample& sample : cycle_.inputs().samples) {
    const HostNs age_ns = robot_.now_ns() - sample.measured_ns;
    if (age_ns >= 0 && age_ns < kOldestTruthNs)
      for (messages::TruthSink* sink : settings_.truth_sinks)
        sink->take_truth(sample.measured_ns, truth_at(sample.measured_ns));
  }
}

void Lockstep::step_host() {
  const HostNs now = robot_.now_ns();
  if (!arriving_.empty()) {
    cycle_.session().receive(arriving_, now);
    arriving_.clear();
  }
  const Clock::time_point before = Clock::now();
  const bridge::Outputs& out = cycle_.step(now);
  for (const Sample& sample : cycle_.inputs().samples) measured_.take(sample);
  const std::chrono::nanoseconds took = Clock::now() - before;
  step_time_ += took;
  longest_step_ = std::max(longest_step_, took);
  ++steps_;
  publish();
  // As in a recording: before this step's command is counted as sent.
  result_.link = cycle_.session().counters();
  for (const link::SessionEvent& event : cycle_.session().take_events())
    if (settings_.on_session_event) settings_.on_session_event(event, cycle_.session().hello());
  if (plugged()) robot_.receive(cycle_.session().output(), now);
  cycle_.session().written(cycle_.session().output().size());
  if (out.snapshot.run_state == RunState::kRunning) {
    if (begin_ns_ < 0) {
      begin_ns_ = now;
      result_.began_ns = now;
      result_.baselines.gyro_bias_radps = measured_.bias_radps();
    }
    record(out.snapshot);
    if (result_.has_camera) result_.camera = report::camera_figures(out.snapshot.filter);
  }
}

void Lockstep::open() {
  robot_.reset(PowerUp::kPowerOn);
  while (robot_.now_ns() < kOpenNs) robot_.advance();
  robot_.opened();
  opened_ns_ = next_step_ns_ = robot_.now_ns();
  cycle_.session().open(opened_ns_);
}

void Lockstep::turn() {
  advance_robot();
  cable();
  if (camera_) look();
  deliver();
  if (begin_ns_ >= 0) push();
  if (robot_.now_ns() < std::max(next_step_ns_, host_awake_ns_)) return;
  next_step_ns_ += period_ns_;
  step_host();
}

void Lockstep::stand_still_until(double from_opening_s) {
  cycle_.request(OperatorRequest::kHold);
  const HostNs until_ns =
      std::max(opened_ns_ + from_s(from_opening_s), robot_.now_ns() + period_ns_);
  while (robot_.now_ns() < until_ns) turn();
  put_back_ = Transform2d::between(robot_.truth().pose, settings_.course.start);
}

report::RunResult Lockstep::run() {
  const Clock::time_point wall_begin = Clock::now();
  const HostNs started_ns = robot_.now_ns();
  begin_ns_ = -1;
  delivered_ = 0;
  result_.began_ns.reset();
  result_.points.clear();
  result_.disturbances.clear();
  result_.camera = {};
  bool started = false;
  HostNs end_ns = 0;
  RunState state = RunState::kIdle;
  while (end_ns == 0 || robot_.now_ns() < end_ns) {
    const std::uint64_t steps = steps_;
    // Like the daemon, not before a robot is ready.
    if (!started && cycle_.session().state() == SessionState::kReady) {
      started = true;
      cycle_.request(OperatorRequest::kStartPlaced);
    }
    turn();
    if (steps_ == steps) continue;
    state = cycle_.outputs().snapshot.run_state;
    const bool over = state == RunState::kFinished || state == RunState::kAborted;
    const bool never_begins =
        begin_ns_ < 0 && to_s(robot_.now_ns() - started_ns) > settings_.begin_within_s;
    if (end_ns == 0 && (over || never_begins)) end_ns = robot_.now_ns() + from_s(kStandstillS);
  }
  judge(state, end_ns);
  count(Clock::now() - wall_begin);
  return result_;
}

void Lockstep::judge(RunState state, HostNs end_ns) {
  result_.duration_s = begin_ns_ < 0 ? 0.0 : to_s(end_ns - from_s(kStandstillS) - begin_ns_);
  const Pose end = begin_ns_ < 0 || (stand() && result_.points.empty()) ? settings_.course.start
                   : stand() ? result_.points.back().world
                             : behind_.of(truth_now());
  report::judge_end(result_, state, cycle_.outputs().snapshot.faults, report::at_end(path_, end));
  if (begin_ns_ < 0 && world_ && world_->silent()) result_.cause = describe(Fault::world_lost).name;
}

void Lockstep::count(std::chrono::duration<double> wall) {
  result_.realtime_factor = to_s(robot_.now_ns()) / wall.count();
  const auto spent_s = [](std::chrono::nanoseconds time) { return to_s(time.count()); };
  const double physics_s = spent_s(robot_.spent().physics);
  const double board_s = spent_s(robot_.spent().board);
  result_.loop = {{"physics_s", physics_s},
                  {"board_s", board_s},
                  {"rest_s", wall.count() - physics_s - board_s},
                  {"steps", static_cast<double>(steps_)},
                  {"mean_step_us", static_cast<double>(step_time_.count()) * 1e-3 /
                                       static_cast<double>(std::max<std::uint64_t>(steps_, 1))},
                  {"max_step_us", static_cast<double>(longest_step_.count()) * 1e-3}};
  if (world_) {
    const worlds::PeerCounters& world = world_->counters();
    result_.loop.insert(result_.loop.end(),
                        {{"world_poses", static_cast<double>(world.poses)},
                         {"world_answered", static_cast<double>(world.answered)},
                         {"world_missing", static_cast<double>(world.missing)}});
  }
}

}  // namespace

report::RunResult run_lockstep(const LockstepSettings& settings) {
  Lockstep lockstep(settings);
  lockstep.open();
  return lockstep.run();
}

TwoRuns run_lockstep_twice(const LockstepSettings& settings, double again_s) {
  Lockstep lockstep(settings);
  lockstep.open();
  TwoRuns out{.first = lockstep.run()};
  lockstep.stand_still_until(again_s);
  out.again = lockstep.run();
  return out;
}

}  // namespace tp100::sim
