#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/arithmetic.h"
#include "report/html_page.h"
#include "sim/lab/published.h"
#include "sim/lab/reproduce.h"
#include "sim/lab/reproduce_charts.h"
#include "sim/lab/sampled.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

using text::format;

using report::Rows;

constexpr std::size_t kNamedLimits = 5;
// Column of the limit in judged_rows(), before that of the median.
constexpr std::ptrdiff_t kLimit = 4;

std::string number(double value, int decimals = 2) {
  return std::isfinite(value) ? format("%.*f", decimals, value) : "never";
}

std::string scientific(double value) { return format("%.2e", value); }

std::string paper_max_cm(const std::string& course) {
  const auto paper = published_errors(course);
  return paper && paper->max_position_error_cm >= 0 ? number(paper->max_position_error_cm) : "-";
}

Rows judged_rows(const Reproduction& what) {
  Rows rows = {{"course", "robot", "set-up, board", "figure", "limit", "median", "95 %", "unit"}};
  for (const CourseStudy& study : what.studies) {
    const std::string where = study.setup + (study.uneven ? ", uneven floor, " : ", ") +
                              (study.blind.empty() ? study.board : study.blind);
    if (study.completed != study.runs)
      rows.push_back({study.course,
                      study.robot,
                      where,
                      "completed",
                      std::to_string(study.runs),
                      {std::to_string(study.completed), true},
                      "",
                      "runs"});
    for (const Judged& one : study.judged)
      rows.push_back({study.course,
                      study.robot,
                      where,
                      one.what,
                      one.limit < 0 ? "-" : number(one.limit),
                      {number(one.ours.median), !one.holds()},
                      number(one.ours.p95),
                      one.unit});
  }
  return rows;
}

/// The table of limits with verdicts.
Rows verdict_rows(const Reproduction& what) {
  Rows rows = judged_rows(what);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool exceeded = std::ranges::any_of(
        rows[i], [](const report::Cell& cell) { return cell.mark == report::Mark::kMissed; });
    std::vector<report::Cell>& row = rows[i];
    const std::size_t at = kLimit;
    // Swapped, so that each figure stands beside its limit.
    const report::Cell limit = row[at], median = row[at + 1];
    row[at] = median;
    row[at + 1] = limit;
    const char* verdict = exceeded ? "exceeded" : limit.text == "-" ? "no limit" : "holds";
    row.insert(row.begin() + kLimit + 2,
               i == 0 ? report::Cell("verdict") : report::Cell(verdict, exceeded));
  }
  return rows;
}

bool is_paper_course(const CourseStudy& study, const Reproduction& what) {
  return study.robot == what.reference.name && published_errors(study.course) &&
         study.board == "native" && study.blind.empty() && !study.uneven;
}

Rows squared_table(const Reproduction& what) {
  Rows rows = {
      {"course", "ours: x [m^2]", "y [m^2]", "yaw [rad^2]", "paper, as printed: x", "y", "yaw"}};
  for (const CourseStudy& study : what.studies) {
    const auto paper = published_errors(study.course);
    if (!paper || paper->mse_x < 0 || !is_paper_course(study, what) || study.setup == "stand")
      continue;
    rows.push_back({study.course + " (" + study.setup + ")", scientific(study.mse_x_m2.median),
                    scientific(study.mse_y_m2.median), scientific(study.mse_yaw_rad2.median),
                    number(paper->mse_x, 4), number(paper->mse_y, 4), number(paper->mse_yaw, 3)});
  }
  return rows;
}

Rows sampled_table() {
  Rows rows = {{"in which they differ", "from", "to", "unit"}};
  for (const SampledRange& range : kSampledRanges)
    rows.push_back({range.what, format("%g", range.low), format("%g", range.high), range.unit});
  return rows;
}

/// The first figure in cm whose name starts with `begin`, with its limit.
report::Cell with_limit(const CourseStudy& study, const char* begin) {
  for (const Judged& one : study.judged)
    if (one.what.starts_with(begin) && one.unit == "cm")
      return {number(one.ours.median) +
                  (one.limit < 0 ? " (no limit)" : " (limit " + number(one.limit) + ")"),
              !one.holds()};
  return "-";
}

