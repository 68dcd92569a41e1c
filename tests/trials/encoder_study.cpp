#include "encoder_study.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/arithmetic.h"
#include "core/time.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

constexpr std::array kFailures = std::to_array<EncoderFailure>({
    {"encoder-stuck:left", 0.0, true},
    {"encoder-stuck:right"},
    {"encoder-stuck", 0.0, true},
    {"encoder-silent:left"},
    {"encoder-silent:right", 0.0, true},
    {"encoder-silent"},
    {"encoder-lose:0.3:left", 0.0, true},
    {"encoder-lose:0.3:right", 0.0, true},
    {"encoder-lose:0.3", 0.0, true},
    {"encoder-lose:0.5:left"},
    {"encoder-lose:0.5", 0.0, true},
    {"encoder-lose:0.7:right"},
    {"encoder-lose:0.7"},
    {"encoder-lose:0.95:left"},
    {"encoder-lose:0.95", 0.0, true},
    {"encoder-jump:200:left", 0.25, true},
    {"encoder-jump:-200", 0.25},
    {"encoder-flip:left", 0.0, true},
});
constexpr std::array kSpeeds = {0.03, 0.06, 0.10, 0.15, 0.20};
constexpr std::array kOnsets = {Onset::kStraight, Onset::kArc, Onset::kStandstill, Onset::kSpin};
constexpr std::array<std::string_view, 3> kRobots = {"end-loaded", "uniform", "worn"};

// Segments of the course, and the positions in them at which encoders fail.
constexpr double kLineM = 0.5, kRadiusM = 0.35, kArcRad = 90.0 * kRadPerDeg, kNextLineM = 0.2;
constexpr double kInLineM = 0.2, kInArcM = 0.65;
constexpr double kSpinRad = 90.0 * kRadPerDeg, kInSpinRad = kArcRad + 30.0 * kRadPerDeg;
constexpr double kStoppedM = kLineM + kRadiusM * kArcRad + kNextLineM - 0.01;
constexpr int kTimes = 60;
constexpr double kFenceM = 3.0;

course::Course course_at(double speed_mps) {
  course::Course course = load_course("1-straight");
  course.speed_mps = speed_mps;
  course.path = {course::Line{kLineM}, course::Arc{kRadiusM, kArcRad}, course::Line{kNextLineM},
                 course::Pivot{kSpinRad}, course::Line{0.3}};
  course.fence = {-kFenceM, kFenceM, -kFenceM, kFenceM};
  return course;
}

Loaded load_robot(std::string_view name) {
  Options options;
  options.robot = name;
  return load(options);
}

/// Widens the daemon's own checks as far as possible.
void look_away(LockstepSettings& settings) {
  control::Parameters& control = settings.configuration.parameters.control;
  control.max_cross_track_m = 10.0;
  control.max_heading_error_rad = 180.0 * kRadPerDeg;
  control.stall_s = 30.0;
  control.disagreement_radps = 10.0;
  settings.host_checks_encoders = false;
}

/// Finds the times at which a healthy robot is where encoders fail.
class PlaceMonitor : public messages::Sink {
 public:
  explicit PlaceMonitor(HostNs opened_ns) : opened_ns_(opened_ns) {}
  void take(const StepRecord& record) override {
    const Snapshot& snapshot = record.snapshot;
    if (snapshot.run_state != RunState::kRunning) return;
    const auto mark = [&](Onset onset, bool there) {
      if (there) onset_s.try_emplace(onset, to_s(record.now_ns - opened_ns_));
    };
    const double turned = snapshot.estimates[PoseSource::kOdometry].pose.yaw_rad;
    const bool standstill = snapshot.left_mps == 0.0 && snapshot.right_mps == 0.0;
    mark(Onset::kStraight, snapshot.progress_m > kInLineM);
    mark(Onset::kArc, snapshot.progress_m > kInArcM);
    mark(Onset::kStandstill, snapshot.progress_m > kStoppedM && standstill);
    mark(Onset::kSpin, snapshot.progress_m > kStoppedM && turned > kInSpinRad);
  }
  std::map<Onset, double> onset_s;

 private:
  HostNs opened_ns_;
};

/// Greatest deviation from the poses of a healthy robot so far. A mere delay is not a deviation:
/// the robot is compared with the nearest of the healthy poses, but with none before the last
/// nearest.
class DeviationFromHealthy {
 public:
  explicit DeviationFromHealthy(const std::vector<Pose>& healthy) : healthy_(healthy) {}
  /// Call once per physics step.
  void update(const Pose& is) {
    const std::size_t now = std::min(step_++, healthy_.size() - 1);
    if (step_ % kEverySteps != 0) return;
    double least = share(is, nearest_);
    for (std::size_t i = nearest_ + 1; i <= now; ++i) {
      const double one = share(is, i);
      if (one > least) continue;
      least = one;
      nearest_ = i;
    }
    distance_m = std::max(distance_m, distance(is, nearest_));
    yaw_rad = std::max(yaw_rad, turned(is, nearest_));
  }
  double distance_m = 0.0, yaw_rad = 0.0;

 private:
  static constexpr std::size_t kEverySteps = 10;

