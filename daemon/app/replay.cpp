#include "app/replay.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/commands.h"
#include "core/enum_names.h"
#include "core/processor.h"
#include "course/bundled_files.h"
#include "estimation/odometry.h"
#include "estimation/standstill.h"
#include "model/track_model.h"
#include "text/atomic_file.h"
#include "text/csv_reader.h"
#include "text/format.h"
#include "text/toml_document.h"

namespace tp100::app {
namespace {

using record::Recording;

/// Thrown to end the reading early.
struct Enough {};

/// One row of an estimate's poses.
std::string row_of(const Snapshot& snapshot, PoseSource source, double t_s) {
  const Estimate& estimate = snapshot.estimates[source];
  const bool fused = source == PoseSource::kFused;
  return replay_row(t_s, estimate.pose, estimate.twist,
                    {fused ? snapshot.filter.slip_left : snapshot.slip_left,
                     fused ? snapshot.filter.slip_right : snapshot.slip_right});
}

std::string seconds(HostNs ns) { return text::format("%.3f s", to_s(ns)); }

/// One row of the input, valid until the next.
struct Row {
  double t_s = 0.0;
  double left_mps = 0.0, right_mps = 0.0;
  double slope_rad = 0.0;
  double gyro_z_radps = 0.0;
};

/// Content of one output row.
struct State {
  Pose pose{};
  Twist twist{};
  model::Slip slip{};
};

class Replay {
 public:
  Replay(ReplayModel model, const bridge::Parameters& parameters)
      : odometry_(model.source == PoseSource::kOdometry),
        parameters_(model.paper ? bridge::paper_parameters(parameters.model) : parameters.model),
        mode_(model.paper ? model::Mode::kPaper : model::Mode::kExtended),
        counts_per_metre_(parameters.drive.counts_per_metre),
        standstill_(parameters.estimation),
        estimate_(parameters_, bridge::filter_noise(parameters)) {}

  /// The state at the row's own time, with the motion that begins there.
  State begin(const Row& row) {
    row_ = row;
    if (mode_ == model::Mode::kPaper) row_.slope_rad = 0.0;
    learn_bias();
    State state;
    state.pose = pose_;
    state.pose.pitch_rad = row_.slope_rad == 0.0 ? 0.0 : -row_.slope_rad;
    state.slip = model::slip_on(parameters_, mode_, model::inclined(row_.slope_rad));
    state.twist = advanced(0.0);
    return state;
  }

  /// Advances the pose by `dt_s` with the values of the latest row.
  void advance(double dt_s) {
    advanced(dt_s);
    left_m_ += row_.left_mps * dt_s;
    right_m_ += row_.right_mps * dt_s;
  }

 private:
  Twist advanced(double dt_s) {
    Twist twist;
    const model::Incline incline = model::inclined(row_.slope_rad);
    if (odometry_) {
      estimate_.advance({.dt_s = dt_s,
                         .tracks = {row_.left_mps, row_.right_mps},
                         .gyro_z_radps = row_.gyro_z_radps,
                         .gyro = true,
                         .ground = {.horizontal_fraction = incline.horizontal_fraction,
                                    .pitch_rad = -row_.slope_rad,
                                    .slip = model::slip_on(parameters_, mode_, incline)}});
      twist = estimate_.twist();
      const double z_m = pose_.z_m + twist.vx_mps * std::sin(row_.slope_rad) * dt_s;
      pose_ = estimate_.pose();
      pose_.z_m = z_m;
    } else {
      twist = model::body_twist(parameters_, mode_, row_.left_mps, row_.right_mps, incline);
      model::advance(pose_, twist, dt_s, incline);
    }
    return twist;
  }

  void learn_bias() {
    if (!odometry_) return;
    Sample sample;
    sample.device_us = std::llround(row_.t_s * 1e6);
    sample.left_counts = std::llround(left_m_ * counts_per_metre_);
    sample.right_counts = std::llround(right_m_ * counts_per_metre_);
    sample.imu_age = 0;
    standstill_.update(sample, row_.gyro_z_radps);
    if (standstill_.rest()) estimate_.standstill(*standstill_.rest());
  }