/// The error of a form, with the limit of the figure that starts with `begin`, if it has one.
report::Cell form_with_limit(const CourseStudy& study, std::string_view form, const char* begin) {
  report::Cell judged = with_limit(study, begin);
  if (judged.text != "-") return judged;
  const report::PoseErrors* errors = errors_of(study, form);
  return errors == nullptr ? "-" : number(errors->max_position_error_m * report::kCmPerM);
}

Rows course_rows(const Reproduction& what) {
  Rows rows = {{"course, set-up", "paper", "eqs 1-5 as printed", "eqs 1-5 fitted", "extended model",
                "fused", "tracking", "runs"}};
  for (const CourseStudy& study : what.studies) {
    if (!is_paper_course(study, what)) continue;
    const report::PoseErrors* printed = errors_of(study, model::kBaselines[model::kEqsPrinted].key);
    rows.push_back(
        {study.course + ", " + study.setup, paper_max_cm(study.course),
         printed == nullptr ? "-" : number(printed->max_position_error_m * report::kCmPerM),
         form_with_limit(study, model::kBaselines[model::kEqsFitted].key, "eqs 1-5 fitted"),
         form_with_limit(study, model::kExtendedForm.key, "extended model max"),
         with_limit(study, "fused"), with_limit(study, "tracking"), std::to_string(study.runs)});
  }
  return rows;
}

std::string shown_caption(const CourseStudy& study) {
  std::string text = format(
      "Course %s, %s: seed %llu, %.1f s.", study.course.c_str(), study.setup.c_str(),
      static_cast<unsigned long long>(study.shown.result.seed), study.shown.result.duration_s);
  if (!study.shown.result.disturbances.empty() && study.setup != "stand")
    text +=
        " Encoders do not measure a push: the model is not judged during it, and is reset to the "
        "truth at its end (dots). The other estimates continue.";
  if (study.setup == "stand")
    text += " The body does not move: the truth is the steering pose, and there are no errors.";
  return text;
}

void write_courses(report::HtmlPage& page, const Reproduction& what) {
  page.heading("Courses of the paper (its figures 13, 17 and 18)");
  page.table(
      course_rows(what),
      "Largest errors, medians over the runs, each with its limit. [cm] What the paper drove "
      "with is eqs 1-5, fitted to its robot. Eqs 1-5 and the extended model: between the "
      "disturbances; eqs 1-5 know no slope. Fused on course 2: root mean square. Model, estimate "
      "and tracking are three different things and never mixed. The paper's 34.10 cm of course 3 "
      "is what it calls HIL, hardware in the loop: its model in a virtual world that has the ramp "
      "and the step, against what its robot really did, at the course's end. Ours on "
      "terrain is another thing: ramp and step stand on the floor, and the body climbs them.");
  page.heading("Shown runs");
  page.paragraph(
      "The first run of each course. Lengths and radii of the courses are ours. The truth is the "
      "broad band, estimates are lines on it; where they cannot be told apart, the errors over "
      "time say how far each is off.");
  for (const CourseStudy& study : what.studies)
    if (is_paper_course(study, what) && !study.shown.result.points.empty())
      page.figures(run_charts(study), shown_caption(study));
}

Rows meaning_rows() {
  return {
      {"word", "meaning"},
      {"flat",
       "The robot drives on a level floor. Ramp and step of course 3 are virtual: the "
       "pose climbs them in the course's world, the body does not."},
      {"terrain", "The floor has the obstacles: the body climbs the ramp and the step."},
      {"stand",
       "Hardware in the loop (HIL) with the tracks in the air: motors, encoders and "
       "firmware run, the body stays where it is, and the robot drives in the virtual "
       "world alone. Nothing can be judged but what the controller made of its own "
       "pose."},
      {"native", "The firmware's sources, compiled for this computer."},
      {"avr", "The firmware's image as flashed, on an emulated ATmega2560."},
      {"uneven floor", "Friction, slip, tension, payload and battery differ from seed to seed."},
      {"no camera", "The overhead camera sees nothing during the time given."},
      {"max, rms", "Largest value and root mean square over a run."},
      {"median, 95 %",
       "Over the runs: half of them, and 95 of 100, are not above it. A limit "
       "applies to the median; the 95 % column shows the spread, and may be "
       "above the limit."}};
}

