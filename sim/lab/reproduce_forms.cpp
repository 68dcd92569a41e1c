#include <algorithm>
#include <map>

#include "core/arithmetic.h"
#include "report/html_page.h"
#include "sim/lab/reproduce.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

using report::Rows;

std::string two_places(double value) { return text::format("%.2f", value); }

/// Errors as shares of the distance, by robot and form, for every study on the flat floor.
Rows form_rows(const Reproduction& what) {
  Rows rows = {{"robot"}};
  const auto add = [&](const std::vector<const CourseStudy*>& studies, std::string_view form) {
    std::vector<double> percent;
    for (const CourseStudy* study : studies)
      if (const report::PoseErrors* errors = errors_of(*study, form))
        percent.push_back(100.0 * errors->max_position_error_m / study->distance_m);
    if (rows.size() == 2) rows[0].emplace_back(std::string(form));
    const double worst = percent.empty() ? 0.0 : *std::ranges::max_element(percent);
    rows.back().emplace_back(
        percent.empty() ? "-" : two_places(median(percent)) + " / " + two_places(worst));
  };
  std::map<std::string, std::vector<const CourseStudy*>> robots;
  for (const CourseStudy& study : what.studies)
    if (study.setup == "flat" && !study.forms.empty())
      robots[study.robot + (study.uneven ? ", uneven" : "")].push_back(&study);
  for (const auto& [robot, studies] : robots) {
    rows.push_back({robot});
    for (const model::ModelForm& form : model::kBaselines) add(studies, form.key);
    for (const std::string_view form : {model::kExtendedForm.key, to_string(PoseSource::kOdometry),
                                        to_string(PoseSource::kFused)})
      add(studies, form);
  }
  return rows;
}

Rows form_meanings() {
  Rows rows = {{"form", "fitted constants", "what it is"}};
  const auto add = [&](const model::ModelForm& form) {
    rows.push_back(
        {std::string(form.key), std::to_string(form.constants()), std::string(form.meaning)});
  };
  for (const model::ModelForm& form : model::kBaselines) add(form);
  add(model::kExtendedForm);
  return rows;
}

/// Every error of every form.
Rows error_rows(const Reproduction& what) {
  Rows rows = {{"course", "robot", "set-up", "form", "max [cm]", "mean [cm]", "rms [cm]",
                "final [cm]", "yaw max [deg]"}};
  const auto cm = [](double metres) { return two_places(metres * report::kCmPerM); };
  for (const CourseStudy& study : what.studies)
    for (const auto& [form, e] : study.forms)
      rows.push_back(
          {study.course, study.robot, study.setup + (study.uneven ? ", uneven floor" : ""), form,
           cm(e.max_position_error_m), cm(e.mean_position_error_m), cm(e.rms_position_error_m),
           cm(e.final_position_error_m), two_places(e.max_yaw_error_rad * kDegPerRad)});
  return rows;
}

}  // namespace

void write_forms(report::HtmlPage& page, const Reproduction& what) {
  const Rows rows = form_rows(what);
  if (rows.size() == 1) return;
  page.heading("What slip compensation brings");
  page.table(form_meanings(),
             "Each is dead reckoning on the same counts as the extended model, and fitted to the "
             "same drives; odometry and fused take the gyro, and the camera, too");
  page.table(
      rows,
      "Largest position error between disturbances in % of the distance (odometry and fused: "
      "from start to end): median / worst over the courses on the flat floor");
  page.table(error_rows(what), "The same errors in full, medians over the runs");
}

std::string forms_table(const Reproduction& what) {
  const Rows rows = form_rows(what);
  if (rows.size() == 1) return {};
  std::string out =
      "largest error in % of the distance on the flat floor, median / worst course:\n";
  for (const std::vector<report::Cell>& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::size_t width = std::max<std::size_t>(rows[0][i].text.size(), i == 0 ? 20 : 14);
      out += text::format("%-*s", static_cast<int>(width) + 1, row[i].text.c_str());
    }
    out += "\n";
  }
  return out;
}

}  // namespace tp100::sim
