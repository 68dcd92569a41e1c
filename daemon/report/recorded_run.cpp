#include "report/recorded_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/arithmetic.h"
#include "course/path.h"
#include "text/format.h"

namespace tp100::report {
namespace {

// Twenty minutes at 200 Hz; beyond it every second point is dropped.
constexpr std::size_t kMaxKeptPoints = std::size_t{1} << 18;
// No robot drives farther than this.
constexpr double kFarthest = 1e6;
constexpr const char* kMark = "mark: ";
constexpr std::size_t kLongestEvent = std::size_t{1} << 16;

double known(double value) {
  return std::abs(value) <= kFarthest ? value : std::numeric_limits<double>::quiet_NaN();
}

bool plausible(const Pose& pose) {
  return std::ranges::all_of(
      std::initializer_list<double>{pose.x_m, pose.y_m, pose.z_m, pose.roll_rad, pose.pitch_rad,
                                    pose.yaw_rad},
      [](double value) { return std::abs(value) <= kFarthest; });
}

/// 0: none is known.
std::uint64_t seed_of(const std::string& fact) {
  return text::number_in<std::uint64_t>(fact).value_or(0);
}

/// Distributions of one run.
struct Times {
  Histogram jitter{}, sample_age{}, world_age{};
};

class Reader {
 public:
  Reader(RecordedRun& run, const record::Recording& recording)
      : run_(run),
        period_us_(1e6 / run.run_context.rate_hz),
        start_ns_(recording.start_ns()),
        start_unix_ns_(static_cast<std::uint64_t>(recording.start_unix_ns())) {}

  void step(const StepRecord& record);
  void truth(HostNs at, const Pose& pose);
  void event(std::uint64_t unix_ns, std::string_view json);
  void finish();

 private:
  void begin(HostNs now);
  void time(const StepRecord& record);
  void estimate(const Snapshot& snapshot);
  void point(const StepRecord& record);
  void thin();
  void disturbances();
  void judge();
  double t_s(HostNs at) const { return to_s(at - begin_ns_); }

  RecordedRun& run_;
  double period_us_;
  HostNs start_ns_;
  std::uint64_t start_unix_ns_;

