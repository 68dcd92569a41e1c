#include "sim/run/fault_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/time.h"
#include "sim/run/lockstep.h"
#include "sim/run/options.h"

namespace tp100::sim {
namespace {

constexpr std::string_view kCompleted = "completed";
// A robot drives on for the life of a command, and the physics looks once a millisecond.
constexpr double kOffS = 0.21;

constexpr std::array kTrials = std::to_array<FaultTrial>({
    {"flip:0.0005", kCompleted, "damaged"},
    {"drop:0.0005", kCompleted, "damaged"},
    {"duplicate:0.0005", kCompleted, "damaged"},
    {"insert:0.0005", kCompleted, "damaged"},
    {"noise:64@3", kCompleted, "damaged"},
    {"delimiter:0.0005", kCompleted, "damaged"},
    {"truncate:0.02", kCompleted, "damaged"},
    {"fuse:0.02", kCompleted, "damaged"},
    {"chatter:333", kCompleted, "damaged"},
    {"chatter:150", kCompleted, "damaged"},
    {"delay:20", kCompleted, ""},
    {"jitter:5", kCompleted, ""},
    {"batch:16:to-host", kCompleted, ""},
    {"stall:10@3", kCompleted, ""},
    {"stall:100@3", kCompleted, ""},
    {"stall:2000@3", "link_lost", "", kOffS},
    {"drift:100", kCompleted, ""},
    {"drift:-1000", kCompleted, ""},
    {"wrap@4", kCompleted, ""},
    {"clock-step:500@3", "link_lost", "implausible"},
    {"sync-late:30", kCompleted, ""},
    {"sync-twice", kCompleted, "sync_rejected"},
    {"cut@3", "link_lost", "", kOffS},
    {"cut:to-robot@3", "command_timeout", "", kOffS},
    {"cut:to-host@3", "link_lost", "", kOffS + 0.2},
    {"unplug:0.05@3", "link_lost", "reconnects", kOffS},
    {"unplug:1@3", "link_lost", "", kOffS},
    {"reboot@3", "brown_out", "reboots", 0.01},
    {"reboot-loop:0.5", "never began", "reboots"},
    {"hang@3", "watchdog_reset", "reboots", kOffS, true},
    {"version:2", "never began", ""},
    {"schema", "never began", ""},
    {"board:77", kCompleted, ""},
    {"unknown-message", kCompleted, "unknown_type"},
    {"replay:20", kCompleted, "duplicated"},
    {"sequence@3", "link_lost", "reordered"},
    {"encoder-stuck:left@3", "stalled_left", ""},
    {"encoder-stuck@3", "stalled_left", ""},
    {"encoder-flip:left@3", "reversed_left", ""},
    {"encoder-jump:500:left@3", kCompleted, "implausible"},
    {"imu-missing@3", "imu_stale", ""},
    {"imu-frozen@3", "imu_stale", ""},
    {"imu-saturated@3", "imu_stale", ""},
    {"battery:5.5@3", "battery_low", ""},
    {"host-stall:100@3", kCompleted, ""},
    {"host-stall:300@3", "command_timeout", "", kOffS},
});

std::uint64_t counted(const LinkCounters& link, std::string_view name) {
  if (name == "damaged") return link.crc_errors + link.cobs_errors + link.oversize + link.undersize;
  const std::array<std::pair<std::string_view, std::uint64_t>, 7> counters{
      {{"implausible", link.implausible},
       {"sync_rejected", link.sync_rejected},
       {"reconnects", link.reconnects},
       {"reboots", link.reboots},
       {"unknown_type", link.unknown_type},
       {"duplicated", link.duplicated},
       {"reordered", link.reordered}}};
  for (const auto& [known, value] : counters)
    if (known == name) return value;
  return 0;
}

/// Looks at every command that goes out.
class CommandWatch : public publish::Sink {
 public:
  void take(const StepRecord& record) override {
    if (!record.command_valid) return;
    ++commands;
    const Command& command = record.snapshot.command;
    const auto within = [](double value, double most) { return std::abs(value) <= most; };
    const bool tame = within(command.pose.x_m, 1e4) && within(command.pose.y_m, 1e4) &&
                      within(command.pose.yaw_rad, 1e3) && within(command.desired_yaw_rad, 1e3) &&
                      within(command.yaw_rate_radps, 10.0) && within(command.speed_mps, 2.0) &&
                      within(command.gyro_bias_radps, 1.0);
    const bool fresh = record.clock.to_host(command.expiry_us) > record.now_ns;
    if (!tame || !fresh) ++wild;
  }
  std::uint64_t commands = 0, wild = 0;
};

}  // namespace

std::span<const FaultTrial> fault_trials() { return kTrials; }

FaultOutcome try_fault(const FaultTrial& trial, BoardKind board, std::uint64_t seed) {
  const Loaded loaded = load({});
  const PlannedFault fault = parse_fault(trial.fault);
  CommandWatch commands;
  std::int64_t opened_ns = -1, driven_ns = -1;
  const analysis::RunResult result =
      run_lockstep({.course = load_course("1-straight"),
                    .robot = loaded.robot,
                    .configuration = loaded.configuration,
                    .board = board,
                    .seed = seed,
                    .faults = {fault},
                    .watch =
                        [&](const EmulatedRobot& robot) {
                          if (opened_ns < 0) opened_ns = robot.now_ns();
                          const Drive drive = robot.drive();
                          if (drive.left != 0.0 || drive.right != 0.0) driven_ns = robot.now_ns();
                        },
                    .sink = &commands});
  FaultOutcome outcome;
  outcome.end = result.completed ? std::string(kCompleted) : result.cause;
  outcome.counted = counted(result.link, trial.counter);
  outcome.off_after_s = driven_ns < 0 ? 0.0 : to_s(driven_ns - opened_ns - fault.begin_ns);
  outcome.commands = commands.commands;
  outcome.wild = commands.wild;
  outcome.as_expected = outcome.end == trial.end && outcome.wild == 0 &&
                        (trial.counter.empty() || outcome.counted > 0) &&
                        (trial.off_within_s == 0.0 || outcome.off_after_s <= trial.off_within_s);
  return outcome;
}

std::string fault_table_head() {
  return "| `--fault` | board | expected | seen |\n|---|---|---|---|\n";
}

std::string fault_row(const FaultTrial& trial, BoardKind board, const FaultOutcome& outcome) {
  const auto words = [&](std::string_view end, bool counter, bool off) {
    std::string text(end);
    if (!trial.counter.empty())
      text += (counter ? ", counted as " : ", not counted as ") + std::string(trial.counter);
    if (trial.off_within_s > 0.0) text += off ? ", motors off in time" : ", motors on too long";
    return text;
  };
  std::string seen =
      words(outcome.end, outcome.counted > 0, outcome.off_after_s <= trial.off_within_s);
  if (outcome.wild > 0) seen += ", commands out of range";
  return "| `" + std::string(trial.fault) + "` | " + to_string(board) + " | " +
         words(trial.end, true, true) + " | " + seen + " |\n";
}

}  // namespace tp100::sim