  double distance(const Pose& is, std::size_t i) const {
    return magnitude(is.x_m - healthy_[i].x_m, is.y_m - healthy_[i].y_m);
  }
  double turned(const Pose& is, std::size_t i) const {
    return std::abs(wrap_angle(is.yaw_rad - healthy_[i].yaw_rad));
  }
  double share(const Pose& is, std::size_t i) const {
    return std::max(distance(is, i) / EncoderOutcome::kMaxM,
                    turned(is, i) / EncoderOutcome::kMaxRad);
  }

  const std::vector<Pose>& healthy_;
  std::size_t step_ = 0, nearest_ = 0;
};

// As in lockstep.cpp: the robot stands before the host opens the port.
constexpr HostNs kOpenNs = 20 * kNsPerMs;

std::vector<PlannedFault> planned(const EncoderFailure& failure, double at_s) {
  std::vector<PlannedFault> faults;
  for (int i = 0; i < (failure.again_s > 0.0 ? kTimes : 1); ++i) {
    PlannedFault fault = parse_fault(failure.fault);
    fault.begin_ns = from_s(at_s + i * failure.again_s);
    faults.push_back(fault);
  }
  return faults;
}

}  // namespace

std::span<const EncoderFailure> encoder_failures() { return kFailures; }
std::span<const double> encoder_speeds() { return kSpeeds; }
std::span<const std::string_view> encoder_robots() { return kRobots; }

void EncoderOutcome::merge(const EncoderOutcome& other) {
  if (end.empty() || other.end == "completed") end = other.end;
  off_after_s = std::max(off_after_s, other.off_after_s);
  beyond_m = std::max(beyond_m, other.beyond_m);
  beyond_rad = std::max(beyond_rad, other.beyond_rad);
}

const EncoderStudy::Healthy& EncoderStudy::healthy(const EncoderTrial& trial) {
  const auto [found, is_new] =
      healthy_.try_emplace({trial.robot, trial.speed_mps, trial.board}, Healthy{});
  Healthy& healthy = found->second;
  if (!is_new) return healthy;
  const Loaded loaded = load_robot(trial.robot);
  PlaceMonitor places(kOpenNs);
  run_lockstep({.course = course_at(trial.speed_mps),
                .robot = loaded.robot,
                .configuration = loaded.configuration,
                .board = trial.board,
                .watch =
                    [&](const EmulatedRobot& robot) {
                      if (robot.now_ns() > kOpenNs) healthy.truth.push_back(robot.truth().pose);
                    },
                .sinks = {&places}});
  healthy.onset_s = places.onset_s;
  return healthy;
}

EncoderOutcome EncoderStudy::drive(const EncoderTrial& trial) {
  const Healthy& healthy = this->healthy(trial);
  const double at_s = healthy.onset_s.at(trial.onset);
  const Loaded loaded = load_robot(trial.robot);
  EncoderOutcome outcome;
  DeviationFromHealthy deviation(healthy.truth);
  LockstepSettings settings{.course = course_at(trial.speed_mps),
                            .robot = loaded.robot,
                            .configuration = loaded.configuration,
                            .board = trial.board,
                            .faults = planned(trial.failure, at_s)};
  settings.watch = [&](const EmulatedRobot& robot) {
    if (robot.now_ns() <= kOpenNs) return;
    deviation.update(robot.truth().pose);
    if (robot.motor_duty().left == 0.0 && robot.motor_duty().right == 0.0) return;
    outcome.off_after_s = to_s(robot.now_ns() - kOpenNs) - at_s;
    outcome.beyond_m = deviation.distance_m;
    outcome.beyond_rad = deviation.yaw_rad;
  };
  if (!host_checks_) look_away(settings);
  const report::RunResult result = run_lockstep(settings);
  outcome.end = result.finished ? "completed" : result.cause;
  return outcome;
}

std::vector<EncoderTrial> encoder_trials(const EncoderFailure& failure, double speed_mps,
                                         BoardKind board, bool every_robot) {
  std::vector<EncoderTrial> trials;
  const auto number_of = [](const auto& all, auto is_it) {
    return std::find_if(all.begin(), all.end(), is_it) - all.begin();
  };
  const auto speed = number_of(kSpeeds, [&](double one) { return one == speed_mps; });
  const auto number =
      number_of(kFailures, [&](const EncoderFailure& one) { return one.fault == failure.fault; });
  const std::size_t in_turn = static_cast<std::size_t>(speed + number) % kRobots.size();
  for (const Onset onset : kOnsets)
    for (std::size_t robot = 0; robot < kRobots.size(); ++robot)
      if (every_robot || robot == in_turn)
        trials.push_back({failure, speed_mps, onset, kRobots[robot], board});
  return trials;
}

std::string encoder_table_head() {
  std::string head = "| `--fault` |", line = "|---|";
  for (const double speed : kSpeeds) {
    head += text::format(" %.2f m/s |", speed);
    line += "---|";
  }
  return head + "\n" + line + "\n";
}

std::string encoder_row(const EncoderFailure& failure, std::span<const EncoderOutcome> by_speed) {
  std::string row = "| `" + std::string(failure.fault) + "`";
  if (failure.again_s > 0.0) row += text::format(" every %.2f s", failure.again_s);
  row += " |";
  for (const EncoderOutcome& worst : by_speed)
    row += text::format(" %s%.1f s, %.1f cm, %.0f deg |",
                        worst.end == "completed" ? "completed, " : "", worst.off_after_s,
                        worst.beyond_m * 100.0, worst.beyond_rad * kDegPerRad);
  return row + "\n";
}

}  // namespace tp100::sim