  MeasuredMotion measured_;
  RunMonitor run_monitor_;
  std::optional<Times> times_{std::in_place};
  std::vector<HostNs> disturbances_ns_;
  RunState state_ = RunState::kIdle, ended_ = RunState::kRunning;
  FaultMask faults_ = 0;
  std::uint64_t step_ = 0;
  HostNs begin_ns_ = 0, now_ns_ = 0, end_ns_ = 0;
  std::optional<HostNs> world_answered_ns_;
  double step_jitter_us_ = 0.0;
  double cross_track_squares_ = 0.0;
  std::uint64_t estimated_steps_ = 0;
  // Times of the newest sample seen, and of the last point.
  DeviceUs device_us_ = -1;
  HostNs point_ns_ = std::numeric_limits<HostNs>::min();
  double behind_x_m_ = 0.0, behind_y_m_ = 0.0;
  std::uint64_t samples_ = 0;
};

void Reader::step(const StepRecord& record) {
  for (const Sample& sample : record.inputs.samples) measured_.take(sample);
  for (const WorldSample& answer : record.inputs.world) world_answered_ns_ = answer.answered_ns;
  if (run_.steps == 0) begin(record.now_ns);
  run_monitor_.step(record);
  const RunState state = record.snapshot.run_state;
  // The robot did not confirm that its motors are off after the end of the path.
  const bool unconfirmed = state_ == RunState::kFinished && state == RunState::kAborted;
  if (state == RunState::kRunning && state_ != RunState::kRunning) {
    ++run_.runs;
    begin(record.now_ns);
  }
  if (run_.runs == 0 || state == RunState::kRunning) {
    time(record);
    estimate(record.snapshot);
    point(record);
    run_.result.camera = camera_figures(record.snapshot.filter);
    end_ns_ = record.now_ns;
  } else if (state_ == RunState::kRunning || unconfirmed) {
    if (!unconfirmed) end_ns_ = record.now_ns;
    ended_ = state;
    faults_ = record.snapshot.faults;
  }
  if (run_.steps > 0 && record.step > step_) run_.missing_steps += record.step - step_ - 1;
  ++run_.steps;
  run_.result.link = record.link;
  state_ = state;
  step_ = record.step;
  now_ns_ = record.now_ns;
}

// Discards an earlier run.
void Reader::begin(HostNs now) {
  begin_ns_ = end_ns_ = now;
  run_.result.points.clear();
  run_.moments.clear();
  run_.every = 1;
  run_.implausible = 0;
  run_.estimated = {};
  run_.result.camera = {};
  run_.result.baselines.gyro_bias_radps = measured_.bias_radps();
  times_.emplace();
  disturbances_ns_.clear();
  ended_ = RunState::kRunning;
  faults_ = 0;
  cross_track_squares_ = 0.0;
  estimated_steps_ = 0;
  samples_ = 0;
}

void Reader::time(const StepRecord& record) {
  step_jitter_us_ = std::numeric_limits<double>::quiet_NaN();
  if (run_.steps > 0 && record.step == step_ + 1) {
    step_jitter_us_ = known(std::abs(to_s(record.now_ns - now_ns_) * 1e6 - period_us_));
    messages::add_us(times_->jitter, step_jitter_us_);
  }
  if (record.snapshot.has_sample)
    messages::add_us(times_->sample_age, static_cast<double>(record.snapshot.age_us));
  if (world_answered_ns_)
    messages::add_us(times_->world_age, to_s(record.now_ns - *world_answered_ns_) * 1e6);
}

void Reader::estimate(const Snapshot& snapshot) {
  const double cross = std::abs(known(snapshot.cross_track_m));
  const double heading = std::abs(known(snapshot.heading_error_rad));
  if (std::isnan(cross) || std::isnan(heading)) return;
  ++estimated_steps_;
  cross_track_squares_ += cross * cross;
  EstimatedErrors& estimated = run_.estimated;
  estimated.max_cross_track_m = std::max(estimated.max_cross_track_m, cross);
  estimated.max_heading_error_rad = std::max(estimated.max_heading_error_rad, heading);
  estimated.rms_cross_track_m =
      std::sqrt(cross_track_squares_ / static_cast<double>(estimated_steps_));
}

void Reader::point(const StepRecord& record) {
  const Snapshot& snapshot = record.snapshot;
  const Sample& sample = snapshot.sample;
  if (!snapshot.has_sample || sample.device_us == device_us_) return;
  if (sample.measured_ns < begin_ns_ || sample.measured_ns > record.now_ns) return;
  device_us_ = sample.device_us;
  point_ns_ = std::numeric_limits<HostNs>::min();
  if (samples_++ % run_.every != 0) return;
  TrajectoryPoint point{.t_s = t_s(sample.measured_ns),
                        .estimates = poses_of(snapshot.estimates),
                        .sd = sd_of(snapshot.estimates),
                        .progress_m = snapshot.progress_m,
                        .recovering = snapshot.recovering,
                        .measured = measured_.now()};
  const bool ascends = run_.result.points.empty() || point.t_s > run_.result.points.back().t_s;
  if (!std::ranges::all_of(point.estimates.values, plausible) || !plausible(snapshot.world) ||
      !ascends || !(std::abs(point.progress_m) <= kFarthest)) {
    ++run_.implausible;
    return;
  }
  point.world = snapshot.world;
  const Pose& steering = point.estimates[run_.run_context.steering];
  behind_x_m_ = snapshot.world.x_m - steering.x_m;
  behind_y_m_ = snapshot.world.y_m - steering.y_m;
  run_.result.points.push_back(point);
  run_.moments.push_back({.slip_left = known(snapshot.slip_left),
                          .slip_right = known(snapshot.slip_right),
                          .cross_track_m = known(snapshot.cross_track_m),
                          .jitter_us = step_jitter_us_,
                          .steering_world = snapshot.world});
  point_ns_ = sample.measured_ns;
  if (run_.result.points.size() >= kMaxKeptPoints) thin();
}

void Reader::thin() {
  const auto every_second = [](auto& list) {
    for (std::size_t i = 0; 2 * i < list.size(); ++i) list[i] = list[2 * i];
    list.resize((list.size() + 1) / 2);
  };
  every_second(run_.result.points);
  every_second(run_.moments);
  run_.every *= 2;
  samples_ = 0;
}

// The truth follows the step that used the sample of that time.
void Reader::truth(HostNs at, const Pose& pose) {
  if (at != point_ns_ || !plausible(pose)) return;
  TrajectoryPoint& point = run_.result.points.back();
  point.truth = pose;
  point.world = pose;
  point.world.x_m += behind_x_m_;
  point.world.y_m += behind_y_m_;
  run_.moments.back().truth_known = true;
}

// Only events that cannot be derived from the steps.
void Reader::event(std::uint64_t unix_ns, std::string_view text) {
  // Below 2^62 ns, which is in 2116, so that no sum overflows.
  if (text.size() > kLongestEvent || unix_ns >> 62 != 0 || start_unix_ns_ >> 62 != 0) return;
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  const auto field = [&](const char* name) -> std::string {
    if (!json.is_object()) return {};
    const auto found = json.find(name);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  const std::string kind = field("kind"), words = field("text");
  if (kind == "run" || kind == "fault" || (kind == "session" && words.starts_with("state: ")))
    return;
  const HostNs at =
      start_ns_ + (static_cast<HostNs>(unix_ns) - static_cast<HostNs>(start_unix_ns_));
  if (kind == "push" && disturbances_ns_.size() < RunMonitor::kMax) disturbances_ns_.push_back(at);
  run_monitor_.add({.at_ns = at,
                    .text = (kind == "mark" ? kMark : "") + words.substr(0, 300),
                    .fix = field("fix").substr(0, 300),
                    .bad = field("level") == "error"});
}

// The recording has the start of each disturbance, the course its duration.
void Reader::disturbances() {
  if (run_.run_context.course == nullptr) return;
  const std::vector<course::Disturbance>& planned = run_.run_context.course->disturbances;
  for (std::size_t i = 0; i < std::min(disturbances_ns_.size(), planned.size()); ++i) {
    const double begin_s = t_s(disturbances_ns_[i]);
    run_.result.disturbances.push_back({begin_s, begin_s + planned[i].duration_s});
  }
}

void Reader::judge() {
  const auto& course = run_.run_context.course;
  const std::vector<TrajectoryPoint>& points = run_.result.points;
  std::optional<bool> there;
  if (course && !points.empty()) there = at_end(course::Path(*course), points.back().world);
  judge_end(run_.result, ended_, faults_, there);
}

void Reader::finish() {
  RunResult& result = run_.result;
  run_.has_truth =
      std::ranges::any_of(run_.moments, [](const RunMoment& m) { return m.truth_known; });
  if (run_.has_truth) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < run_.moments.size(); ++i) {
      if (!run_.moments[i].truth_known) continue;
      result.points[kept] = result.points[i];
      run_.moments[kept++] = run_.moments[i];
    }
    result.points.resize(kept);
    run_.moments.resize(kept);
  }
  if (run_.runs > 0) result.began_ns = begin_ns_;
  result.duration_s = t_s(end_ns_);
  disturbances();
  judge();
  if (start_unix_ns_ > 0 && start_unix_ns_ >> 62 == 0)
    run_.driven_unix_s = (static_cast<HostNs>(start_unix_ns_) + begin_ns_ - start_ns_) / kNsPerS;
  for (RunEvent mark : run_.run_context.notes.marks) {
    mark.at_ns += start_ns_;
    mark.text.insert(0, kMark);
    run_monitor_.add(std::move(mark));
  }
  run_.jitter = messages::durations_of(times_->jitter);
  run_.jitter_counts = messages::lateness_counts_of(times_->jitter);
  run_.sample_age = messages::durations_of(times_->sample_age);
  run_.world_age = messages::durations_of(times_->world_age);
  run_.events = run_monitor_.events();
  for (RunEvent& event : run_.events) event.t_s = t_s(event.at_ns);
  std::ranges::stable_sort(run_.events, {}, &RunEvent::at_ns);
  run_.more_events = run_monitor_.more();
}

/// The board that answered, from a message of /link; empty: none did.
std::string board_of(std::string_view text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("kind") || !json["kind"].is_string()) return {};
  const nlohmann::json firmware = json.value("firmware", nlohmann::json());
  return json["kind"].get<std::string>() +
         (firmware.is_string() ? ", firmware " + firmware.get<std::string>() : "");
}

}  // namespace

