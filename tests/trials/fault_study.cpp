#include "fault_study.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/time.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

constexpr std::string_view kCompleted = "completed";
using report::kNeverBegan;
constexpr double kCourseM = 0.6;
constexpr double kBeginWithinS = 3.0;
// A robot drives on for the life of a command; the observer's resolution is a physics step.
constexpr double kOffS = 0.21;
// Faults that only the robot can detect take longer, as stated in the firmware.
constexpr double kOnlyItsBytesS =
    0.30;                             // the samples get too old to steer by, plus a command's life
constexpr double kDutyS = 0.85;       // the duty implies more than is counted
constexpr double kTurnS = 1.00;       // gyro and encoders disagree about the turn
constexpr double kBackwardsS = 0.35;  // motion against the duty
constexpr double kImuS = 0.10;        // the values no longer change
constexpr double kBatteryS = 1.15;    // a second below the cut-off

constexpr std::array kTrials = std::to_array<FaultTrial>({
    {"flip:0.0005", kCompleted, "corrupted", 1, 0, 0, "corrupted frames"},
    {"flip:0.002:to-robot", kCompleted, "robot_corrupted", 1, 0, 0,
     "frames corrupted on their way to the robot"},
    {"drop:0.0005", kCompleted, "corrupted", 1, 0, 0, "corrupted frames"},
    {"duplicate:0.0005", kCompleted, "corrupted", 1, 0, 0, "corrupted frames"},
    {"insert:0.0005", kCompleted, "corrupted", 1, 0, 0, "corrupted frames"},
    {"noise:64@3", kCompleted, "corrupted", 1, 0, 0, "corrupted frames"},
    {"delimiter:0.0005", kCompleted, "corrupted", 1, 0, 0, "corrupted frames"},
    {"truncate:0.02", kCompleted, "corrupted", 1, 0, 0, "corrupted frames"},
    {"fuse:0.02", kCompleted, "corrupted", 1, 0, 0, "corrupted frames"},
    {"chatter:333", kCompleted, "corrupted", 1, 0, 0, "corrupted frames"},
    {"chatter:150", kCompleted, "corrupted", 1, 0, 0, "corrupted frames"},
    {"delay:20", kCompleted, "sample_age_ms", 20, 0, 0, "steps without a fresh sample"},
    {"jitter:5", kCompleted, "sample_age_ms", 8},
    {"batch:16:to-host", kCompleted, "sample_age_ms", 16, 0, 0, "steps without a fresh sample"},
    {"stall:10@3", kCompleted, "sample_age_ms", 7},
    {"stall:100@3", kCompleted, "sample_age_ms", 90, 0, 0, "steps without a fresh sample"},
    {"stall:2000@3", "link_lost", "silences", 1, kOffS, 6},
    {"drift:100", kCompleted, "drift_ppm", 90},
    {"drift:-1000", kCompleted, "drift_ppm", 900},
    {"wrap@4", kCompleted, "device_wraps", 1},
    {"clock-step:500@3+2", "link_lost", "implausible", 1, kOffS, 6},
    {"sync-late:30", kCompleted, "clock_uncertainty_us", 10e3},
    {"sync-twice", kCompleted, "sync_rejected", 1, 0, 0, "replies to clock requests"},
    {"cut@3+2", "link_lost", "silences", 1, kOffS, 6},
    {"cut:to-robot@3+2", "command_timeout", "robot_faults", 1, kOffS, 6},
    {"cut:to-robot@0+7", kNeverBegan, "unanswered", 1, 0, 8, "no answer from the robot"},
    {"cut:to-host@3+2", "link_lost", "silences", 1, kOnlyItsBytesS, 6},
    {"unplug:0.05@3", "link_lost", "reconnects", 1, kOffS, 4},
    {"unplug:1@3", "link_lost", "reconnects", 1, kOffS, 5},
    {"reboot@3", "brown_out", "reboots", 1, 0.01, 4},
    {"reboot-loop:0.5@0+4", kNeverBegan, "reboots", 1, 0, 5, "the robot restarted"},
    {"hang@3", "watchdog_reset", "reboots", 1, kOffS, 4, {}, true},
    {"version:2@0+3", kNeverBegan, "refused", 1, 0, 4, "wrong version"},
    {"schema@0+3", kNeverBegan, "refused", 1, 0, 4, "wrong version"},
    {"board:77", kCompleted, "unknown_board", 1, 0, 0, "unknown board"},
    {"unknown-message", kCompleted, "unknown_type", 1, 0, 0, "frames of an unknown type"},
    {"replay:20", kCompleted, "duplicated", 1, 0, 0, "samples repeated"},
    {"sequence@3+2", "link_lost", "reordered", 1, kOffS, 6},
    {"encoder-stuck:left@3+2", "gyro_against_encoders", "daemon_faults", 1, kTurnS, 6},
    {"encoder-stuck@3+2", "encoders_against_duty", "daemon_faults", 1, kDutyS, 6},
    {"encoder-silent:left@3+2", "gyro_against_encoders", "daemon_faults", 1, kTurnS, 6},
    {"encoder-lose:0.5:right@3+2", "gyro_against_encoders", "daemon_faults", 1, kTurnS, 6},
    {"encoder-lose:0.5@3+2", "encoders_against_duty", "daemon_faults", 1, kDutyS, 6},
    {"encoder-flip@3+2", "reversed_left", "robot_faults", 1, kBackwardsS, 6},
    {"encoder-jump:500:left@3", kCompleted, "implausible", 1, 0, 0, "impossible values"},
    {"imu-missing@3+2", "imu_stale", "robot_faults", 1, kImuS, 6},
    {"imu-frozen@3+2", "imu_stale", "robot_faults", 1, kImuS, 6},
    {"imu-saturated@3+2", "imu_stale", "robot_faults", 1, kImuS, 6},
    {"battery:5.5@3+3", "battery_low", "robot_faults", 1, kBatteryS, 7},
    {"host-stall:100@3", kCompleted, "lateness_ms", 90, 0, 0, "cycles of the loop"},
    {"host-stall:300@3", "command_timeout", "robot_faults", 1, kOffS, 4, "cycles of the loop"},
});

