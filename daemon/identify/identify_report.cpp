#include "identify/identify_report.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"
#include "core/error.h"
#include "text/format.h"
#include "text/json_writer.h"
#include "text/key.h"

namespace tp100::identify {
namespace {

using model::kTrackParameters;
using text::format;

// Beginning of the part of the comment that is rewritten each time.
constexpr const char* kIdentified = "Identified";

std::string residual(const Fit& fit) {
  return format("%.2f cm and %.2f deg rms, %.2f cm at most", fit.rms_m * 100.0,
                fit.rms_rad * kDegPerRad, fit.max_m * 100.0);
}

std::string with_date(const std::string& date) { return date.empty() ? "" : " on " + date; }

bool has_images(const Fit& fit) {
  for (const RunFit& run : fit.runs)
    if (run.images > 0) return true;
  return false;
}

std::string table(const Fit& fit, const course::Robot& base) {
  std::string text = "                              found    95 % interval     before\n";
  for (const model::ParameterRow& row : kTrackParameters) {
    const ParameterEstimate& estimate = fit[row.value];
    const double was = base.model.*row.value / row.si;
    if (estimate.found) {
      text += format("  %-24s %9.4f      +- %7.4f  %9.4f\n", row.key, estimate.value / row.si,
                     estimate.half_interval / row.si, was);
    } else {
      text += format("  %-24s  not seen                 %9.4f\n", row.key, was);
    }
  }
  return text;
}

std::string run_lines(const Fit& fit) {
  std::string text =
      "  run                                     images   rejected   rms [cm]"
      "   max [cm]  rms [deg]\n";
  for (const RunFit& run : fit.runs) {
    if (run.images == 0) {
      text += format("  %-40s by hand\n", run.name.c_str());
    } else {
      text +=
          format("  %-40s %7zu    %7zu    %7.2f    %7.2f    %7.2f\n", run.name.c_str(), run.images,
                 run.rejected, run.rms_m * 100.0, run.max_m * 100.0, run.rms_rad * kDegPerRad);
    }
  }
  return text;
}

/// As a robot file holds it.
double to_file(double value) { return std::round(value * 1e5) / 1e5; }

/// The same, of a parameter whose unit in the file is not SI.
double rounded(const ParameterEstimate& estimate, double si) {
  return to_file(estimate.value / si) * si;
}

std::string slope_lines(const std::vector<model::AddedSlip>& slopes) {
  std::string text;
  for (const model::AddedSlip& slope : slopes)
    text += format("  %-18s %5.1f deg %+9.4f, %+9.4f\n", text.empty() ? "slip added on" : "",
                   slope.slope_rad * kDegPerRad, slope.left, slope.right);
  return text;
}

/// What the runs cannot determine, one line each.
std::vector<std::string> warnings(const Fit& fit) {
  std::vector<std::string> lines;
  for (const auto& [a, b] : fit.confused)
    lines.push_back(format("these runs cannot separate %s and %s; add runs in which they differ",
                           kTrackParameters[a].key, kTrackParameters[b].key));
  for (const model::ParameterRow& row : kTrackParameters)
    if (!fit[row.value].found)
      lines.push_back(format("these runs do not determine %s; it keeps its value", row.key));
  return lines;
}

/// Left out where there is nothing to say: without images, and of a run without hand measurements.
void write_errors(text::JsonWriter& json, const char* name, const Fit& fit) {
  const auto write_residual = [&json](const auto& of) {
    json.field("rms_m", of.rms_m).field("max_m", of.max_m).field("rms_rad", of.rms_rad);
  };
  json.object(name, [&] {
    if (has_images(fit)) write_residual(fit);
    json.objects("runs", fit.runs, [&](const RunFit& run) {
      json.field("name", run.name).field("images", run.images).field("rejected", run.rejected);
      if (run.images > 0) write_residual(run);
      json.field("distance_off_m", run.distance_off_m).field("turned_off_rad", run.turned_off_rad);
    });
  });
}

std::string residual_row(const model::ModelForm& form, const Fit& fit) {
  return format("  %-20s %td constants   ", std::string(form.key).c_str(), form.constants()) +
         residual(fit) + "\n";
}

}  // namespace

Prior prior_of(const course::Robot& robot, double turning_threshold_radps) {
  Prior prior{.tracks = robot.model, .counts_per_metre = robot.drive.counts_per_metre};
  prior.tracks.turning_threshold_radps = turning_threshold_radps;
  return prior;
}

std::string identify_report(const Identification& found, const course::Robot& base) {
  std::string text =
      format("robot %s, %zu runs\n\n", base.name.c_str(), found.extended.runs.size());
  text += table(found.extended, base);
  text += slope_lines(found.slopes);
  text += "\n" + run_lines(found.extended) + "\n";
  if (has_images(found.extended)) {
    text += "best-fit residual against the camera, including its noise:\n";
    for (std::size_t i = 0; i < model::kBaselines.size(); ++i)
      if (found.baselines[i]) text += residual_row(model::kBaselines[i], *found.baselines[i]);
    text += residual_row(model::kExtendedForm, found.extended);
    text += format("camera's time stamps late by %.1f ms\n", found.extended.camera_late_s * 1e3);
  }
  text += format("condition number %.1f\n", found.extended.condition);
  for (const std::string& line : warnings(found.extended)) text += "warning: " + line + "\n";
  return text;
}

std::string identify_json(const Identification& found, const course::Robot& base,
                          const course::Robot& robot, const std::optional<AutoProgress>& driven) {
  return text::json_object([&](text::JsonWriter& json) {
    json.field("robot", base.name);
    json.objects("parameters", kTrackParameters, [&](const model::ParameterRow& row) {
      const ParameterEstimate& estimate = found.extended[row.value];
      json.field("name", row.key)
          .field("unit", text::unit_of(row.key))
          .field("before", base.model.*row.value / row.si)
          .field("found", estimate.found);
      if (estimate.found)
        json.field("value", robot.model.*row.value / row.si)
            .field("half_interval", estimate.half_interval / row.si);
    });
    json.objects("slopes", found.slopes, [&](const model::AddedSlip& slope) {
      json.field("slope_deg", slope.slope_rad * kDegPerRad)
          .field("added_left", to_file(slope.left))
          .field("added_right", to_file(slope.right));
    });
    write_errors(json, "errors_before", found.before);
    write_errors(json, "errors_after", found.extended);
    if (driven)
      json.object("driven", [&] {
        json.field("manoeuvres", driven->manoeuvres)
            .field("driving_s", driven->driving_s)
            .field("narrow", driven->narrow);
      });
    json.field("condition", found.extended.condition).values("warnings", warnings(found.extended));
  });
}

course::Robot identified_robot(const Identification& found, const course::Robot& base,
                               const std::string& date) {
  course::Robot robot = base;
  for (const model::ParameterRow& row : kTrackParameters) {
    const ParameterEstimate& estimate = found.extended[row.value];
    if (!estimate.found) continue;
    robot.model.*row.value = rounded(estimate, row.si);
    robot.origins[std::string(row.key)] =
        format("identify%s: +- %.5f (95 %%), %zu runs", with_date(date).c_str(),
               estimate.half_interval / row.si, found.extended.runs.size());
  }
  if (!found.slopes.empty()) {
    robot.model.slopes = found.slopes.size();
    std::ranges::transform(found.slopes, robot.model.added_slips.begin(), [](const auto& slope) {
      return model::AddedSlip{slope.slope_rad, to_file(slope.left), to_file(slope.right)};
    });
  }
  for (std::size_t i = 0; i < model::kBaselines.size(); ++i) {
    robot.baselines[i].reset();
    if (!found.baselines[i]) continue;
    model::TrackParameters& values = robot.baselines[i].emplace(model::kBaselines[i].only({}));
    for (const model::ParameterRow& row : kTrackParameters)
      if (model::kBaselines[i].has(row.value))
        values.*row.value = rounded((*found.baselines[i])[row.value], row.si);
  }
  return robot;
}

std::string identified_note(const Identification& found, const std::string& base_note,
                            const std::string& date) {
  std::string note = base_note.substr(0, base_note.find(kIdentified));
  while (note.ends_with(' ')) note.pop_back();
  if (!note.empty()) note += " ";
  note += kIdentified + with_date(date) + " from the runs";
  for (std::size_t i = 0; i < found.extended.runs.size(); ++i)
    note += (i == 0 ? " " : ", ") + one_line(found.extended.runs[i].name);
  note += ".";
  const std::optional<Fit>& eqs = found.baselines[model::kEqsFitted];
  if (has_images(found.extended) && eqs)
    note += " Best-fit residual of eqs 1-5 against the camera: " + residual(*eqs) +
            "; of the extended model: " + residual(found.extended) + ".";
  return note;
}

}  // namespace tp100::identify
