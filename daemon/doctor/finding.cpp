#include "doctor/finding.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "doctor/robot.h"
#include "text/format.h"

namespace tp100::doctor {
namespace {

using Json = nlohmann::ordered_json;

std::string padded(std::string_view text, std::size_t width) {
  std::string out(text);
  out.resize(std::max(width, out.size()), ' ');
  return out;
}

Json json_of(const Percentiles& times) {
  return {
      {"p50", times.p50_us}, {"p90", times.p90_us}, {"p99", times.p99_us}, {"max", times.max_us}};
}

Json json_of(const LinkTest& link) {
  const LinkCounters& counters = link.counters;
  return {{"duration_s", link.duration_s},
          {"samples", link.samples},
          {"lost", counters.lost},
          {"crc_errors", counters.crc_errors},
          {"cobs_errors", counters.cobs_errors},
          {"duplicated", counters.duplicated},
          {"implausible", counters.implausible},
          {"commands_confirmed", link.confirmed},
          {"age_us", json_of(link.age)},
          {"round_trip_us", json_of(link.round_trip)},
          {"clock_uncertainty_us", link.clock_uncertainty_us},
          {"clock_drift_ppm", link.clock_drift_ppm}};
}

Json json_of(const Findings& findings, const std::string& port) {
  Json rows = Json::array();
  for (const Finding& finding : findings)
    rows.push_back({{"severity", to_string(finding.severity)},
                    {"name", finding.name},
                    {"seen", finding.seen},
                    {"fix", finding.fix}});
  return {{"port", port},
          {"errors", count(findings, Severity::kError)},
          {"warnings", count(findings, Severity::kWarning)},
          {"notes", count(findings, Severity::kNote)},
          {"findings", rows}};
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Finding ok(std::string name, std::string seen) {
  return {Severity::kOk, std::move(name), std::move(seen), {}};
}

Finding warning(std::string name, std::string seen, std::string fix) {
  return {Severity::kWarning, std::move(name), std::move(seen), std::move(fix)};
}

Finding error(std::string name, std::string seen, std::string fix) {
  return {Severity::kError, std::move(name), std::move(seen), std::move(fix)};
}

std::size_t count(const Findings& findings, Severity severity) {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(),
                    [severity](const Finding& finding) { return finding.severity == severity; }));
}

void append(Findings& findings, Findings more) {
  std::move(more.begin(), more.end(), std::back_inserter(findings));
}

std::string table(const Findings& findings) {
  std::size_t name_width = 0;
  for (const Finding& finding : findings) name_width = std::max(name_width, finding.name.size());
  const std::size_t severity_width = to_string(Severity::kWarning).size();
  std::string table;
  for (const Finding& finding : findings) {
    table += padded(to_string(finding.severity), severity_width) + "  " +
             padded(finding.name, name_width) + "  " + finding.seen + "\n";
    if (!finding.fix.empty())
      table += std::string(severity_width + 2 + name_width, ' ') + "  fix: " + finding.fix + "\n";
  }
  return table + text::counted(count(findings, Severity::kError), "error") + ", " +
         text::counted(count(findings, Severity::kWarning), "warning") + ", " +
         text::counted(count(findings, Severity::kNote), "note") + "\n";
}

std::string json(const Findings& findings, const std::string& port) {
  return text_of(json_of(findings, port));
}

std::string json(const Findings& findings, const std::string& port,
                 const std::optional<LinkTest>& link) {
  Json all = json_of(findings, port);
  all["link"] = link ? json_of(*link) : Json(nullptr);
  return text_of(all) + "\n";
}

}  // namespace tp100::doctor
