#pragma once
// Judges the daemon's estimates of slope, obstacle and camera noise: the part of `tp100-lab
// reproduce` about state rather than position.

#include <cstdint>
#include <vector>

#include "course/robot_file.h"
#include "model/step_climb.h"
#include "sim/lab/study.h"

namespace tp100::sim {

/// One instant of a drive over a block. Pitch as in poses: nose-up is negative.
struct ClimbSample {
  double travel_m = 0.0;  ///< of the tracks, since they touched the block
  model::ClimbPhase phase = model::ClimbPhase::kApproach;  ///< of the model
  double body_rad = 0.0, model_rad = 0.0;
  double paper_rad = 0.0;  ///< with eq 6 to the letter on the riser
};

/// A phase of the model on that drive, the approach left out.
struct ClimbPhaseCheck {
  model::ClimbPhase phase = model::ClimbPhase::kRiser;
  double from_m = 0.0;                              ///< travel at which it begins
  double model_rms_rad = 0.0, paper_rms_rad = 0.0;  ///< rms of their pitch minus the body's
};

/// Comparison of the step climb model with the emulated body under equal conditions (tracks without
/// deficit and with little creep): one drive straight over a block, from first touch until the body
/// is level behind it.
struct ClimbCheck {
  double pitch_rms_rad = 0.0;  ///< model's pitch minus the body's
  double pitch_max_rad = 0.0;
  double height_m = 0.0, depth_m = 0.0;  ///< of the block
  bool crossed = false;                  ///< the body got over it
  std::vector<ClimbSample> samples;      ///< one per physics step, with approach and level drive
  std::vector<ClimbPhaseCheck> phases;   ///< in their order
};

/// Drives the body of `robot` without track deficit and with little creep, and the model as
/// terrain::TerrainFollower uses it, both with tracks at `track_mps`, over a block of `height_m` by
/// `depth_m`. Pure. Throws UserError if the model cannot climb it.
ClimbCheck check_climb_pitch(const course::Robot& robot, double height_m, double depth_m,
                             double track_mps);

/// Three studies: the five courses on a flat floor (5 x `runs` drives; the slope's state must never
/// change), course 3 with its obstacles on the floor, and the step climb model against the body
/// without slip.
std::vector<CourseStudy> study_state(const course::Robot& robot, std::uint64_t first_seed,
                                     int runs);

}  // namespace tp100::sim
