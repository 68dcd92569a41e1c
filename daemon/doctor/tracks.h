#pragma once
// Diagnoses the wiring from driving each track on its own, with the robot on a stand. Pure.

#include <optional>

#include "doctor/finding.h"

namespace tp100::doctor {

enum class Side { kLeft, kRight };

/// Observed motion of a track that was commanded forward and then back.
enum class ObservedMotion {
  kUnknown,     ///< not observed: on the floor, the body's turn decides
  kAsAsked,     ///< forward and then back, as commanded
  kBackwards,   ///< back and then forward
  kOtherTrack,  ///< the other track moved
  kNothing,     ///< neither track moved
};

/// One drive: half of the difference between forward and backward distance, so that a bias and a
/// drift cancel.
struct TrackDrive {
  double left_m = 0.0;      ///< by the left encoder
  double right_m = 0.0;     ///< by the right one
  double turned_rad = 0.0;  ///< by the gyro, left positive
  ObservedMotion seen = ObservedMotion::kUnknown;
};

/// The keys of [drive] in effect during the drive.
struct Wiring {
  bool invert_left_motor = false, invert_right_motor = false;
  bool invert_left_encoder = false, invert_right_encoder = false;
  bool swap_tracks = false;
};

/// Whether the body turned as both tracks ran against each other, so that it stood on the floor.
bool on_floor(double spin_rad);

/// Names: left-track, right-track, tracks.
Findings track_findings(const TrackDrive& left, const TrackDrive& right, const Wiring& wiring);

/// Judges the gyro by a turn of the robot to the left by hand or, on the floor, by the tracks.
/// `tracks_well`: track_findings found nothing to fix. Name: gyro.
Findings gyro_findings(std::optional<double> hand_rad, double spin_rad, bool tracks_well);

}  // namespace tp100::doctor
