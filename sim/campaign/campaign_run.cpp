#include "sim/campaign/campaign_run.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "core/error.h"
#include "report/metrics.h"
#include "report/result_json.h"
#include "sim/robot/lockstep.h"
#include "sim/robot/run_recorder.h"

namespace tp100::sim {
namespace {

using Json = nlohmann::ordered_json;

Json figures_of(const PlannedRun& run, const std::string& record) {
  Loaded loaded = load(run.options);
  loaded.files.course = course::read_bundled(course::Bundled::kCourses, run.course);
  const course::Course course =
      course::parse_course(loaded.files.course.text, loaded.files.course.path);
  std::optional<RunRecorder> recorder;
  if (!record.empty()) recorder.emplace(record, loaded, run.options.seed);
  const report::RunResult result = run_lockstep(
      {.course = course,
       .robot = loaded.robot,
       .configuration = loaded.configuration,
       .setup = loaded.setup,
       .board = loaded.board,
       .camera = run.camera.empty() ? std::nullopt : std::optional(load_camera(run.camera)),
       .seed = run.options.seed,
       .faults = parse_faults(run.faults),
       .sink = recorder ? &*recorder : nullptr});
  if (recorder) recorder->finish();
  return Json::parse(report::result_json(result, report::figures(result, course)));
}

}  // namespace

CampaignRun drive(const PlannedRun& run, const std::string& record) {
  CampaignRun done;
  Json json = {{"index", run.index}, {"seed", run.options.seed}};
  Json& drawn = json["drawn"] = Json::object();
  for (const auto& [name, value] : run.drawn)
    std::visit([&drawn, &key = name](const auto& one) { drawn[key] = one; }, value);
  try {
    json["result"] = figures_of(run, record);
  } catch (const SetupError& error) {
    done.refused = true;
    json["refused"] = error.what();
  }
  done.json = json.dump() + "\n";
  return done;
}

}  // namespace tp100::sim
