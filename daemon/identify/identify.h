#pragma once
// Parameters of the model's forms from recorded drives: batch least squares over all runs of the
// poses that the model integrates from the encoders against the poses that a camera saw, or against
// what a tape and a protractor measure. The gyro's scale comes from the same turns. Counts per
// metre are taken as known: they cannot be separated from slip.
//
// Values that belong to a run and not to the robot are estimated and discarded: where the run
// began, the gyro's bias (from the rest at its beginning) and, for all runs together, how late the
// camera's time stamps are. A marker that is not above the reference point cannot be separated from
// a turning centre that is not below it.

#include <optional>
#include <string>
#include <vector>

#include "course/robot.h"
#include "identify/drive.h"
#include "identify/model_fit.h"
#include "model/model_form.h"
#include "model/track_parameters.h"

namespace tp100::identify {

/// Values assumed of a robot: the prior of an identification, and its result.
struct Prior {
  model::TrackParameters tracks{};
  double counts_per_metre = 11140.0;  ///< never fitted: it is not separable from slip
};

/// Result of identify.
struct Identification {
  Prior prior;     ///< the values of `extended`, to be used
  Fit extended{};  ///< the extended model (model::kExtendedForm)
  Fit before{};    ///< the same form with the assumed values: what the drives say of these
  /// By the drives on slopes, ascending; of several on one slope the mean. `prior` has them, too.
  std::vector<model::AddedSlip> slopes{};
  /// The simpler forms, from the same drives; nothing of a form that the drives do not determine,
  /// or of which nothing is to be fitted.
  model::PerBaseline<std::optional<Fit>> baselines{};
};

/// Estimates as many parameters as possible, starting from `base`. At least one run on level
/// ground, each with camera poses or hand measurements; otherwise throws UserError that names the
/// run. What slopes add to the slip comes from the runs on slopes, each by itself: from the
/// distance, and from the turn if it was measured; else both tracks slip alike. Deterministic;
/// pure.
Identification identify(const std::vector<RecordedDrive>& drives, const Prior& base,
                        const IdentifySettings& settings = {});

/// A drive as a run of a fit. Throws UserError: it has neither camera poses nor hand measurements,
/// or the robot does not move.
FittedRun fitted_run(const RecordedDrive& drive, const Prior& base);

/// The best fit of one form: parameters that the runs do not show stay as assumed.
Fit fit_of_form(const std::vector<FittedRun>& runs, const Prior& base, const model::ModelForm& form,
                const IdentifySettings& settings = {});

/// The fit of `extended` with every parameter free: what the runs do not show stays near what is
/// assumed, with an interval as wide. Without runs that is all of them.
ModelFit fit_of_all(const std::vector<FittedRun>& runs, const Prior& base,
                    const IdentifySettings& settings);

// Which courses calibrate a robot.

/// Bundled courses in driving order: straight, arcs from wide to tight and turns on the spot, both
/// directions. The three or four arcs are those of 0.9 to 10 gauges, from which wide and tight
/// turns of a robot of this size can be told apart. Pure.
std::vector<std::string> calibration_courses(const course::ShapeValues& shape);

}  // namespace tp100::identify
