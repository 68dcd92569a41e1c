#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include "core/clock.h"
#include "core/error.h"
#include "identify/drive_file.h"
#include "loop/pacing.h"
#include "report/metrics.h"
#include "report/result_text.h"
#include "report/run_result.h"
#include "ros2/publisher.h"
#include "sim/robot/commands.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/lockstep_recorder.h"
#include "sim/sensors/detections.h"
#include "text/atomic_file.h"

namespace tp100::sim {
namespace {

/// All topics of a run in virtual time, slowed down to real time, so that subscribers that run in
/// real time can follow.
class VirtualTopics : public messages::Sink, public messages::TruthSink {
 public:
  /// Does not wait for subscribers; late ones receive latched topics.
  VirtualTopics(ros2::Participant& participant, const messages::RunContext& run_context)
      : publisher_(participant, run_context, {}, true) {}
  void take(const StepRecord& record) override {
    loop::sleep_until(began_ns_ + record.now_ns);
    publisher_.take(record);
  }
  void take_truth(HostNs at, const Pose& truth) override { publisher_.take_truth(at, truth); }

 private:
  ros2::Publisher publisher_;
  const HostNs began_ns_ = monotonic_now();
};

std::unique_ptr<ros2::Participant> participant_of(const CourseCommand& command) {
  if (command.ros2.empty()) return nullptr;
  std::vector<ros2::Topic> published(ros2::kLiveTopics.begin(), ros2::kLiveTopics.end());
  published.insert(published.end(), ros2::kVirtualTopics.begin(), ros2::kVirtualTopics.end());
  return std::make_unique<ros2::Participant>(
      config::Ros2Settings{.enabled = true, .interface = command.ros2}, "tp100_sim", published);
}

/// The drive with its host times counted from `began_ns`, like those of the poses.
identify::RecordedDrive counted_from(HostNs began_ns, identify::RecordedDrive drive) {
  const auto shift = [began_ns](double& t_s) { t_s = to_s(std::llround(t_s * 1e9) - began_ns); };
  for (identify::DriveSample& sample : drive.samples) shift(sample.t_s);
  for (identify::SeenPose& seen : drive.camera) shift(seen.t_s);
  return drive;
}

void write_results(const std::string& folder, const report::RunResult& result,
                   const std::string& json, const identify::RecordedDrive& drive) {
  text::make_folder(folder);
  const std::string stem =
      folder + "/" + result.course + "-" + result.robot + "-" + std::to_string(result.seed);
  text::write_file(stem + ".json", json + "\n");
  text::write_file(stem + ".csv", report::poses_csv(result));
  text::write_file(stem + "-samples.csv",
                   identify::write_drive(counted_from(result.began_ns.value_or(0), drive)));
}

}  // namespace

int run_course(const CourseCommand& command) {
  Loaded loaded = load(command.options);
  loaded.files.course = course::read_bundled(course::Bundled::kCourses, command.course);
  const course::Course course =
      course::parse_course(loaded.files.course.text, loaded.files.course.path);
  const bool detected = command.camera.ends_with(".tum");
  if (detected && command.runs > 1)
    throw UserError("--camera " + command.camera +
                    ": its poses belong to one drive; leave out --runs");
  const std::optional<course::EmulatedCamera> camera =
      command.camera.empty() || detected ? std::nullopt
                                         : std::optional(load_camera(command.camera));
  const std::vector<CameraSample> detections =
      detected ? read_detections(command.camera) : std::vector<CameraSample>{};
  if (command.world.starts_with("udp:")) loaded.configuration.world.address = command.world;
  loaded.files.world =
      config::world_option(command.world, loaded.configuration.parameters.world.kind);
  if (loaded.files.world == bridge::WorldKind::kFiles)
    throw UserError("world files: cannot be used in virtual time; use udp or internal");
  // Before the drive, so that an unwritable folder is reported at once.
  if (!command.out.empty()) text::make_folder(command.out);
  const std::unique_ptr<ros2::Participant> participant = participant_of(command);
  bool all_completed = true;
  for (int i = 0; i < command.runs; ++i) {
    const std::uint64_t seed = command.options.seed + static_cast<std::uint64_t>(i);
    // Times count from 0 here, because the beginning of the run is known only later.
    identify::DriveSink drive(HostNs{0});
    LockstepSettings settings{.course = course,
                              .robot = loaded.robot,
                              .configuration = loaded.configuration,
                              .setup = loaded.setup,
                              .board = loaded.board,
                              .camera = camera,
                              .detections = detections,
                              .external_world = loaded.files.world == bridge::WorldKind::kUdp,
                              .seed = seed,
                              .faults = parse_faults(command.faults)};
    std::optional<LockstepRecorder> recorder;
    if (!command.record.empty()) recorder.emplace(command.record, loaded, seed).record(settings);
    if (!command.out.empty()) settings.add(drive);
    std::optional<VirtualTopics> topics;
    if (participant)
      settings.add(
          topics.emplace(*participant, config::run_context_of(config::parse_run(loaded.files))));
    const report::RunResult result = run_lockstep(settings);
    if (recorder) recorder->finish();
    const report::RunFigures figures = report::figures(result, course);
    const std::string json = report::result_json(result, figures);
    if (command.json) {
      std::printf("%s\n", json.c_str());
    } else {
      std::printf("%s\n", report::result_table(result, figures).c_str());
    }
    std::fflush(stdout);
    if (!command.out.empty()) write_results(command.out, result, json, drive.drive());
    all_completed = all_completed && result.completed;
  }
  return all_completed ? 0 : 1;
}

}  // namespace tp100::sim
