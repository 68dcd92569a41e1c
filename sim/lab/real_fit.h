#pragma once
// Forms of the model for real robots, and their least-squares fit to measured motion.

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "core/pose.h"
#include "model/track_model.h"
#include "sim/lab/real_data.h"

namespace tp100::sim {

/// Constants of a form: those of a robot file, and slip that depends on both track speeds. The
/// default has no slip.
struct SlipConstants : model::TrackParameters {
  SlipConstants() { slip_left = slip_right = slip_angle_straight_rad = 0.0; }

  double turning_centre_left_m = 0.0;   ///< times the yaw rate, subtracted from Vx
  double slip_by_difference_spm = 0.0;  ///< slip ratio of Vx per m/s between the tracks
  double wheelbase_opposed_shift_m =
      0.0;  ///< added to L while the tracks run in opposite directions
  /// Break-away in right turns: the yaw rate is reduced by exp((left - right - speed) / scale)
  /// rad/s.
  double break_away_mps = std::numeric_limits<double>::infinity();
  double break_away_scale_mps = 0.05;
};
using SlipConstant = double SlipConstants::*;

/// A form of the model: the constants that are fitted; the others keep their values.
struct SlipForm {
  std::string name;
  model::Mode mode = model::Mode::kExtended;
  std::vector<SlipConstant> free;
  bool gyro = false;  ///< the yaw rate is the gyro's
};

/// Name of a constant, with its unit (SI).
std::string name_of(SlipConstant constant);

/// Body twist for these speeds. Pure.
Twist twist_of(const SlipConstants& constants, const SlipForm& form, const SensedSpeeds& speeds);

/// The form's prediction of a motion's truth. Pure.
std::array<double, 3> predicted(const SlipConstants& constants, const SlipForm& form,
                                const RealMotion& motion);

/// A fitted constant. SI.
struct FittedConstant {
  SlipConstant constant = nullptr;
  double half_interval = 0.0;  ///< half-width of the 95 % interval
  bool shown = false;  ///< false: the data tell nothing; the interval is about as wide as the prior
};
struct SlipFit {
  SlipConstants constants{};
  std::vector<FittedConstant> fitted;
};

/// Least squares over the motions (Levenberg-Marquardt). An angle is weighted by the distance that
/// it causes at half the gauge (stationary points) or half the mean path (windows). A weak prior
/// keeps constants that the motions do not determine near `start`. Without free constants `start`
/// is returned. Pure.
SlipFit fit(const SlipForm& form, const std::vector<RealMotion>& motions, double gauge_m,
            const SlipConstants& start);

}  // namespace tp100::sim
