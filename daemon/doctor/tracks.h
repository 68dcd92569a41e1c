#pragma once
// What driving each track on its own, with the robot on a stand, says of its wiring. Pure.

#include <optional>

#include "doctor/finding.h"

namespace tp100::doctor {

enum class Side { kLeft, kRight };

/// What became of a track that was to run forward and then back.
enum class Seen {
  kUnknown,     ///< nobody looked: on the floor the body's turn says it
  kAsAsked,     ///< it ran forward and then back
  kBackwards,   ///< it ran back and then forward
  kOtherTrack,  ///< the other one ran
  kNothing,     ///< neither ran
};

/// One drive. Half of what its way forward did less what its way back did, so that a bias and a
/// drift cancel.
struct TrackDrive {
  double left_m = 0.0;      ///< by the left encoder
  double right_m = 0.0;     ///< by the right one
  double turned_rad = 0.0;  ///< by the gyro, left positive
  Seen seen = Seen::kUnknown;
};

/// The keys of [drive] in force while it was driven.
struct Wiring {
  bool invert_left_motor = false, invert_right_motor = false;
  bool invert_left_encoder = false, invert_right_encoder = false;
  bool swap_tracks = false;
};

/// Did the body turn as both tracks ran against each other? Then it stood on the floor.
bool on_floor(double spin_rad);

/// Names: left-track, right-track, tracks.
Findings track_findings(const TrackDrive& left, const TrackDrive& right, const Wiring& wiring);

/// The gyro while somebody turned the robot to the left, or, on the floor, as the tracks did.
/// `tracks_well`: track_findings found nothing to mend. Name: gyro.
Findings gyro_findings(std::optional<double> hand_rad, double spin_rad, bool tracks_well);

}  // namespace tp100::doctor
