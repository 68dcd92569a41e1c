#include <algorithm>
#include <cmath>
#include <string>

#include "core/arithmetic.h"
#include "report/chart.h"
#include "report/html_page.h"
#include "sim/lab/real_study.h"
#include "text/format.h"

namespace tp100::sim {
namespace {

using report::Rows;
using text::format;

/// Figures of an independent evaluation of the same data, in the same order.
struct Independent {
  const char *robot, *form, *figures;
};
constexpr Independent kIndependent[] = {
    {"MAXXII", kNoSlip, "22.0, 4.8, 2.11"},
    {"MAXXII", kPaperFitted, "10.4, 4.1"},
    {"MAXXII", kPaperIcr, "lateral 0.56 (in sample)"},
    {"MAXXII", kExtendedFitted, "three wheelbases 9.3 -> 8.9 (in sample)"},
    {"Husky", kNoSlip, "54.8, 85 (gauge not stated)"},
    {"Husky", "wheelbase alone", "29.4, 10.8"},
    {"Husky", kPaperFitted, "24.1, 11.2"},
    {"Husky", kPaperIcr, "22.3, 11.3"},
    {"Husky", kPaperGyro, "yaw 4.7"}};

std::string independent(const std::string& robot, const std::string& form) {
  for (const Independent& one : kIndependent)
    if (one.robot == robot && one.form == form) return one.figures;
  return "";
}

Rows form_rows(const RealStudy& study) {
  Rows rows = {{"form", "constants"}};
  for (const std::string& figure : study.figures) rows[0].push_back(figure);
  rows[0].push_back("independent evaluation");
  for (const RealForm& form : study.forms) {
    rows.push_back({form.name, std::to_string(form.fit.fitted.size())});
    for (const double value : form.figures[0]) rows.back().push_back(format("%.2f", value));
    rows.back().push_back(independent(study.robot, form.name));
  }
  return rows;
}

Rows split_rows(const RealStudy& study) {
  Rows rows = {{"form, fitted on"}};
  for (const std::string& split : study.splits) rows[0].push_back(split);
  for (const RealForm& form : study.forms) {
    rows.push_back({form.name});
    for (const std::vector<double>& figures : form.figures)
      rows.back().push_back(format("%.2f", figures[0]));
  }
  return rows;
}

Rows constant_rows(const RealForm& form) {
  Rows rows = {{"constant", "value", "+-", "shown by the data"}};
  for (const FittedConstant& one : form.fit.fitted)
    rows.push_back({name_of(one.constant), format("%.4f", form.fit.constants.*one.constant),
                    format("%.4f", one.half_interval), one.shown ? "yes" : "no"});
  return rows;
}

const RealForm& form_of(const RealStudy& study, const std::string& name) {
  return *std::find_if(study.forms.begin(), study.forms.end(),
                       [&](const RealForm& form) { return form.name == name; });
}

std::string yaw_chart(const RealStudy& study) {
  std::vector<report::ChartSeries> series;
  for (const auto& [name, colour] : {std::pair{kPaperFitted, report::kPathColour},
                                     std::pair{kBothSpeeds, report::kValueColour}}) {
    report::ChartSeries& one = series.emplace_back();
    one.name = name;
    one.colour = colour;
    one.marks = true;
    for (const auto& [difference_mps, error_radps] : form_of(study, name).yaw_errors)
      one.points.emplace_back(difference_mps, error_radps * kDegPerRad);
  }
  return report::svg({.title = study.robot + ": error of the yaw rate",
                      .x_label = "right minus left speed [m/s]",
                      .y_label = "predicted minus measured [deg/s]",
                      .series = series});
}

std::string remark(const RealStudy& study) {
  if (study.robot == "MAXXII")
    return "MAXXII: tracks, indoors, stationary points. Of the seven constants that the extended "
           "model adds, only x_icr reduces the error, that of the lateral speed; wheelbases by "
           "turn ratio, turn slip and turn loss do not help. The yaw rate error that eqs 1-5 leave "
           "is mostly "
           "in right turns on the spot with more than 0.55 m/s between the tracks: there the robot "
           "turns at down to half the rate that its tracks would give; in left turns it does not. "
           "A term for this reduces the error to 6 %, but few points determine its two constants, "
           "and their intervals are as wide as the assumed priors. Track speeds are set points, so "
           "the motors may contribute.";
  return "Husky: wheels, strongly varying random commands, windows of 1.95 s. The slip of eqs 1-5 "
         "occurs in turns: a slip that grows with the difference of the speeds, or with the "
         "curvature "
         "of the path (turn_loss of the extended model), takes most of it from straight driving "
         "and reduces the position error by a fifth. No form improves yaw, where the gyro more "
         "than halves the "
         "error.";
}

std::string plain(const Rows& rows) {
  std::vector<std::size_t> widths(rows[0].size(), 0);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], row[i].text.size());
  std::string out;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      out += format(i == 0 ? "%-*s" : "  %*s", static_cast<int>(widths[i]), row[i].text.c_str());
    out += "\n";
  }
  return out;
}

}  // namespace

void write_real(report::HtmlPage& page, const std::vector<RealStudy>& studies) {
  page.heading("Real robots");
  page.paragraph(
      "Measured motion of two robots that are not a TP100. Each form is fitted by least squares to "
      "one half and judged on the other. Eqs 1-5 have five constants, the extended model "
      "twelve.");
  for (const RealStudy& study : studies) {
    page.paragraph(remark(study));
    page.table(form_rows(study),
               format("%s: fitted on %s of %d, judged on the rest.", study.robot.c_str(),
                      study.splits[0].c_str(), study.motions));
    page.table(split_rows(study),
               study.robot + ": " + study.figures[0] + ", by what the form was fitted on.");
    page.figure(yaw_chart(study), study.robot + ": the motions that were judged.");
    for (const char* name : {kExtendedFitted, kBothSpeeds})
      page.table(constant_rows(form_of(study, name)),
                 format("%s, %s. SI. A constant that the data do not show stays near where its fit "
                        "began.",
                        study.robot.c_str(), name));
  }
}

std::string real_text(const std::vector<RealStudy>& studies) {
  std::string out;
  for (const RealStudy& study : studies) {
    out += "\n" + study.robot + ", fitted on " + study.splits[0] + ", judged on the rest\n" +
           plain(form_rows(study)) + "\n" + study.figures[0] + ", by what was fitted on\n" +
           plain(split_rows(study));
    for (const char* name : {kExtendedFitted, kBothSpeeds})
      out += "\n" + study.robot + ", " + name + "\n" + plain(constant_rows(form_of(study, name)));
  }
  return out;
}

}  // namespace tp100::sim