// The robot's own faults are the lower bits.
constexpr unsigned kRobotFaults = 16;

/// Checks every step and every command that is sent.
class StepMonitor : public messages::Sink {
 public:
  explicit StepMonitor(messages::Sink* also) : also_(also) {}

  void take(const StepRecord& record) override {
    if (also_ != nullptr) also_->take(record);
    look(record);
    if (record.command_valid) look_at_command(record);
  }
  std::vector<Figure> figures() const {
    return {{"sample_age_ms", age_ms_},
            {"lateness_ms", lateness_ms_},
            {"drift_ppm", drift_ppm_},
            {"clock_uncertainty_us", uncertainty_us_},
            {"device_wraps", wraps_},
            {"daemon_faults", static_cast<double>(std::popcount(faults >> kRobotFaults))}};
  }

  std::uint64_t commands = 0, wild = 0;
  FaultMask faults = 0;  ///< that ended the first run

 private:
  void look(const StepRecord& record) {
    const Snapshot& snapshot = record.snapshot;
    if (last_ns_ > 0)
      lateness_ms_ = std::max(lateness_ms_, to_s(record.now_ns - last_ns_) * 1e3 - 5.0);
    last_ns_ = record.now_ns;
    if (snapshot.run_state == RunState::kAborted && faults == 0) faults = snapshot.faults;
    if (snapshot.run_state != RunState::kRunning) return;
    age_ms_ = std::max(age_ms_, static_cast<double>(snapshot.age_us) * 1e-3);
    drift_ppm_ = std::abs(record.inputs.clock.drift) * 1e6;
    uncertainty_us_ = std::max(uncertainty_us_, record.inputs.clock.uncertainty_us);
    wraps_ = static_cast<double>(snapshot.sample.device_us >> 32);
  }
  void look_at_command(const StepRecord& record) {
    ++commands;
    const Command& command = record.snapshot.command;
    const auto within = [](double value, double most) { return std::abs(value) <= most; };
    const bool tame = within(command.pose.x_m, 1e4) && within(command.pose.y_m, 1e4) &&
                      within(command.pose.yaw_rad, 1e3) && within(command.desired_yaw_rad, 1e3) &&
                      within(command.yaw_rate_radps, 10.0) && within(command.speed_mps, 2.0) &&
                      within(command.gyro_bias_radps, 1.0);
    const bool fresh = record.inputs.clock.to_host(command.expiry_us) > record.now_ns;
    if (!tame || !fresh) ++wild;
  }

  messages::Sink* also_;
  HostNs last_ns_ = 0;
  double age_ms_ = 0.0, lateness_ms_ = 0.0, drift_ppm_ = 0.0, uncertainty_us_ = 0.0, wraps_ = 0.0;
};

