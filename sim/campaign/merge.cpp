#include "sim/campaign/merge.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.h"

namespace tp100::sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kWorst = 5;

// True for figures about the machine that drove the run.
bool of_the_machine(const std::string& key) {
  return key == "loop" || key.find("time") != std::string::npos;
}

double number_of(const Json& json) { return json.is_null() ? HUGE_VAL : json.get<double>(); }

void flatten(const Json& json, const std::string& name, std::map<std::string, double>& out) {
  if (json.is_object()) {
    for (const auto& [key, value] : json.items())
      if (!of_the_machine(key)) flatten(value, name.empty() ? key : name + "." + key, out);
  } else if (json.is_number()) {
    out[name] = json.get<double>();
  } else if (json.is_array() && !json.empty()) {
    double most = -HUGE_VAL;
    for (const Json& one : json) {
      if (!one.is_number() && !one.is_null()) return;
      most = std::max(most, number_of(one));
    }
    out[name] = most;
  }
}

/// A sampled value as text, in the form that parse_run_file keeps.
std::string sampled_text(const text::TomlValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return std::visit([](const auto& one) { return Json(one).dump(); }, value);
}

std::set<std::string> figure_names(const std::vector<MergedRun>& runs) {
  std::set<std::string> names;
  for (const MergedRun& run : runs)
    if (run.completed)
      for (const auto& [name, value] : run.figures) names.insert(name);
  return names;
}

/// The completed runs that have the figure.
std::vector<const MergedRun*> having(const std::vector<MergedRun>& runs, const std::string& name) {
  std::vector<const MergedRun*> found;
  for (const MergedRun& run : runs)
    if (run.completed && run.figures.contains(name)) found.push_back(&run);
  return found;
}

MergedFigure figure_of(const std::vector<MergedRun>& runs, const std::string& name) {
  MergedFigure figure{.name = name};
  std::vector<double> values;
  std::map<std::string, std::pair<std::vector<double>, std::vector<double>>> pairs;
  for (const MergedRun* run : having(runs, name)) {
    const double value = run->figures.at(name);
    values.push_back(value);
    figure.worst.emplace_back(run->index, value);
    for (const auto& [sampled, number] : run->sampled_numbers) {
      pairs[sampled].first.push_back(number);
      pairs[sampled].second.push_back(value);
    }
  }
  figure.summary = summarise(std::move(values));
  std::stable_sort(figure.worst.begin(), figure.worst.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  figure.worst.resize(std::min(figure.worst.size(), kWorst));
  for (const auto& [sampled, both] : pairs)
    if (const auto rank = rank_correlation(both.first, both.second))
      figure.correlations.emplace_back(sampled, *rank);
  return figure;
}

MergedGroup group_of(const std::vector<MergedRun>& runs, const std::string& variable,
                     const std::string& value) {
  std::vector<MergedRun> members;
  for (const MergedRun& run : runs) {
    const auto sampled = run.sampled.find(variable);
    if (sampled != run.sampled.end() && sampled->second == value && run.refused.empty())
      members.push_back(run);
  }
  MergedGroup group{.variable = variable, .value = value, .driven = members.size()};
  for (const MergedRun& run : members) group.completed += std::size_t{run.completed};
  for (const std::string& name : figure_names(members)) {
    std::vector<double> values;
    for (const MergedRun* run : having(members, name)) values.push_back(run->figures.at(name));
    group.figures[name] = summarise(std::move(values));
  }
  return group;
}

Json json_of(const Interval& interval) {
  return interval ? Json({interval->first, interval->second}) : Json(nullptr);
}

Json json_of(const Summary& summary) {
  Json json = {
      {"count", summary.count}, {"mean", summary.mean}, {"mean_95", json_of(summary.mean_interval)},
      {"sd", summary.sd},       {"min", summary.least}, {"max", summary.most}};
  for (const Percentile& percentile : summary.percentiles) {
    const std::string name = "p" + std::to_string(std::lround(percentile.share * 100.0));
    json[name] = percentile.value;
    json[name + "_95"] = json_of(percentile.interval);
  }
  return json;
}

Json json_of_sampled(const MergedRun& run) {
  Json json = Json::object();
  for (const auto& [name, text] : run.sampled) {
    const auto number = run.sampled_numbers.find(name);
    json[name] = number == run.sampled_numbers.end() ? Json(text) : Json(number->second);
  }
  return json;
}

/// The run, its outcome `text` under the key `what`, and its sampled values.
Json json_of(const MergedRun& run, const char* what, const std::string& text) {
  return {
      {"index", run.index}, {"seed", run.seed}, {what, text}, {"sampled", json_of_sampled(run)}};
}

Json json_of(const MergedFigure& figure, const Merged& merged) {
  Json json = json_of(figure.summary);
  Json& worst = json["worst"] = Json::array();
  for (const auto& [index, value] : figure.worst)
    worst.push_back({{"index", index}, {"seed", merged.run(index).seed}, {"value", value}});
  Json& correlations = json["rank_correlation"] = Json::object();
  for (const auto& [name, value] : figure.correlations) correlations[name] = value;
  return json;
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + "\"";
}

}  // namespace

