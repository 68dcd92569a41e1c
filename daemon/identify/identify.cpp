#include "identify/identify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/error.h"

namespace tp100::identify {
namespace {

// A parameter whose uncertainty is still this part of what it was before was not seen.
constexpr double kUnseen = 0.5;
// Turns of fewer radians in all say nothing of the wheelbase.
constexpr double kTurnedRad = 1.0;

constexpr std::array<Parameter, 7> kNotInThePaper = {
    Parameter::kXIcr,          Parameter::kWheelbaseTight, Parameter::kXIcrTightShift,
    Parameter::kWheelbaseSpin, Parameter::kXIcrSpinShift,  Parameter::kTurnSlip,
    Parameter::kTurnSlipTight};

Values values_of(const Belief& belief) {
  const model::TrackParameters& t = belief.tracks;
  return {t.slip_left,
          t.slip_right,
          t.slip_angle_straight_rad,
          t.slip_angle_turning_rad,
          t.wheelbase_m,
          t.x_icr_m,
          t.wheelbase_tight_m,
          t.x_icr_tight_shift_m,
          t.wheelbase_spin_m,
          t.x_icr_spin_shift_m,
          t.turn_slip,
          t.turn_slip_tight,
          belief.gyro_scale,
          0.0};
}

/// The wheelbase that explains how far the runs turned if slip is as believed: from there the rest
/// converges.
double first_wheelbase(const std::vector<FittedRun>& runs, const Belief& base) {
  double products = 0.0, squares = 0.0;
  for (const FittedRun& run : runs) {
    const double difference = run.motion.right_m() * (1.0 - base.tracks.slip_right) -
                              run.motion.left_m() * (1.0 - base.tracks.slip_left);
    const double turned =
        run.measured.turned_rad.value_or(base.gyro_scale * run.motion.gyro_rad(run.motion.end_s()));
    products += difference * turned;
    squares += turned * turned;
  }
  if (squares < kTurnedRad * kTurnedRad) return base.tracks.wheelbase_m;
  return std::clamp(products / squares, 0.05, 2.0);
}

/// Fits what is wanted and seen; what the runs do not show stays as believed.
Fit best_fit(const std::vector<FittedRun>& runs, const Belief& base, Free free, bool plain,
             const IdentifySettings& settings) {
  Values believed = values_of(base);
  for (const Parameter parameter : kNotInThePaper) {
    if (!plain) break;
    believed[index(parameter)] = 0.0;
    free[index(parameter)] = false;
  }
  // Which parameters these drives cannot tell apart depends on the drives, not on the parameters
  // that were dropped for it: it is judged by the fit with all of them.
  std::optional<Fit> with_all;
  while (true) {
    Values start = believed;
    if (free[index(Parameter::kWheelbase)])
      start[index(Parameter::kWheelbase)] = first_wheelbase(runs, base);
    for (const Parameter tighter : {Parameter::kWheelbaseTight, Parameter::kWheelbaseSpin})
      if (free[index(tighter)]) start[index(tighter)] = start[index(Parameter::kWheelbase)];
    ModelFit model_fit(runs, start, believed, free, base.tracks.turning_threshold_radps, settings);
    model_fit.solve();
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

}  // namespace

Identification identify(const std::vector<Drive>& drives, const Belief& base,
                        const IdentifySettings& settings) {
  if (drives.empty()) throw SetupError("identify: no runs; give at least one recording");
  std::vector<FittedRun> runs;
  bool camera = false;
  for (const Drive& drive : drives) {
    const HandMeasured& m = drive.measured;
    const bool measured = m.distance_m || m.ahead_m || m.left_m || m.turned_rad;
    FittedRun& run = runs.emplace_back(drive, base.counts_per_metre, base.gyro_scale);
    if (run.pictures.empty() && !measured)
      throw SetupError(drive.name +
                       ": neither camera poses nor hand measurements; give --measured FILE");
    if (run.motion.moves_s() >= run.motion.end_s())
      throw SetupError(drive.name + ": the robot does not move; leave this run out");
    camera = camera || !run.pictures.empty();
  }

  Free free{};
  free.fill(true);
  free[kDelay] = camera;
  Identification found;
  found.extended = best_fit(runs, base, free, false, settings);
  found.plain = best_fit(runs, base, free, true, settings);

  const auto value = [&found](Parameter parameter) { return found.extended[parameter].value; };
  found.belief = base;
  model::TrackParameters& tracks = found.belief.tracks;
  tracks.slip_left = value(Parameter::kSlipLeft);
  tracks.slip_right = value(Parameter::kSlipRight);
  tracks.slip_angle_straight_rad = value(Parameter::kSlipAngleStraight);
  tracks.slip_angle_turning_rad = value(Parameter::kSlipAngleTurning);
  tracks.wheelbase_m = value(Parameter::kWheelbase);
  tracks.x_icr_m = value(Parameter::kXIcr);
  tracks.wheelbase_tight_m = value(Parameter::kWheelbaseTight);
  tracks.x_icr_tight_shift_m = value(Parameter::kXIcrTightShift);
  tracks.wheelbase_spin_m = value(Parameter::kWheelbaseSpin);
  tracks.x_icr_spin_shift_m = value(Parameter::kXIcrSpinShift);
  tracks.turn_slip = value(Parameter::kTurnSlip);
  tracks.turn_slip_tight = value(Parameter::kTurnSlipTight);
  found.belief.gyro_scale = value(Parameter::kGyroScale);
  return found;
}

}  // namespace tp100::identify