  bool odometry_;
  model::TrackParameters parameters_;
  model::Mode mode_;
  double counts_per_metre_;
  estimation::Standstill standstill_;
  estimation::Odometry estimate_;
  Row row_{};
  Pose pose_{};
  double left_m_ = 0.0, right_m_ = 0.0;
};

Row row_of(const text::CsvTable& table, std::size_t i) {
  const auto value = [&](const char* column) { return table.has(column) ? table[column][i] : 0.0; };
  Row row{table["t_s"][i], table["left_mps"][i], table["right_mps"][i], value("slope_rad"),
          value("gyro_z_radps")};
  const auto limit = [&](const char* column, double found, double most) {
    if (std::abs(found) > most)
      throw SetupError(table.where(i) + ": " + column + " is " + text::number_text(found) +
                       ", allowed " + text::number_text(-most) + " to " + text::number_text(most));
  };
  // Unix time in seconds, or even in milliseconds, is accepted.
  limit("t_s", row.t_s, 1e13);
  limit("left_mps", row.left_mps, 100.0);
  limit("right_mps", row.right_mps, 100.0);
  limit("slope_rad", row.slope_rad, 1.57);
  limit("gyro_z_radps", row.gyro_z_radps, 1000.0);
  return row;
}

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

}  // namespace

config::RunFiles recorded_files(const Recording& recording) {
  const auto file = [&](const char* name, const std::string& fallback) {
    return course::TextFile{recording.path() + "/" + fallback, recording.file(name)};
  };
  config::RunFiles files;
  files.configuration = file(config::kConfigurationFile, config::kConfigurationFile);
  files.robot = file(config::kRobotFile, recording.fact("robot") + ".toml");
  if (files.robot.text.empty())
    throw SetupError(recording.path() + ": contains no robot file, so it cannot be replayed");
  files.course = file(config::kCourseFile, recording.fact("course") + ".toml");
  const auto setup = value_in(bridge::kSetupNames, recording.fact("setup"));
  if (!setup)
    throw SetupError(recording.path() + ": does not name the set-up, so it cannot be replayed");
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

int run_replay_recording(const ReplayOptions& options) {
  const Recording recording(options.in);
  config::RunFiles files = recorded_files(recording);
  bool verify = true;
  if (!options.config.empty()) {
    files.configuration = course::read_text_file(options.config);
    verify = false;
  }
  config::RunSetup run = config::parse_run(files);
  PoseSource source = run.parameters.steering;
  if (!options.model.empty()) {
    const ReplayModel model = replay_model(options.model);
    source = model.source;
    if (source == PoseSource::kModel && model.paper != run.parameters.paper_model) {
      run.parameters.paper_model = model.paper;
      verify = false;
    }
  }

  text::FileReplacement out(options.out);
  out.write(kReplayHeader);
  const HostNs start = recording.start_ns();
  const Replayed result =
      replay_steps(recording, run.parameters, run.course, verify, [&](const StepRecord& record) {
        if (record.inputs.samples.empty()) return;
        out.write(
            row_of(record.snapshot, source, to_s(record.snapshot.sample.measured_ns - start)));
      });

  const std::string& path = recording.path();
  const std::string recorded_on = text::one_line(recording.fact(config::kArithmeticFact), 60);
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
    std::fprintf(stderr, "tp100d: %s: step %llu after %s: %s is %s, recorded %s (version %s)\n",
                 path.c_str(), static_cast<unsigned long long>(*result.differs_at),
                 seconds(result.differs_ns - start).c_str(), result.difference.field.c_str(),
                 result.difference.computed.c_str(), result.difference.recorded.c_str(),
                 text::one_line(recording.fact("version"), 20).c_str());
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

const char* const kReplayHeader =
    "t_s,x_m,y_m,z_m,roll_rad,pitch_rad,yaw_rad,vx_mps,vy_mps,yaw_rate_radps,slip_left,slip_"
    "right\n";

std::string replay_row(double t_s, const Pose& pose, const Twist& twist, const model::Slip& slip) {
  const std::array<double, 12> values = {t_s,           pose.x_m,
                                         pose.y_m,      pose.z_m,
                                         pose.roll_rad, pose.pitch_rad,
                                         pose.yaw_rad,  twist.vx_mps,
                                         twist.vy_mps,  twist.yaw_rate_radps,
                                         slip.left,     slip.right};
  std::string text;
  for (const double value : values) text += text::format("%s%.17g", text.empty() ? "" : ",", value);
  return text + "\n";
}

ReplayModel replay_model(const std::string& name) {
  if (name == "paper") return kPaperModel;
  if (name == "extended") return kExtendedModel;
  std::vector<std::string_view> names = {"paper", "extended"};
  std::string others;
  for (const PoseSource source : kPoseSources) {
    if (source == PoseSource::kModel) continue;
    if (name == to_string(source)) return {source};
    names.push_back(to_string(source));
    others += (source == kPoseSources.back() ? " or " : ", ") + std::string(names.back());
  }
  throw SetupError("--model '" + text::one_line(name) + "' is unknown" +
                   text::suggestion(name, names) + "; use paper, extended" + others);
}

std::string replay_csv(const std::string& text, const std::string& file, ReplayModel model,
                       const bridge::Parameters& parameters) {
  if (model.source != PoseSource::kModel && model.source != PoseSource::kOdometry)
    throw SetupError(file + ": --model " + std::string(to_string(model.source)) +
                     " needs a recording; use odometry");
  const text::CsvTable table = text::parse_csv(
      text, file, {{"t_s", "left_mps", "right_mps"}, {"slope_rad", "gyro_z_radps"}});
  if (model.source == PoseSource::kOdometry && !table.has("gyro_z_radps"))
    throw SetupError(file +
                     ":1: column 'gyro_z_radps' is missing; --model odometry needs the gyro");
  Replay replay(model, parameters);
  std::string out = kReplayHeader;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const Row row = row_of(table, i);
    if (i > 0) replay.advance(row.t_s - table["t_s"][i - 1]);
    const State state = replay.begin(row);
    out += replay_row(row.t_s, state.pose, state.twist, state.slip);
  }
  return out;
}

int run_replay(const ReplayOptions& options) {
  // A corrupted recording must not be read as a CSV file.
  if (record::is_recording(options.in) || options.in.ends_with(".mcap"))
    return run_replay_recording(options);
  config::Configuration configuration;
  if (!options.config.empty()) {
    const course::TextFile file = course::read_text_file(options.config);
    configuration = config::parse_configuration(file.text, file.path);
  }
  const ReplayModel model = !options.model.empty()                 ? replay_model(options.model)
                            : configuration.parameters.paper_model ? kPaperModel
                                                                   : kExtendedModel;
  const course::TextFile robot =
      course::read_bundled(course::Bundled::kRobots, configuration.robot);
  const bridge::Parameters parameters =
      config::bridge_parameters(configuration, course::parse_robot(robot.text, robot.path));
  const course::TextFile in = course::read_text_file(options.in);
  text::write_file(options.out, replay_csv(in.text, in.path, model, parameters));
  return 0;
}

}  // namespace tp100::app