const MergedRun& Merged::run(std::uint64_t index) const {
  return *std::lower_bound(
      runs.begin(), runs.end(), index,
      [](const MergedRun& one, std::uint64_t wanted) { return one.index < wanted; });
}

std::vector<const MergedRun*> Merged::failed() const {
  std::vector<const MergedRun*> found;
  for (const MergedRun& run : runs)
    if (run.refused.empty() && !run.completed) found.push_back(&run);
  return found;
}

std::vector<std::pair<std::string, std::size_t>> Merged::causes() const {
  std::map<std::string, std::size_t> counts;
  for (const MergedRun* run : failed()) ++counts[run->cause];
  std::vector<std::pair<std::string, std::size_t>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return sorted;
}

std::optional<MergedRun> parse_run_file(const std::string& text) {
  MergedRun run;
  try {
    const Json json = Json::parse(text);
    run.index = json.at("index").get<std::uint64_t>();
    run.seed = json.at("seed").get<std::uint64_t>();
    for (const auto& [name, value] : json.at("sampled").items()) {
      run.sampled[name] = value.is_string() ? value.get<std::string>() : value.dump();
      if (value.is_number()) run.sampled_numbers[name] = value.get<double>();
    }
    if (json.contains("refused")) {
      run.refused = json.at("refused").get<std::string>();
    } else {
      run.completed = json.at("result").at("completed").get<bool>();
      if (!run.completed) run.cause = json.at("result").value("cause", "unknown");
      flatten(json.at("result"), "", run.figures);
      run.figures.erase("seed");
    }
  } catch (const Json::exception&) {
    return std::nullopt;
  }
  return run;
}

Merged merge(const CampaignSpec& spec, std::vector<MergedRun> runs) {
  Merged merged{.asked = spec.runs};
  std::set<std::uint64_t> there;
  for (const MergedRun& run : runs) {
    there.insert(run.index);
    merged.driven += std::size_t{run.refused.empty()};
    merged.completed += std::size_t{run.completed};
  }
  for (std::uint64_t index = 0; index < spec.runs; ++index)
    if (!there.contains(index)) merged.missing.push_back(index);
  merged.runs = std::move(runs);
  for (const std::string& name : figure_names(merged.runs))
    merged.figures.push_back(figure_of(merged.runs, name));
  const auto add_groups = [&](const std::vector<Variable>& variables, const std::string& prefix) {
    for (const Variable& variable : variables)
      if (const auto* list = std::get_if<List>(&variable.source))
        for (const text::TomlValue& value : *list)
          merged.groups.push_back(
              group_of(merged.runs, prefix + variable.name, sampled_text(value)));
  };
  add_groups(spec.choices, "");
  add_groups(spec.configuration, "");
  add_groups(spec.robot, "robot_values.");
  return merged;
}

std::string merged_json(const Merged& merged) {
  Json json = {{"runs", merged.asked},
               {"missing", merged.missing},
               {"driven", merged.driven},
               {"completed", merged.completed}};
  if (merged.driven > 0) {
    const auto [low, high] = share_interval(merged.completed, merged.driven);
    json["completed_share_95"] = {low, high};
  }
  Json& causes = json["causes"] = Json::object();
  for (const auto& [cause, count] : merged.causes()) causes[cause] = count;
  Json& failed = json["failed"] = Json::array();
  for (const MergedRun* run : merged.failed()) failed.push_back(json_of(*run, "cause", run->cause));
  Json& refused = json["refused"] = Json::array();
  for (const MergedRun& run : merged.runs)
    if (!run.refused.empty()) refused.push_back(json_of(run, "why", run.refused));
  Json& figures = json["figures"] = Json::object();
  for (const MergedFigure& figure : merged.figures) figures[figure.name] = json_of(figure, merged);
  Json& groups = json["groups"] = Json::array();
  for (const MergedGroup& group : merged.groups) {
    Json one = {{"variable", group.variable},
                {"value", group.value},
                {"driven", group.driven},
                {"completed", group.completed}};
    for (const auto& [name, summary] : group.figures) one["figures"][name] = json_of(summary);
    groups.push_back(std::move(one));
  }
  return json.dump(1) + "\n";
}

std::string merged_csv(const Merged& merged) {
  std::set<std::string> sampled, figures;
  for (const MergedRun& run : merged.runs) {
    for (const auto& [name, value] : run.sampled) sampled.insert(name);
    for (const auto& [name, value] : run.figures) figures.insert(name);
  }
  std::string text = "index,seed,completed,cause,refused";
  for (const std::set<std::string>* names : {&sampled, &figures})
    for (const std::string& name : *names) text += "," + csv_cell(name);
  for (const MergedRun& run : merged.runs) {
    text += "\n" + std::to_string(run.index) + "," + std::to_string(run.seed) + "," +
            (run.completed ? "1" : "0") + "," + csv_cell(run.cause) + "," + csv_cell(run.refused);
    for (const std::string& name : sampled) {
      const auto value = run.sampled.find(name);
      text += "," + (value == run.sampled.end() ? "" : csv_cell(value->second));
    }
    for (const std::string& name : figures) {
      const auto value = run.figures.find(name);
      text += ",";
      if (value != run.figures.end())
        text += std::isfinite(value->second) ? Json(value->second).dump() : "inf";
    }
  }
  return text + "\n";
}

}  // namespace tp100::sim