/// Counts of limits and runs, and the first limits that do not hold.
std::string verdict(const Reproduction& what) {
  std::size_t limits = what.slopes.empty() ? 0 : 1;
  int incomplete = 0;
  std::vector<std::string> exceeded;
  if (worst_slope_difference(what) > kSlopeLimit) exceeded.emplace_back("slip against slope");
  for (const CourseStudy& study : what.studies) {
    incomplete += study.runs - study.completed;
    for (const Judged& one : study.judged) {
      if (one.limit >= 0.0) ++limits;
      if (!one.holds())
        exceeded.push_back(study.course + " " + study.setup + " " + study.robot + " " + one.what);
    }
  }
  std::string text = format("%zu of %zu limits hold; ", limits - exceeded.size(), limits) +
                     (incomplete == 0 ? "every run was completed."
                                      : format("%d runs were not completed.", incomplete));
  for (std::size_t i = 0; i < std::min(exceeded.size(), kNamedLimits); ++i)
    text += (i == 0 ? " Exceeded: " : ", ") + exceeded[i];
  if (exceeded.empty()) return text;
  return text + (exceeded.size() > kNamedLimits ? ", ..." : ".");
}

}  // namespace

double worst_slope_difference(const Reproduction& what) {
  double worst = 0.0;
  for (std::size_t i = 0; i < what.slopes.size(); ++i) {
    const SlopeRow& row = slope_rows()[i];
    if (!row.paper_left || !row.paper_right) continue;
    worst = std::max({worst, std::abs(what.slopes[i].left - *row.paper_left),
                      std::abs(what.slopes[i].right - *row.paper_right)});
  }
  return worst;
}

bool all_hold(const Reproduction& what) {
  return worst_slope_difference(what) <= kSlopeLimit &&
         std::all_of(what.studies.begin(), what.studies.end(), [](const CourseStudy& study) {
           return study.completed == study.runs &&
                  std::all_of(study.judged.begin(), study.judged.end(),
                              [](const Judged& one) { return one.holds(); });
         });
}

std::string reproduction_page(const Reproduction& what) {
  report::HtmlPage page("The paper's experiment on the emulated TP100");
  page.verdict(all_hold(what), verdict(what));
  page.facts({{"driven", what.date},
              {"driven with", what.program},
              {"robot", what.reference.name + ", and those that the tables name"},
              {"runs", format("seeds %llu and following, %d a course, each driven both ways round",
                              static_cast<unsigned long long>(what.seed), what.runs)}});
  page.paragraph(
      "The truth is the exact pose of a rigid body on tracks (ODE) that shares no code with the "
      "model; the robot drives by the fused pose. The extended model is eqs 1-5 and seven "
      "constants of ours; what eqs 1-5 do alone stands beside it.");
  page.paragraph(
      "The reference robot's slip table is fitted through its contact creep, its slip on the level "
      "is a track speed deficit that no physics explains, and its end-loaded tracks make eqs 1-5 "
      "nearly exact. What a real TP100 does on a real floor only a real TP100 can show.");
  page.heading("Words");
  page.table(meaning_rows(), "What set-ups, boards and columns are");
  write_tables(page, what);
  write_courses(page, what);
  write_forms(page, what);
  page.heading("Mean squared errors (table 5)");
  page.table(squared_table(what),
             "The paper prints m and rad for squares, and its values contradict its own maxima: "
             "they are shown, nothing is claimed from them.");
  if (std::any_of(what.studies.begin(), what.studies.end(),
                  [](const CourseStudy& study) { return study.robot.starts_with("sampled-"); })) {
    page.heading("Robots sampled from ranges");
    page.table(
        sampled_table(),
        "Each was identified from its own identification drives first; its file lies beside this "
        "page. One seed, both ways round. Where friction is below 0.85, or the robot is so long "
        "that it meets the step in the curve, course 3 is driven on a flat floor; so it is with "
        "bundled robots.");
  }
  if (!what.real.empty()) write_real(page, what.real);
  page.heading("Every figure with its limit");
  page.table(verdict_rows(what), "Limits are ours, and apply to the median over the runs");
  return page.text();
}

