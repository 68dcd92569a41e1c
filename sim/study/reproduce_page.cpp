#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/angle.h"
#include "report/chart.h"
#include "report/html_page.h"
#include "report/report_figures.h"
#include "report/result_text.h"
#include "sim/study/reproduce.h"
#include "sim/study/sampled.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

using text::format;

using report::ChartSeries;
using report::Rows;

constexpr double kSlopeLimit = 0.02;

std::string number(double value, int decimals = 2) {
  return std::isfinite(value) ? format("%.*f", decimals, value) : "never";
}

std::string scientific(double value) { return format("%.2e", value); }

std::string paper_max_cm(const std::string& course) {
  const auto paper = report::published_errors(course);
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

ChartSeries series(const char* name, const char* colour, bool dashed = false) {
  return {.name = name, .colour = colour, .points = {}, .dashed = dashed};
}

std::vector<std::string> path_and_yaw(const TrialRun& run, const std::string& title) {
  ChartSeries truth = series("truth", report::kTruthColour),
              model = series("model", report::colour_of(PoseSource::kModel)),
              fused = series("fused", report::colour_of(PoseSource::kFused), true);
  ChartSeries truth_yaw = truth, model_yaw = model, fused_yaw = fused;
  for (const report::TrajectoryPoint& point : run.result.points) {
    const Pose& by_model = point.estimates[PoseSource::kModel];
    const Pose& by_fused = point.estimates[PoseSource::kFused];
    truth.points.emplace_back(point.truth.x_m, point.truth.y_m);
    model.points.emplace_back(by_model.x_m, by_model.y_m);
    fused.points.emplace_back(by_fused.x_m, by_fused.y_m);
    truth_yaw.points.emplace_back(point.t_s, point.truth.yaw_rad * kDegPerRad);
    model_yaw.points.emplace_back(point.t_s, by_model.yaw_rad * kDegPerRad);
    fused_yaw.points.emplace_back(point.t_s, by_fused.yaw_rad * kDegPerRad);
  }
  std::vector<ChartSeries> map = {truth, model}, yaw = {truth_yaw, model_yaw};
  if (run.result.has_camera) {
    map.push_back(fused);
    yaw.push_back(fused_yaw);
  }
  return {report::svg({.title = title + ": path",
                       .x_label = "x [m]",
                       .y_label = "y [m]",
                       .series = map,
                       .equal_scale = true}),
          report::svg({.title = title + ": yaw",
                       .x_label = "time [s]",
                       .y_label = "yaw [deg]",
                       .series = yaw})};
}

std::string pitch_chart(const TrialRun& run, const std::string& title) {
  ChartSeries truth = series("truth", report::kTruthColour),
              model = series("model's slope", report::colour_of(PoseSource::kModel));
  for (const report::TrajectoryPoint& point : run.result.points) {
    truth.points.emplace_back(point.t_s, -point.truth.pitch_rad * kDegPerRad);
    model.points.emplace_back(point.t_s,
                              -point.estimates[PoseSource::kModel].pitch_rad * kDegPerRad);
  }
  return report::svg({.title = title + ": climb angle",
                      .x_label = "time [s]",
                      .y_label = "nose up [deg]",
                      .series = {truth, model}});
}

Rows slope_table(const Reproduction& what) {
  Rows rows = {{"slope [deg]", "ours left", "ours right", "paper left", "paper right"}};
  for (std::size_t i = 0; i < what.slopes.size(); ++i) {
    const SlopeRow& row = slope_rows()[i];
    rows.push_back({number(row.slope_deg, 0), number(what.slopes[i].left, 3),
                    number(what.slopes[i].right, 3),
                    row.paper_left ? number(*row.paper_left, 3) : "-",
                    row.paper_right ? number(*row.paper_right, 3) : "-"});
  }
  return rows;
}

std::vector<std::string> slope_charts(const Reproduction& what) {
  std::vector<std::string> charts;
  for (const bool left : {true, false}) {
    ChartSeries ours = series("ours, measured", report::colour_of(PoseSource::kFused)),
                paper = series("paper", report::kTruthColour);
    paper.marks = true;
    for (std::size_t i = 0; i < what.slopes.size(); ++i) {
      const SlopeRow& row = slope_rows()[i];
      ours.points.emplace_back(row.slope_deg, left ? what.slopes[i].left : what.slopes[i].right);
      if (const auto printed = left ? row.paper_left : row.paper_right)
        paper.points.emplace_back(row.slope_deg, *printed);
    }
    charts.push_back(report::svg({.title = left ? "left track" : "right track",
                                  .x_label = "slope [deg]",
                                  .y_label = "slip ratio",
                                  .series = {ours, paper}}));
  }
  return charts;
}

Rows parameter_table(const Reproduction& what) {
  const model::TrackParameters& model = what.reference.model;
  return {
      {"parameter", "ours, identified", "paper, printed"},
      {"equivalent wheelbase [m]", number(model.wheelbase_m, 4),
       number(report::kPublishedWheelbaseM, 4)},
      {"slip ratio, left", number(model.slip_left, 4), number(report::kPublishedSlipLeft, 4)},
      {"slip ratio, right", number(model.slip_right, 4), number(report::kPublishedSlipRight, 4)},
      {"slip angle straight [deg]", number(model.slip_angle_straight_rad * kDegPerRad, 3),
       number(report::kPublishedSlipAngleDeg, 3)}};
}

bool is_paper_course(const CourseStudy& study, const Reproduction& what) {
  return study.robot == what.reference.name && report::published_errors(study.course) &&
         study.board == "native" && study.blind.empty();
}

Rows squared_table(const Reproduction& what) {
  Rows rows = {
      {"course", "ours: x [m^2]", "y [m^2]", "yaw [rad^2]", "paper, as printed: x", "y", "yaw"}};
  for (const CourseStudy& study : what.studies) {
    const auto paper = report::published_errors(study.course);
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

void write_courses(report::HtmlPage& page, const Reproduction& what) {
  page.heading("Courses of the paper (its figures 13, 17 and 18)");
  Rows rows = {{"course, set-up", "paper", "eqs 1-5 as printed", "eqs 1-5 fitted", "extended model",
                "fused", "tracking", "runs"}};
  for (const CourseStudy& study : what.studies) {
    if (!is_paper_course(study, what)) continue;
    const auto find = [&](const char* begin) {
      for (const Judged& one : study.judged)
        if (one.what.rfind(begin, 0) == 0 && one.unit == "cm") return number(one.ours.median);
      return std::string("-");
    };
    const auto max_cm = [&](std::string_view form) {
      const report::PoseErrors* errors = errors_of(study, form);
      return errors == nullptr ? "-" : number(errors->max_position_error_m * report::kCmPerM);
    };
    rows.push_back({study.course + ", " + study.setup, paper_max_cm(study.course),
                    max_cm(model::kBaselines[model::kEqsPrinted].key),
                    max_cm(model::kBaselines[model::kEqsFitted].key),
                    max_cm(model::kExtendedForm.key), find("fused"), find("tracking"),
                    std::to_string(study.runs)});
  }
  page.table(rows,
             "Largest errors, medians over the runs. [cm] What the paper drove with is eqs 1-5, "
             "fitted to its robot. Eqs 1-5 and the extended model: between the disturbances; eqs "
             "1-5 know no slope. Fused on course 2: root mean square. Model, estimate and tracking "
             "are three different things and never mixed.");
  for (const CourseStudy& study : what.studies) {
    if (!is_paper_course(study, what) || study.shown.result.points.empty()) continue;
    const std::string title = study.course + " (" + study.setup + ")";
    std::vector<std::string> charts = path_and_yaw(study.shown, title);
    if (study.setup == "terrain" && study.course == "3")
      charts.push_back(pitch_chart(study.shown, title));
    page.figures(charts, "First seed. Lengths and radii of the course are ours.");
  }
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
  page.paragraph(format(
      "Seeds %llu and following, %d a course, each driven both ways round. The truth is the exact "
      "pose of a rigid body on tracks (ODE) that shares no code with the model; the robot drives "
      "by the fused pose. The extended model is eqs 1-5 and seven constants of ours; what eqs 1-5 "
      "do alone stands beside it.",
      static_cast<unsigned long long>(what.seed), what.runs));
  page.paragraph(
      "The reference robot's slip table is fitted through its contact creep, its slip on the level "
      "is a track speed deficit that no physics explains, and its end-loaded tracks make eqs 1-5 "
      "nearly exact. What a real TP100 does on a real floor only a real TP100 can show.");
  if (!what.slopes.empty()) {
    page.heading("Slip against slope (table 4, figure 11)");
    page.table(slope_table(what),
               format("Largest difference %.3f, limit %.2f. The paper has no row for 4 deg.",
                      worst_slope_difference(what), kSlopeLimit));
    page.figures(slope_charts(what), "Lines: ours. Dots: the paper's table.");
    page.heading("Parameters (tables 2 and 3)");
    page.table(parameter_table(what),
               "Ours: the reference robot's file. Another floor, another robot: only the wheelbase "
               "is meant to agree.");
  }
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
        "Each was identified from its own calibration drives first; its file lies beside this "
        "page. One seed, both ways round. Where friction is below 0.85, or the robot is so long "
        "that it meets the step in the curve, course 3 is driven on a flat floor; so it is with "
        "bundled robots.");
  }
  if (!what.real.empty()) write_real(page, what.real);
  page.heading("Every figure with its limit");
  page.table(judged_rows(what), "Limits are ours. Red: limit exceeded.");
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
    if (const auto paper = report::published_errors(study.course)) {
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