std::vector<Figure> figures_of(const LinkCounters& link, const StepMonitor& steps) {
  std::vector<Figure> all = steps.figures();
  const auto add = [&](std::string_view name, std::uint64_t count) {
    all.push_back({name, static_cast<double>(count)});
  };
  add("corrupted", link.corrupted());
  visit_fields(add, link);
  return all;
}

std::string end_of(const report::RunResult& result) {
  return result.completed ? std::string(kCompleted) : result.cause;
}

course::Course short_course() {
  course::Course course = load_course("1-straight");
  course.path = {course::Line{kCourseM}};
  return course;
}

bool off_in_time(const FaultTrial& trial, const FaultOutcome& outcome) {
  return trial.off_within_s == 0.0 || outcome.off_after_s <= trial.off_within_s;
}

bool again_as_it_must(const FaultTrial& trial, const FaultOutcome& outcome) {
  return outcome.again == (trial.again_s > 0.0 ? kCompleted : "");
}

}  // namespace

std::span<const FaultTrial> fault_trials() { return kTrials; }

FaultOutcome try_fault(const FaultTrial& trial, BoardKind board, messages::Sink* sink,
                       std::uint64_t seed) {
  const Loaded loaded = load({});
  std::vector<PlannedFault> faults;
  if (!trial.fault.empty()) faults.push_back(parse_fault(trial.fault));
  const HostNs begin_ns = faults.empty() ? 0 : faults[0].begin_ns;
  StepMonitor steps(sink);
  FaultOutcome outcome;
  HostNs opened_ns = -1, driven_ns = -1;
  const LockstepSettings settings{
      .course = short_course(),
      .robot = loaded.robot,
      .configuration = loaded.configuration,
      .board = board,
      .seed = seed,
      .faults = faults,
      .watch =
          [&](const EmulatedRobot& robot) {
            if (opened_ns < 0) opened_ns = robot.now_ns();
            const MotorDuty duty = robot.motor_duty();
            const bool second =
                trial.again_s > 0.0 && to_s(robot.now_ns() - opened_ns) > trial.again_s;
            if (!second && (duty.left != 0.0 || duty.right != 0.0)) driven_ns = robot.now_ns();
          },
      .sinks = {&steps},
      .on_session_event =
          [&](const link::SessionEvent& event, const wire::Hello& hello) {
            outcome.session_messages.push_back({event, hello});
          },
      .begin_within_s = kBeginWithinS};
  report::RunResult last;
  if (trial.again_s > 0.0) {
    const TwoRuns runs = run_lockstep_twice(settings, trial.again_s);
    outcome.end = end_of(runs.first);
    outcome.again = end_of(runs.again);
    last = runs.again;
  } else {
    last = run_lockstep(settings);
    outcome.end = end_of(last);
  }
  outcome.figures = figures_of(last.link, steps);
  for (const Figure& figure : outcome.figures)
    if (figure.name == trial.counter) outcome.counted = figure.value;
  outcome.off_after_s = driven_ns < 0 ? 0.0 : to_s(driven_ns - opened_ns - begin_ns);
  outcome.commands = steps.commands;
  outcome.wild = steps.wild;
  outcome.faults = steps.faults;
  outcome.as_expected = outcome.end == trial.end && outcome.wild == 0 &&
                        outcome.counted >= trial.at_least && off_in_time(trial, outcome) &&
                        again_as_it_must(trial, outcome);
  return outcome;
}

std::string expected_effect(const FaultTrial& trial) {
  std::string text(trial.end);
  text += ", counted as " + std::string(trial.counter);
  if (trial.off_within_s > 0.0)
    text += text::format(", motors off within %.2f s", trial.off_within_s);
  if (trial.again_s > 0.0) text += ", the next start completed";
  return text;
}

std::string seen_effect(const FaultTrial& trial, const FaultOutcome& outcome) {
  std::string text = "as expected";
  if (!outcome.as_expected)
    text = text::format("%s, %g counted, %u commands out of range, next start: %s",
                        outcome.end.c_str(), outcome.counted, static_cast<unsigned>(outcome.wild),
                        outcome.again.c_str());
  if (trial.off_within_s > 0.0) text += text::format(", off after %.2f s", outcome.off_after_s);
  return text;
}

}  // namespace tp100::sim
