#include "sim/lab/constants_study.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>

#include "core/arithmetic.h"
#include "identify/identify.h"
#include "identify/identify_report.h"
#include "sim/robot/options.h"
#include "sim/trials/commands.h"

namespace tp100::sim {
namespace {

using model::kTrackParameters;

double criterion(const identify::Fit& fit, const std::vector<identify::FittedRun>& runs,
                 const model::ModelForm& form) {
  const identify::IdentifySettings settings;
  const auto independent = [&](const identify::FittedRun& run, const identify::RunFit& of) {
    return static_cast<double>(of.images) / std::max(1.0, settings.correlated_s * run.images_per_s);
  };
  const double images = std::transform_reduce(runs.begin(), runs.end(), fit.runs.begin(), 0.0,
                                              std::plus<>{}, independent);
  // x, y and yaw of each image.
  return images * (2.0 * std::log(square(fit.rms_m) / 2.0) + std::log(square(fit.rms_rad))) +
         static_cast<double>(form.constants()) * std::log(3.0 * images);
}

/// The extended model without one constant; the name of the figure.
struct Reduced {
  model::ModelForm form;
  std::string what;
};

std::vector<Reduced> reduced_forms() {
  std::vector<Reduced> all = {{model::kBaselines[model::kEqsFitted], "criterion of eqs 1-5"}};
  for (std::size_t i = 0; i < kTrackParameters.size(); ++i) {
    if (kTrackParameters[i].of != model::ParameterOf::kExtended) continue;
    model::ModelForm form = model::kExtendedForm;
    form.fitted[i] = false;
    all.push_back({form, std::string("criterion without ") + kTrackParameters[i].key});
  }
  return all;
}

constexpr const char* kIdentificationDrives = "identification drives";

}  // namespace

CourseStudy study_constants(const std::string& robot, const std::string& body, std::uint64_t seed) {
  Options options;
  options.body = body;
  options.robot = robot;
  const Loaded loaded = load(options);
  CourseStudy study;
  study.course = kIdentificationDrives;
  study.robot = loaded.robot.name;
  study.setup = bridge::to_string(loaded.setup);
  study.board = to_string(loaded.board);
  const identify::Prior prior = identify::prior_of(
      without_model(loaded.robot), loaded.configuration.parameters.model.turning_threshold_radps);
  std::vector<identify::FittedRun> runs;
  for (const CalibrationDrive& drive : calibration_drives(loaded, kDrivesOfAKind, seed))
    runs.push_back(identify::fitted_run(drive.drive, prior));
  study.runs = study.completed = static_cast<int>(runs.size());
  const auto of = [&](const model::ModelForm& form) {
    return criterion(identify::fit_of_form(runs, prior, form), runs, form);
  };
  const double extended = of(model::kExtendedForm);
  for (const Reduced& reduced : reduced_forms())
    study.judged.push_back(
        judged_value(study, reduced.what, "", -1.0, of(reduced.form) - extended));
  std::fprintf(stderr, "%-28s %-14s\n", study.course.c_str(), study.robot.c_str());
  return study;
}

CourseStudy largest_criteria(const std::vector<CourseStudy>& studies) {
  CourseStudy largest;
  for (const CourseStudy& study : studies) {
    if (study.course != kIdentificationDrives) continue;
    if (largest.judged.empty()) largest = study;
    for (std::size_t i = 0; i < study.judged.size(); ++i)
      if (study.judged[i].ours.median > largest.judged[i].ours.median)
        largest.judged[i] = study.judged[i];
  }
  largest.robot = "all, largest";
  for (Judged& judged : largest.judged) judged.robot = largest.robot;
  return largest;
}

}  // namespace tp100::sim