std::string reproduction_json(const Reproduction& what) {
  nlohmann::ordered_json json;
  json["seed"] = what.seed;
  json["runs"] = what.runs;
  json["reference_robot"] = what.reference.name;
  json["slope_max_difference"] = worst_slope_difference(what);
  for (std::size_t i = 0; i < what.slopes.size(); ++i) {
    const SlopeRow& row = slope_rows()[i];
    nlohmann::ordered_json one = {{"slope_deg", row.slope_deg},
                                  {"slip_left", what.slopes[i].left},
                                  {"slip_right", what.slopes[i].right}};
    if (row.paper_left) one["paper_slip_left"] = *row.paper_left;
    if (row.paper_right) one["paper_slip_right"] = *row.paper_right;
    json["slopes"].push_back(one);
  }
  for (const CourseStudy& study : what.studies) {
    nlohmann::ordered_json one = {
        {"course", study.course},
        {"robot", study.robot},
        {"setup", study.setup},
        {"board", study.board},
        {"runs", study.runs},
        {"completed", study.completed},
        {"distance_m", study.distance_m},
        {"floor", to_string(study.uneven ? course::Floor::kUneven : course::Floor::kEven)}};
    one["model_mse"] = {{"x_m2", study.mse_x_m2.median},
                        {"y_m2", study.mse_y_m2.median},
                        {"yaw_rad2", study.mse_yaw_rad2.median}};
    if (const auto paper = published_errors(study.course)) {
      one["paper"] = {{"max_position_error_cm", paper->max_position_error_cm},
                      {"mse_x", paper->mse_x},
                      {"mse_y", paper->mse_y},
                      {"mse_yaw", paper->mse_yaw}};
    }
    for (const auto& [form, errors] : study.forms)
      one["forms"][form] = {{"max_position_error_m", errors.max_position_error_m},
                            {"mean_position_error_m", errors.mean_position_error_m},
                            {"rms_position_error_m", errors.rms_position_error_m},
                            {"final_position_error_m", errors.final_position_error_m},
                            {"max_yaw_error_rad", errors.max_yaw_error_rad}};
    for (const Judged& figure : study.judged) {
      nlohmann::ordered_json judged = {{"what", figure.what},
                                       {"unit", figure.unit},
                                       {"median", figure.ours.median},
                                       {"p95", figure.ours.p95}};
      if (figure.limit >= 0.0) {
        judged["limit"] = figure.limit;
        judged["holds"] = figure.holds();
      }
      one["figures"].push_back(judged);
    }
    json["studies"].push_back(one);
  }
  json["all_hold"] = all_hold(what);
  return json.dump(1) + "\n";
}

std::string reproduction_table(const Reproduction& what) {
  std::string out;
  for (const std::vector<report::Cell>& row : judged_rows(what)) {
    constexpr std::array kWidths = {-24, -14, -26, -42, 8, 8, 8, -8};
    for (std::size_t i = 0; i < row.size(); ++i)
      out += format("%s%*s", i == 0 ? "" : " ", kWidths[i], row[i].text.c_str());
    const bool missed = std::any_of(row.begin(), row.end(), [](const report::Cell& cell) {
      return cell.mark == report::Mark::kMissed;
    });
    out += missed ? " DOES NOT HOLD\n" : "\n";
  }
  out += forms_table(what);
  if (!what.slopes.empty())
    out += format("slip against slope: largest difference to the paper's table %.3f, limit %.2f\n",
                  worst_slope_difference(what), kSlopeLimit);
  return out;
}

}  // namespace tp100::sim
