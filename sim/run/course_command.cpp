#include "sim/run/course_command.h"

#include <cstdio>
#include <optional>

#include "analysis/drive_file.h"
#include "analysis/metrics.h"
#include "analysis/poses_csv.h"
#include "analysis/result_json.h"
#include "analysis/result_table.h"
#include "app/drive_sink.h"
#include "core/error.h"
#include "disk/atomic_file.h"
#include "sim/run/lockstep.h"
#include "sim/run/run_recorder.h"

namespace tp100::sim {
namespace {

void write_results(const std::string& folder, const analysis::RunResult& result,
                   const std::string& json, const analysis::Drive& drive) {
  disk::make_folder(folder);
  const std::string stem =
      folder + "/" + result.course + "-" + result.robot + "-" + std::to_string(result.seed);
  disk::write_file(stem + ".json", json + "\n");
  disk::write_file(stem + ".csv", analysis::poses_csv(result));
  disk::write_file(stem + "-samples.csv", analysis::write_drive(drive));
}

}  // namespace

int run_course(const CourseCommand& command) {
  Loaded loaded = load(command.options);
  loaded.files.course = app::read_bundled(app::Bundled::kCourses, command.course);
  const course::Course course =
      course::parse_course(loaded.files.course.text, loaded.files.course.path);
  const std::optional<course::EmulatedCamera> camera =
      command.camera.empty() ? std::nullopt : std::optional(load_camera(command.camera));
  if (command.world.starts_with("udp:")) loaded.configuration.world.address = command.world;
  loaded.files.world = app::world_option(command.world, loaded.configuration.parameters.world.kind);
  if (loaded.files.world == bridge::WorldKind::kFiles)
    throw SetupError("world files: have no place in virtual time; use udp or internal");
  bool all_completed = true;
  for (int i = 0; i < command.runs; ++i) {
    const std::uint64_t seed = command.options.seed + static_cast<std::uint64_t>(i);
    std::optional<RunRecorder> recorder;
    if (!command.record.empty()) recorder.emplace(command.record, loaded, seed);
    app::DriveSink drive;
    publish::SinkList sinks;
    if (!command.out.empty()) sinks.add(drive);
    if (recorder) sinks.add(*recorder);
    const analysis::RunResult result =
        run_lockstep({.course = course,
                      .robot = loaded.robot,
                      .configuration = loaded.configuration,
                      .setup = loaded.setup,
                      .board = loaded.board,
                      .camera = camera,
                      .external_world = loaded.files.world == bridge::WorldKind::kUdp,
                      .seed = seed,
                      .faults = parse_faults(command.faults),
                      .sink = sinks.empty() ? nullptr : &sinks});
    if (recorder) recorder->finish();
    const analysis::RunFigures figures = analysis::figures(result, course);
    const std::string json = analysis::result_json(result, figures);
    if (command.json) {
      std::printf("%s\n", json.c_str());
    } else {
      std::printf("%s\n", analysis::result_table(result, figures).c_str());
    }
    std::fflush(stdout);
    if (!command.out.empty()) write_results(command.out, result, json, drive.drive());
    all_completed = all_completed && result.completed;
  }
  return all_completed ? 0 : 1;
}

}  // namespace tp100::sim
