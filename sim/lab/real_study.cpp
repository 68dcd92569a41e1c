#include "sim/lab/real_study.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/arithmetic.h"

namespace tp100::sim {
namespace {

/// Which motions a form is fitted to; the others are judged.
struct Split {
  std::string name;
  bool (*fitted)(const RealMotion&);
};

bool even(int number) { return number % 2 == 0; }

const std::vector<Split> kGridSplits = {
    {"every other point", [](const RealMotion& m) { return even(m.row + m.column); }},
    {"the other points", [](const RealMotion& m) { return !even(m.row + m.column); }},
    {"every other left speed", [](const RealMotion& m) { return even(m.row); }},
    {"the other left speeds", [](const RealMotion& m) { return !even(m.row); }},
    {"right speeds 0, 0.2, 0.4", [](const RealMotion& m) { return even(m.column); }},
    {"right speeds 0.1, 0.3", [](const RealMotion& m) { return !even(m.column); }}};
const std::vector<Split> kWindowSplits = {
    {"even steps", [](const RealMotion& m) { return even(m.column); }},
    {"odd steps", [](const RealMotion& m) { return !even(m.column); }}};

// Start of the fit: break-away in spins at about half a metre per second and more.
constexpr double kFirstBreakAwayMps = 0.8;

using Constants = std::vector<SlipConstant>;

Constants with(Constants constants, const Constants& more) {
  constants.insert(constants.end(), more.begin(), more.end());
  return constants;
}

std::vector<SlipForm> forms_for(const RealRobot& robot) {
  constexpr auto kPaper = model::Mode::kPaper, kExtended = model::Mode::kExtended;
  Constants paper, extended;
  for (const model::ParameterRow& row : model::kTrackParameters) {
    if (row.of == model::ParameterOf::kPaper) paper.push_back(row.value);
    if (row.of != model::ParameterOf::kGyro) extended.push_back(row.value);
  }
  const Constants x_icr = with(paper, {&SlipConstants::x_icr_m});
  const Constants icr = with(x_icr, {&SlipConstants::turning_centre_left_m});
  std::vector<SlipForm> forms = {{kNoSlip, kPaper, {}},
                                 {"wheelbase alone", kPaper, {&SlipConstants::wheelbase_m}},
                                 {kPaperFitted, kPaper, paper},
                                 {kPaperIcr, kExtended, x_icr},
                                 {kExtendedFitted, kExtended, extended},
                                 {"eqs 1-5, x_icr and y_icr", kExtended, icr}};
  Constants both = with(icr, {&SlipConstants::slip_by_difference_spm});
  forms.push_back({"... and slip by difference", kExtended, both});
  both.push_back(&SlipConstants::wheelbase_opposed_shift_m);
  if (robot.stationary()) {
    forms.push_back({"... and L of opposed tracks", kExtended, both});
    both.push_back(&SlipConstants::break_away_mps);
    both.push_back(&SlipConstants::break_away_scale_mps);
  }
  forms.push_back({kBothSpeeds, kExtended, both});
  if (!robot.stationary()) {
    forms.push_back({kPaperGyro, kPaper, {}, true});
    forms.push_back({kBothSpeedsGyro, kExtended, {}, true});
  }
  return forms;
}

/// Constants from which a form's fit starts: those found by the nearest simpler form.
SlipConstants start_of(const SlipForm& form, const RealRobot& robot,
                       const std::vector<std::pair<std::string, SlipConstants>>& found) {
  const auto of = [&](const std::string& name) {
    return std::find_if(found.begin(), found.end(),
                        [&](const auto& one) { return one.first == name; })
        ->second;
  };
  if (form.name == kPaperGyro) return of(kPaperFitted);
  if (form.name == kBothSpeedsGyro) return of(kBothSpeeds);
  if (found.empty() || form.name == kNoSlip) {
    SlipConstants plain;
    plain.wheelbase_m = robot.gauge_m;
    return plain;
  }
  if (form.mode == model::Mode::kPaper) return found.back().second;
  SlipConstants start = of(kPaperFitted);
  const auto frees = [&](SlipConstant c) {
    return std::find(form.free.begin(), form.free.end(), c) != form.free.end();
  };
  if (frees(&SlipConstants::wheelbase_tight_m))
    start.wheelbase_medium_m = start.wheelbase_tight_m = start.wheelbase_spin_m = start.wheelbase_m;
  if (frees(&SlipConstants::break_away_mps)) start.break_away_mps = kFirstBreakAwayMps;
  return start;
}

double rms(double squares, std::size_t count) {
  return std::sqrt(squares / static_cast<double>(count));
}

/// Stationary points: rms errors of yaw rate and speed relative to their own rms, and of the
/// lateral speed.
std::vector<double> point_figures(const SlipForm& form, const SlipConstants& constants,
                                  const std::vector<RealMotion>& motions) {
  std::array<double, 3> errors{}, values{};
  for (const RealMotion& motion : motions) {
    const std::array<double, 3> here = predicted(constants, form, motion);
    for (std::size_t i = 0; i < here.size(); ++i) {
      errors[i] += square(here[i] - motion.truth[i]);
      values[i] += square(motion.truth[i]);
    }
  }
  return {100.0 * std::sqrt(errors[2] / values[2]), 100.0 * std::sqrt(errors[0] / values[0]),
          100.0 * rms(errors[1], motions.size())};
}

/// Windows: mean position error at the end relative to the mean path, mean yaw error.
std::vector<double> window_figures(const SlipForm& form, const SlipConstants& constants,
                                   const std::vector<RealMotion>& motions) {
  double error_m = 0.0, path_m = 0.0, error_rad = 0.0;
  for (const RealMotion& motion : motions) {
    const std::array<double, 3> here = predicted(constants, form, motion);
    error_m += magnitude(here[0] - motion.truth[0], here[1] - motion.truth[1]);
    error_rad += std::abs(here[2] - motion.truth[2]);
    path_m += motion.path_m;
  }
  return {100.0 * error_m / path_m, error_rad * kDegPerRad / static_cast<double>(motions.size())};
}

std::pair<double, double> yaw_error(const SlipForm& form, const SlipConstants& constants,
                                    const RealMotion& motion) {
  double difference_mps = 0.0;
  for (const SensedSpeeds& speeds : motion.speeds)
    difference_mps += speeds.right_mps - speeds.left_mps;
  const auto intervals = static_cast<double>(motion.speeds.size());
  const double seconds = motion.dt_s == 0.0 ? 1.0 : motion.dt_s * intervals;
  const double off = predicted(constants, form, motion)[2] - motion.truth[2];
  return {difference_mps / intervals, off / seconds};
}

struct Limit {
  const char *robot, *form, *figure;
  double most;
};
// A little above what was measured once: data and fit do not change from run to run.
constexpr Limit kLimits[] = {{"MAXXII", kPaperFitted, kYawRate, 10.4},
                             {"MAXXII", kPaperFitted, kSpeed, 4.15},
                             {"MAXXII", kPaperIcr, kLateral, 0.56},
                             {"MAXXII", kExtendedFitted, kYawRate, 10.4},
                             {"MAXXII", kExtendedFitted, kLateral, 0.56},
                             {"MAXXII", kBothSpeeds, kYawRate, 6.0},
                             {"MAXXII", kBothSpeeds, kLateral, 0.56},
                             {"Husky", kPaperFitted, kPosition, 24.3},
                             {"Husky", kPaperFitted, kYaw, 11.2},
                             {"Husky", kPaperIcr, kPosition, 22.7},
                             {"Husky", kExtendedFitted, kPosition, 18.2},
                             {"Husky", kBothSpeeds, kPosition, 18.4},
                             {"Husky", kPaperGyro, kYaw, 4.7}};

}  // namespace

double RealStudy::figure(const std::string& form, const std::string& figure) const {
  const auto of = std::find_if(forms.begin(), forms.end(),
                               [&](const RealForm& one) { return one.name == form; });
  const auto at = std::find(figures.begin(), figures.end(), figure);
  if (of == forms.end() || at == figures.end()) return std::numeric_limits<double>::quiet_NaN();
  return of->figures[0][static_cast<std::size_t>(at - figures.begin())];
}

RealStudy study_real(const RealRobot& robot) {
  const bool points = robot.stationary();
  const std::vector<SlipForm> forms = forms_for(robot);
  RealStudy study;
  study.robot = robot.name;
  study.motions = static_cast<int>(robot.motions.size());
  if (points)
    study.figures = {kYawRate, kSpeed, kLateral};
  else
    study.figures = {kPosition, kYaw};
  for (const SlipForm& form : forms) study.forms.push_back({.name = form.name});
  for (const Split& split : points ? kGridSplits : kWindowSplits) {
    study.splits.push_back(split.name);
    std::vector<RealMotion> fitted, judged;
    for (const RealMotion& motion : robot.motions)
      (split.fitted(motion) ? fitted : judged).push_back(motion);
    std::vector<std::pair<std::string, SlipConstants>> found;
    for (std::size_t i = 0; i < forms.size(); ++i) {
      const SlipForm& form = forms[i];
      const SlipFit now = fit(form, fitted, robot.gauge_m, start_of(form, robot, found));
      found.emplace_back(form.name, now.constants);
      study.forms[i].figures.push_back(points ? point_figures(form, now.constants, judged)
                                              : window_figures(form, now.constants, judged));
      if (study.splits.size() > 1) continue;
      study.forms[i].fit = now;
      for (const RealMotion& motion : judged)
        study.forms[i].yaw_errors.push_back(yaw_error(form, now.constants, motion));
    }
  }
  return study;
}

CourseStudy judged(const RealStudy& study) {
  CourseStudy result;
  result.course = "measured data";
  result.robot = study.robot;
  result.setup = "real";
  result.board = study.splits[0];
  result.runs = result.completed = 1;
  for (const RealForm& form : study.forms) {
    for (std::size_t i = 0; i < study.figures.size(); ++i) {
      const auto limit =
          std::find_if(std::begin(kLimits), std::end(kLimits), [&](const Limit& one) {
            return one.robot == study.robot && one.form == form.name &&
                   one.figure == study.figures[i];
          });
      if (limit == std::end(kLimits)) continue;
      const std::size_t unit = study.figures[i].find(" [");
      const double value = form.figures[0][i];
      result.judged.push_back(
          judged_value(result, form.name + ": " + study.figures[i].substr(0, unit),
                       study.figures[i].substr(unit + 2, study.figures[i].size() - unit - 3),
                       limit->most, value));
    }
  }
  return result;
}

}  // namespace tp100::sim