RecordedRun read_run(const record::Recording& recording, const RecordedContext& run_context) {
  RecordedRun run;
  run.path = recording.path();
  run.facts = recording.facts();
  run.run_context = run_context;
  run.whole = recording.whole();
  for (const char* name : {"tp100.toml", "robot.toml", "course.toml"})
    run.files.emplace_back(name, recording.file(name));
  run.result.course = recording.fact("course");
  run.result.board = recording.fact("board");
  run.result.robot = recording.fact("robot");
  run.result.setup = recording.fact("setup");
  run.result.baselines = baselines_of(run_context.robot, run_context.turning_threshold_radps);
  run.result.seed = seed_of(recording.fact("seed"));

  const auto reader = std::make_unique<Reader>(run, recording);
  recording.visit({.step =
                       [&](const StepRecord& record) {
                         reader->step(record);
                         if (!record.inputs.camera.empty()) run.result.has_camera = true;
                       },
                   .truth = [&](HostNs at, const Pose& pose) { reader->truth(at, pose); },
                   .message =
                       [&](const std::string& topic, std::uint64_t unix_ns, std::string_view json) {
                         if (topic == "/event") return reader->event(unix_ns, json);
                         if (run.result.board.empty()) run.result.board = board_of(json);
                       },
                   .topics = {"/event", "/link"}});
  reader->finish();
  return run;
}

}  // namespace tp100::report
