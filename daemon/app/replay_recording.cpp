#include "app/replay_recording.h"

#include <array>
#include <cstdio>
#include <utility>

#include "text/atomic_file.h"
#include "text/toml_document.h"

namespace tp100::app {
namespace {

using record::Recording;

/// Ends the reading from within.
struct Enough {};

/// The poses of one estimate, as a row shows them.
struct Row {
  const Pose& pose;
  const Twist& twist;
  double slip_left, slip_right;
};

Row row_of(const Snapshot& snapshot, ReplayModel model) {
  switch (model) {
    case ReplayModel::kOdometry:
      return {snapshot.odometry, snapshot.odometry_twist, snapshot.slip_left, snapshot.slip_right};
    case ReplayModel::kFused:
      return {snapshot.fused.pose, snapshot.fused.twist, snapshot.fused.slip_left,
              snapshot.fused.slip_right};
    case ReplayModel::kPaper:
    case ReplayModel::kExtended:
      break;
  }
  return {snapshot.model, snapshot.model_twist, snapshot.slip_left, snapshot.slip_right};
}

ReplayModel steering_model(const bridge::Parameters& parameters) {
  switch (parameters.steering) {
    case bridge::Steering::kModel:
      break;
    case bridge::Steering::kOdometry:
      return ReplayModel::kOdometry;
    case bridge::Steering::kFused:
      return ReplayModel::kFused;
  }
  return parameters.paper_model ? ReplayModel::kPaper : ReplayModel::kExtended;
}

std::string seconds(HostNs ns) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.3f s", to_s(ns));
  return text.data();
}

}  // namespace

bridge::Inputs inputs_of(const StepRecord& record) {
  return {.samples = std::span(record.samples).first(record.sample_count),
          .requests = std::span(record.requests).first(record.request_count),
          .camera = std::span(record.camera).first(record.camera_count),
          .world = std::span(record.world).first(record.world_count),
          .changes = std::span(record.changes).first(record.change_count),
          .session = record.session,
          .clock = record.clock,
          .session_number = record.session_number,
          .robot_rebooted = record.robot_rebooted,
          .answer = record.answer};
}

config::RunFiles recorded_files(const Recording& recording) {
  const auto file = [&](const char* name, const std::string& fallback) {
    return course::TextFile{recording.path() + "/" + fallback, recording.file(name)};
  };
  config::RunFiles files;
  files.configuration = file(config::kConfigurationFile, config::kConfigurationFile);
  files.robot = file(config::kRobotFile, recording.fact("robot") + ".toml");
  if (files.robot.text.empty())
    throw SetupError(recording.path() + ": the robot file is not in it; it cannot be replayed");
  files.course = file(config::kCourseFile, recording.fact("course") + ".toml");
  const auto setup = bridge::setup_named(recording.fact("setup"));
  if (!setup) throw SetupError(recording.path() + ": the set-up is not in it");
  files.setup = *setup;
  // Recordings without the fact had no other.
  files.world = bridge::world_kind_named(recording.fact("world")).value_or(files.world);
  return files;
}

Replayed replay_steps(const Recording& recording, const bridge::Parameters& parameters,
                      std::shared_ptr<const course::Course> course, bool verify,
                      const std::function<void(const StepRecord&)>& each) {
  Replayed result;
  bridge::Step step(parameters, std::move(course));
  const auto computed = std::make_unique<StepRecord>();
  const auto once_more = [&](const StepRecord& recorded) -> const bridge::Outputs& {
    if (recorded.step != result.steps + 1) {
      result.gap_before = recorded.step;
      throw Enough{};
    }
    result.last_ns = recorded.now_ns;
    return step(inputs_of(recorded), recorded.now_ns);
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
    if (verify) {
      if (auto difference = record::first_difference(recorded, *computed)) {
        result.differs_at = recorded.step;
        result.difference = std::move(*difference);
        throw Enough{};
      }
    }
    ++result.steps;
    each(*computed);
  };
  try {
    recording.visit({.before = before, .step = take});
  } catch (const Enough&) {
  }
  return result;
}

int run_replay_recording(const ReplayOptions& options) {
  const Recording recording(options.in);
  config::RunFiles files = recorded_files(recording);
  bool verify = true;
  if (!options.config.empty()) {
    files.configuration = course::read_text_file(options.config);
    verify = false;
  }
  config::RunSetup run = config::parse_run(files);
  ReplayModel model = steering_model(run.parameters);
  if (!options.model.empty()) {
    model = replay_model(options.model);
    const bool paper = model == ReplayModel::kPaper;
    if ((paper || model == ReplayModel::kExtended) && paper != run.parameters.paper_model) {
      run.parameters.paper_model = paper;
      verify = false;
    }
  }

  text::FileReplacement out(options.out);
  out.write(kReplayHeader);
  const HostNs start = recording.start_ns();
  const Replayed result =
      replay_steps(recording, run.parameters, run.course, verify, [&](const StepRecord& record) {
        if (record.sample_count == 0) return;
        const Row row = row_of(record.snapshot, model);
        out.write(replay_row(to_s(record.snapshot.sample.measured_ns - start), row.pose, row.twist,
                             {row.slip_left, row.slip_right}));
      });

  const std::string& path = recording.path();
  if (!recording.whole())
    std::printf("%s: cut off at %s\n", path.c_str(), seconds(result.last_ns - start).c_str());
  if (result.gap_before) {
    std::fprintf(stderr,
                 "tp100d: %s: steps %s to %s are missing; what follows cannot be replayed\n",
                 path.c_str(), std::to_string(result.steps + 1).c_str(),
                 std::to_string(*result.gap_before - 1).c_str());
    return 1;
  }
  if (result.differs_at) {
    std::fprintf(stderr, "tp100d: %s: step %llu after %s: %s is %s, recorded %s (version %s)\n",
                 path.c_str(), static_cast<unsigned long long>(*result.differs_at),
                 seconds(result.last_ns - start).c_str(), result.difference.field.c_str(),
                 result.difference.computed.c_str(), result.difference.recorded.c_str(),
                 text::one_line(recording.fact("version"), 20).c_str());
    return 1;
  }
  out.commit();
  std::printf("%s: %llu steps replayed, %s\n", path.c_str(),
              static_cast<unsigned long long>(result.steps - result.before),
              verify ? "every pose and command as recorded, bit for bit"
                     : "with other parameters than recorded");
  return 0;
}

}  // namespace tp100::app
