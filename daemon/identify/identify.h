#pragma once
// Parameters of eqs 1-5 from recorded drives: batch least squares over all runs of the poses that
// the model integrates from the encoders against the poses that a camera saw, or against what a
// tape and a protractor say. The gyro's scale comes from the same turns. Counts per metre are taken
// as known: they cannot be told from slip.
//
// What is true of a run and not of the robot is found and forgotten: where the run began, the
// gyro's bias (from the rest at its beginning) and, for all runs together, how late the camera's
// time stamps are. A marker that is not above the reference point cannot be told from a turning
// centre that is not below it.

#include <vector>

#include "identify/drive.h"
#include "identify/model_fit.h"
#include "identify/parameter.h"

namespace tp100::identify {

/// What the runs say.
struct Identification {
  Belief belief;   ///< the values of `extended`, for use
  Fit extended{};  ///< eqs 1-5 with turning centre and tight turns (model/turn.h)
  Fit plain{};     ///< eqs 1-5 as they stand: those switched off
};

/// Finds what it can, starting from `base`. At least one run, each with camera poses or hand
/// measurements; throws SetupError that names the run otherwise. Deterministic; pure.
Identification identify(const std::vector<Drive>& drives, const Belief& base,
                        const IdentifySettings& settings = {});

}  // namespace tp100::identify
