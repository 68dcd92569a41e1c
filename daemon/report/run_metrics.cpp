#include "report/run_metrics.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/arithmetic.h"
#include "report/result_text.h"
#include "report/run_result.h"

namespace tp100::report {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::optional<RunFigures> judged(const RecordedRun& run) {
  if (run.runs == 0 || !run.has_truth || run.run_context.course == nullptr) return std::nullopt;
  return figures(run.result, *run.run_context.course);
}

Difference model_from_odometry(const RecordedRun& run) {
  Difference difference;
  for (const TrajectoryPoint& point : run.result.points) {
    const Pose& model = point.estimates[PoseSource::kModel];
    const Pose& odometry = point.estimates[PoseSource::kOdometry];
    difference.final_m = magnitude(model.x_m - odometry.x_m, model.y_m - odometry.y_m);
    difference.max_m = std::max(difference.max_m, difference.final_m);
  }
  return difference;
}

std::vector<std::pair<std::string, std::uint64_t>> counters_of(const LinkCounters& link) {
  std::vector<std::pair<std::string, std::uint64_t>> counters;
  visit_fields([&](auto name, std::uint64_t count) { counters.emplace_back(name, count); }, link);
  return counters;
}

std::string metrics_json(const RecordedRun& run, const std::optional<RunFigures>& figures) {
  Json json = Json::parse(result_json(run.result, figures.value_or(RunFigures{})));
  json.erase("realtime_factor");
  json.erase("loop");
  if (!figures)
    for (const char* name : {"baselines", "tracking", "slope"}) json[name] = nullptr;
  json["truth"] = run.has_truth;
  json["steering"] = to_string(run.run_context.steering);
  json["estimated"] = nullptr;
  json["differences"] = nullptr;
  if (run.runs > 0) {
    json["estimated"] = {{"max_cross_track_m", run.estimated.max_cross_track_m},
                         {"rms_cross_track_m", run.estimated.rms_cross_track_m},
                         {"max_heading_error_rad", run.estimated.max_heading_error_rad}};
    const Difference difference = model_from_odometry(run);
    json["differences"] = {
        {"model_from_odometry", {{"max_m", difference.max_m}, {"final_m", difference.final_m}}}};
  }
  json["timing"] = {{"rate_hz", run.run_context.rate_hz},
                    {"jitter_us", run.jitter},
                    {"sample_age_us", run.sample_age},
                    {"world_age_us", run.world_age.count > 0 ? Json(run.world_age) : Json()}};
  json["link"] = Json::object();
  for (const auto& [name, value] : counters_of(run.result.link)) json["link"][name] = value;
  json["recording"] = {{"file", run.path},
                       {"whole", run.whole},
                       {"runs", run.runs},
                       {"steps", run.steps},
                       {"missing_steps", run.missing_steps},
                       {"implausible_points", run.implausible},
                       {"points_of_every", run.every}};
  json["versions"] = Json::object();
  for (const char* name : {"program", "version", "start_unix_ns"})
    if (run.facts.contains(name)) json["versions"][name] = run.facts.at(name);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tp100::report
