#include <CLI/CLI.hpp>
#include <cstdio>
#include <utility>

#include "app/commands.h"
#include "bridge/step.h"
#include "core/enum_names.h"
#include "core/error.h"
#include "core/processor.h"
#include "course/bundled_files.h"
#include "text/atomic_file.h"
#include "text/command_line.h"
#include "text/format.h"

namespace tp100::app {
namespace {

using record::Recording;

/// Thrown to end the reading early.
struct Enough {};

constexpr const char* kHeader =
    "t_s,x_m,y_m,z_m,roll_rad,pitch_rad,yaw_rad,vx_mps,vy_mps,yaw_rate_radps,slip_left,slip_"
    "right\n";

/// One row of an estimate's poses, in full double precision.
std::string row_of(const Snapshot& snapshot, PoseSource source, double t_s) {
  const bool fused = source == PoseSource::kFused;
  std::string row = text::format("%.17g", t_s);
  const auto add = [&row](auto, double value) { row += text::format(",%.17g", value); };
  visit_fields(add, snapshot.estimates[source].pose);
  visit_fields(add, snapshot.estimates[source].twist);
  add("slip_left", fused ? snapshot.filter.slip_left : snapshot.slip_left);
  add("slip_right", fused ? snapshot.filter.slip_right : snapshot.slip_right);
  return row + "\n";
}

std::string seconds(HostNs ns) { return text::format("%.3f s", to_s(ns)); }

void compare(const StepRecord& recorded, const StepRecord& computed, Replayed& result) {
  if (!result.differs_at) {
    auto difference = record::first_difference(recorded, computed);
    if (!difference) return;
    result.differs_at = recorded.step;
    result.differs_ns = recorded.now_ns;
    result.difference = std::move(*difference);
  }
  result.largest.add(recorded, computed);
}

std::string shown(const record::LargestDifference& largest) {
  return text::format("the largest difference is %.2g m, %.2g rad and %.2g in other results",
                      largest.length_m, largest.angle_rad, largest.other);
}

void print_difference(const Recording& recording, const Replayed& result) {
  std::fprintf(stderr, "tp100d: %s: step %llu after %s: %s is %s, recorded %s (version %s)\n",
               recording.path().c_str(), static_cast<unsigned long long>(*result.differs_at),
               seconds(result.differs_ns - recording.start_ns()).c_str(),
               result.difference.field.c_str(), result.difference.computed.c_str(),
               result.difference.recorded.c_str(), one_line(recording.fact("version"), 20).c_str());
}

}  // namespace

config::RunFiles recorded_files(const Recording& recording) {
  const auto file = [&](const char* name, const std::string& fallback) {
    return course::TextFile{recording.path() + "/" + fallback, recording.file(name)};
  };
  config::RunFiles files;
  files.configuration = file(config::kConfigurationFile, config::kConfigurationFile);
  files.robot = file(config::kRobotFile, recording.fact("robot") + ".toml");
  if (files.robot.text.empty())
    throw UserError(recording.path() + ": contains no robot file, so it cannot be replayed");
  files.course = file(config::kCourseFile, recording.fact("course") + ".toml");
  const auto setup = value_in(bridge::kSetupNames, recording.fact("setup"));
  if (!setup)
    throw UserError(recording.path() + ": does not name the set-up, so it cannot be replayed");
  files.setup = *setup;
  // Recordings without this fact are from a time with one kind only.
  files.world = value_in(bridge::kWorldKindNames, recording.fact("world")).value_or(files.world);
  return files;
}

Replayed replay_steps(const Recording& recording, const bridge::Parameters& parameters,
                      std::shared_ptr<const course::Course> course, bool verify,
                      const std::function<void(const StepRecord&)>& each) {
  Replayed result;
  bridge::Step step(parameters, std::move(course));
  const auto computed = std::make_unique<StepRecord>();
  const auto once_more = [&](const StepRecord& recorded) -> const bridge::Outputs& {
    if (result.steps == 0 && !recorded.inputs.restart.empty()) result.first = recorded.step;
    if (recorded.step != result.first + result.steps) {
      result.gap_before = recorded.step;
      throw Enough{};
    }
    result.last_ns = recorded.now_ns;
    if (verify || recorded.inputs.restart.empty()) return step(recorded.inputs, recorded.now_ns);
    // With other parameters only the state at the beginning is the recorded one, without its
    // parameters.
    StepInputs inputs = recorded.inputs;
    inputs.restart[0].parameters.clear();
    if (result.steps > 0) inputs.restart.clear();
    return step(inputs, recorded.now_ns);
  };
  const auto before = [&](const StepRecord& recorded) {
    once_more(recorded);
    ++result.steps;
    ++result.before;
  };
  const auto take = [&](const StepRecord& recorded) {
    const bridge::Outputs& out = once_more(recorded);
    *computed = recorded;
    computed->command_valid = out.command_valid;
    computed->request = out.request;
    computed->snapshot = out.snapshot;
    if (verify) compare(recorded, *computed, result);
    ++result.steps;
    each(*computed);
  };
  try {
    recording.visit({.before = before, .step = take});
  } catch (const Enough&) {
  }
  return result;
}

int run_replay(const ReplayOptions& options) {
  const Recording recording(options.in);
  config::RunFiles files = recorded_files(recording);
  const bool verify = options.config.empty();
  if (!verify) files.configuration = course::read_text_file(options.config);
  const config::RunSetup run = config::parse_run(files);

  text::FileReplacement out(options.out);
  out.write(kHeader);
  const HostNs start = recording.start_ns();
  const Replayed result =
      replay_steps(recording, run.parameters, run.course, verify, [&](const StepRecord& record) {
        if (record.inputs.samples.empty()) return;
        out.write(row_of(record.snapshot, run.parameters.steering,
                         to_s(record.snapshot.sample.measured_ns - start)));
      });

  const std::string& path = recording.path();
  const std::string recorded_on = one_line(recording.fact(config::kArithmeticFact), 60);
  // Recordings without this fact are assumed to be of this kind of processor.
  const bool elsewhere = !recorded_on.empty() && recorded_on != arithmetic();
  const std::string processors =
      elsewhere ? "recorded on " + recorded_on + ", replayed on " + arithmetic() : "";
  const bool differs =
      elsewhere ? !result.largest.within(kRounding) : result.differs_at.has_value();
  if (!recording.whole())
    std::printf("%s: the recording is cut off at %s\n", path.c_str(),
                seconds(result.last_ns - start).c_str());
  if (differs) {
    print_difference(recording, result);
    if (elsewhere)
      std::fprintf(stderr, "tp100d: %s: differs by more than rounding: %s%s; %s\n", path.c_str(),
                   shown(result.largest).c_str(),
                   result.largest.decided ? ", and a decision or a count differs" : "",
                   processors.c_str());
    return 1;
  }
  if (result.gap_before) {
    std::fprintf(stderr,
                 "tp100d: %s: steps %s to %s are missing; what follows cannot be replayed\n",
                 path.c_str(), std::to_string(result.first + result.steps).c_str(),
                 std::to_string(*result.gap_before - 1).c_str());
    return 1;
  }
  out.commit();
  const std::string verdict = !verify ? "with other parameters than recorded"
                              : !result.differs_at
                                  ? "every pose and command as recorded, bit for bit"
                                  : shown(result.largest);
  std::printf("%s: %s replayed, %s%s\n", path.c_str(),
              text::counted(result.steps - result.before, "step").c_str(), verdict.c_str(),
              elsewhere ? (" (" + processors + ")").c_str() : "");
  return 0;
}

void add_replay(CLI::App& app, Action& action) {
  static ReplayOptions options;
  CLI::App* command = app.add_subcommand("replay", "Repeat a recording, and write its poses");
  text::option(command, "IN", options.in, "FILE", "Recording or its folder: verified bit for bit")
      ->required();
  text::option(command, "--out", options.out, "FILE",
               "CSV file of the steering poses to write [s, m, rad]")
      ->required();
  text::option(command, "--config", options.config, "FILE", "Configuration (default: as recorded)");
  command->footer("Example: tp100d replay runs/RUN");
  command->callback([&action] { action = [] { return run_replay(options); }; });
}

}  // namespace tp100::app
