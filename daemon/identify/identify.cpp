#include "identify/identify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/arithmetic.h"
#include "core/error.h"
#include "shared/skid_steer.h"
#include "text/format.h"

namespace tp100::identify {
namespace {

using model::kTrackParameters;
using model::TrackParameters;

// A parameter whose uncertainty is still this fraction of the prior's was not observed.
constexpr double kUnseen = 0.5;
// Turns of fewer radians in total do not determine the wheelbase.
constexpr double kTurnedRad = 1.0;

/// The wheelbase that explains the rotation of the runs if slip is as assumed: from there the rest
/// converges.
double first_wheelbase(const std::vector<FittedRun>& runs, const Prior& base) {
  double products = 0.0, squares = 0.0;
  for (const FittedRun& run : runs) {
    const auto ground = shared::over_ground(run.motion.left_m(), run.motion.right_m(),
                                            base.tracks.slip_left, base.tracks.slip_right);
    const double difference = ground.right - ground.left;
    const double turned = run.measured.turned_rad.value_or(base.tracks.gyro_scale *
                                                           run.motion.gyro_rad(run.motion.end_s()));
    products += difference * turned;
    squares += turned * turned;
  }
  if (squares < kTurnedRad * kTurnedRad) return base.tracks.wheelbase_m;
  return std::clamp(products / squares, 0.05, 2.0);
}

Free all_free(const std::vector<FittedRun>& runs, const model::ModelForm& form) {
  Free free{};
  std::ranges::copy(form.fitted, free.begin());
  // Of the sensor: no form depends on it unless the gyro gives its yaw.
  free[model::row_of(&TrackParameters::gyro_scale)] = true;
  free[kDelay] =
      std::ranges::any_of(runs, [](const FittedRun& run) { return !run.images.empty(); });
  return free;
}

ModelFit fit_of(const std::vector<FittedRun>& runs, const Prior& base, const model::ModelForm& form,
                const Free& free, const IdentifySettings& settings) {
  const Values prior{.tracks = form.only(base.tracks)};
  Values start = prior;
  if (free[model::row_of(&TrackParameters::wheelbase_m)])
    start.tracks.wheelbase_m = first_wheelbase(runs, base);
  for (std::size_t i = 0; i < kTrackParameters.size(); ++i)
    if (free[i] && kTrackParameters[i].relative_to != nullptr)
      start[i] = start.tracks.*kTrackParameters[i].relative_to;
  ModelFit fit(form, runs, start, prior, free, settings);
  if (!runs.empty()) fit.solve();
  return fit;
}

/// The form with the values of `base`. Where each run began and how late the camera's time stamps
/// are is found all the same.
Fit unchanged_fit(const std::vector<FittedRun>& runs, const Prior& base,
                  const model::ModelForm& form, const IdentifySettings& settings) {
  const Values values{.tracks = form.only(base.tracks)};
  Free free{};
  free[kDelay] = true;
  ModelFit model_fit(form, runs, values, values, free, settings);
  model_fit.solve();
  return model_fit.fit();
}

std::optional<Fit> baseline_fit(const std::vector<FittedRun>& runs, const Prior& base,
                                const model::ModelForm& form, const IdentifySettings& settings) {
  const bool biased =
      std::ranges::all_of(runs, [](const FittedRun& run) { return run.motion.has_bias(); });
  if (form.fixed != nullptr || (form.yaw_from_gyro && !biased)) return std::nullopt;
  const Fit fit = fit_of_form(runs, base, form, settings);
  for (std::size_t i = 0; i < kTrackParameters.size(); ++i)
    if (form.fitted[i] && !fit.estimates[i].found) return std::nullopt;
  return fit;
}

// Runs on slopes that differ by less are of one slope.
constexpr double kSameSlopeRad = 0.5 * kRadPerDeg;
constexpr double kLeastOnSlopeM = 0.1;
constexpr double kMostTurnedOnSlopeRad = 0.35;

void require_straight_run(const RecordedDrive& drive, const Prior& base) {
  const DriveMotion motion(drive, base.counts_per_metre);
  if (drive.measured.distance_m.value_or(0.0) < kLeastOnSlopeM || motion.left_m() <= 0.0 ||
      motion.right_m() <= 0.0)
    throw UserError(drive.name +
                    ": on a slope a run must go forward by 0.1 m at least, nose first; leave it "
                    "out or correct distance_m");
  if (std::abs(drive.measured.turned_rad.value_or(0.0)) > kMostTurnedOnSlopeRad)
    throw UserError(drive.name +
                    ": turned by more than 20 deg; on a slope only straight runs "
                    "count, leave it out");
}

/// Slopes of the drives, ascending, each from the first of those that are alike.
std::vector<double> slopes_of(const std::vector<RecordedDrive>& drives) {
  std::vector<double> all, slopes;
  for (const RecordedDrive& drive : drives)
    if (drive.measured.slope_rad) all.push_back(*drive.measured.slope_rad);
  std::ranges::sort(all);
  for (const double slope_rad : all)
    if (slopes.empty() || slope_rad - slopes.back() > kSameSlopeRad) slopes.push_back(slope_rad);
  if (slopes.size() > model::kMaxSlopes)
    throw UserError("identify: runs on more than " + std::to_string(model::kMaxSlopes) +
                    " slopes; leave out some");
  return slopes;
}

double possible_slip(const RecordedDrive& drive, const char* track, double added) {
  if (!(added >= model::kLeastAddedSlip && added <= model::kMostAddedSlip))
    throw UserError(text::format(
        "%s: its slope would add %.2f to the slip of the %s track, outside %.1f to %.1f; correct "
        "distance_m or turned_deg, or leave the run out",
        drive.name.c_str(), added, track, model::kLeastAddedSlip, model::kMostAddedSlip));
  return added;
}

/// What the slope of this straight run adds to the slip ratios of the level.
model::AddedSlip added_slip_of(const RecordedDrive& drive, const Prior& level) {
  const DriveMotion motion(drive, level.counts_per_metre);
  const model::TrackParameters& tracks = level.tracks;
  const double distance_m = *drive.measured.distance_m;
  const auto [left_m, right_m] =
      shared::over_ground(motion.left_m(), motion.right_m(), tracks.slip_left, tracks.slip_right);
  const double half_m = drive.measured.turned_rad
                            ? *drive.measured.turned_rad * tracks.wheelbase_m / 2.0
                            : (right_m - left_m) / 2.0;
  return {*drive.measured.slope_rad,
          possible_slip(drive, "left", (left_m - (distance_m - half_m)) / motion.left_m()),
          possible_slip(drive, "right", (right_m - (distance_m + half_m)) / motion.right_m())};
}

/// Of the drives on these slopes; of several on one slope the mean.
std::vector<model::AddedSlip> added_slips_of(const std::vector<RecordedDrive>& drives,
                                             const std::vector<double>& slopes,
                                             const Prior& level) {
  std::vector<model::AddedSlip> means;
  for (const double slope_rad : slopes) {
    model::AddedSlip sum{.slope_rad = slope_rad};
    double runs = 0.0;
    for (const RecordedDrive& drive : drives) {
      if (!drive.measured.slope_rad) continue;
      const double above_rad = *drive.measured.slope_rad - slope_rad;
      if (above_rad < 0.0 || above_rad > kSameSlopeRad) continue;
      const model::AddedSlip one = added_slip_of(drive, level);
      sum.left += one.left;
      sum.right += one.right;
      runs += 1.0;
    }
    means.push_back({slope_rad, sum.left / runs, sum.right / runs});
  }
  return means;
}

}  // namespace

FittedRun fitted_run(const RecordedDrive& drive, const Prior& base) {
  const HandMeasured& m = drive.measured;
  const bool measured = m.distance_m || m.ahead_m || m.left_m || m.turned_rad;
  FittedRun run(drive, base.counts_per_metre, base.tracks.gyro_scale);
  if (run.images.empty() && !measured)
    throw UserError(drive.name +
                    ": neither camera poses nor hand measurements; give --measured FILE");
  if (run.motion.moves_s() >= run.motion.end_s())
    throw UserError(drive.name + ": the robot does not move; leave this run out");
  return run;
}

Fit fit_of_form(const std::vector<FittedRun>& runs, const Prior& base, const model::ModelForm& form,
                const IdentifySettings& settings) {
  Free free = all_free(runs, form);
  // Which parameters these drives cannot separate depends on the drives, not on the parameters
  // dropped for it: it is judged by the fit with all of them.
  std::optional<Fit> with_all;
  while (true) {
    const ModelFit model_fit = fit_of(runs, base, form, free, settings);
    const auto left = model_fit.uncertainty_left();
    const auto worst = std::max_element(left.begin(), left.end());
    Fit fit = model_fit.fit();
    if (!with_all) with_all = fit;
    if (*worst < kUnseen) {
      fit.confused = with_all->confused;
      fit.condition = with_all->condition;
      return fit;
    }
    free[static_cast<std::size_t>(worst - left.begin())] = false;
  }
}

ModelFit fit_of_all(const std::vector<FittedRun>& runs, const Prior& base,
                    const IdentifySettings& settings) {
  return fit_of(runs, base, model::kExtendedForm, all_free(runs, model::kExtendedForm), settings);
}

Identification identify(const std::vector<RecordedDrive>& drives, const Prior& base,
                        const IdentifySettings& settings) {
  if (drives.empty()) throw UserError("identify: no runs; give at least one recording");
  std::vector<FittedRun> runs;
  for (const RecordedDrive& drive : drives) {
    if (drive.measured.slope_rad)
      require_straight_run(drive, base);
    else
      runs.push_back(fitted_run(drive, base));
  }
  if (runs.empty())
    throw UserError("identify: only runs on slopes; give runs on level ground, too");
  const std::vector<double> slopes = slopes_of(drives);

  Identification found;
  found.extended = fit_of_form(runs, base, model::kExtendedForm, settings);
  found.before = unchanged_fit(runs, base, model::kExtendedForm, settings);
  for (std::size_t i = 0; i < model::kBaselines.size(); ++i)
    found.baselines[i] = baseline_fit(runs, base, model::kBaselines[i], settings);

  found.prior = base;
  for (const model::ParameterRow& row : kTrackParameters)
    found.prior.tracks.*row.value = found.extended[row.value].value;
  found.slopes = added_slips_of(drives, slopes, found.prior);
  if (!found.slopes.empty()) {
    std::ranges::copy(found.slopes, found.prior.tracks.added_slips.begin());
    found.prior.tracks.slopes = found.slopes.size();
  }
  return found;
}

std::vector<std::string> calibration_courses(const course::ShapeValues& shape) {
  struct Arc {
    double radius_m;
    const char* name;
  };
  constexpr std::array kArcs = {Arc{2.0, "widest"}, Arc{1.0, "wide"}, Arc{0.5, "arc"},
                                Arc{0.25, "tight"}};
  // Between a turn that is nearly on the spot and one in which the tracks hardly differ.
  constexpr double kTightestGauges = 0.9, kWidestGauges = 10.0;
  // Beyond these fewer than three arcs are in between.
  const double gauge_m = std::clamp(shape.gauge_m, 0.1, 0.55);
  std::vector<std::string> names = {"calibrate-straight"};
  for (const auto& [radius_m, name] : kArcs) {
    const double gauges = radius_m / gauge_m;
    if (gauges < kTightestGauges || gauges > kWidestGauges) continue;
    for (const char* side : {"-left", "-right"})
      names.push_back(std::string("calibrate-") + name + side);
  }
  names.insert(names.end(), {"calibrate-spin-left", "calibrate-spin-right"});
  return names;
}

}  // namespace tp100::identify
