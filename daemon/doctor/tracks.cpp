#include "doctor/tracks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/arithmetic.h"
#include "text/format.h"

namespace tp100::doctor {
namespace {

// A tenth of the distance that a track covers in a second of the test.
constexpr double kMovedM = 0.01;
// On the floor the other track is dragged along, and the body turns only by a few degrees.
constexpr double kBodyTurnedRad = 1.0 * kRadPerDeg;
constexpr double kSpunRad = 5.0 * kRadPerDeg;
constexpr double kHandTurnedRad = 20.0 * kRadPerDeg;

constexpr const char* kAgain = ", then run this test again";

std::string name_of(Side side) { return side == Side::kLeft ? "left" : "right"; }

std::string figures(const TrackDrive& drive) {
  return text::format("left encoder %+.3f m, right %+.3f m, gyro %+.0f deg", drive.left_m,
                      drive.right_m, drive.turned_rad * kDegPerRad);
}

/// The instruction to invert the key.
std::string turned_over(const std::string& key, bool now) {
  return "set drive." + key + " = " + (now ? "false" : "true") + " in the robot file";
}

std::string motor_fix(Side side, const Wiring& wiring) {
  return turned_over("invert_" + name_of(side) + "_motor",
                     side == Side::kLeft ? wiring.invert_left_motor : wiring.invert_right_motor);
}

std::string encoder_fix(Side side, const Wiring& wiring) {
  return turned_over("invert_" + name_of(side) + "_encoder", side == Side::kLeft
                                                                 ? wiring.invert_left_encoder
                                                                 : wiring.invert_right_encoder);
}

/// A left track that runs forward turns the body to the right.
ObservedMotion seen_of(Side side, const TrackDrive& drive) {
  const bool turned = std::abs(drive.turned_rad) > kBodyTurnedRad;
  if (drive.seen != ObservedMotion::kUnknown || !turned) return drive.seen;
  return (drive.turned_rad < 0.0) == (side == Side::kLeft) ? ObservedMotion::kAsAsked
                                                           : ObservedMotion::kBackwards;
}

/// Result of one drive.
struct Shown {
  Side side;
  double own_m;    // by the encoder of the driven track
  double other_m;  // by the other one
  ObservedMotion seen;
  std::string figures;

  bool crossed() const { return std::abs(other_m) > std::max(kMovedM, std::abs(own_m)); }
  bool forward() const { return own_m > kMovedM && !crossed(); }
  bool back() const { return own_m < -kMovedM && !crossed(); }
};

Shown shown(Side side, const TrackDrive& drive) {
  const bool left = side == Side::kLeft;
  return {side, left ? drive.left_m : drive.right_m, left ? drive.right_m : drive.left_m,
          seen_of(side, drive), figures(drive)};
}

Finding track_error(const Shown& drive, const std::string& what, std::string fix) {
  return error(name_of(drive.side) + "-track", what + " (" + drive.figures + ")", std::move(fix));
}

Finding judge_unseen(const Shown& drive, const Wiring& wiring) {
  const std::string side = name_of(drive.side);
  if (drive.forward()) return ok(side + "-track", drive.figures);
  if (drive.back())
    return track_error(drive, side + " encoder counts against its motor",
                       "if the track ran forward first: " + encoder_fix(drive.side, wiring) +
                           "; else: " + motor_fix(drive.side, wiring));
  if (drive.crossed())
    return track_error(
        drive, "driving the " + side + " track, the other encoder counts",
        "swap the plugs of the two encoders, or of the two motors" + std::string(kAgain));
  return track_error(drive, side + " track driven, but no encoder counts",
                     "check the plugs of its motor and its encoder, and the motors' battery");
}

Finding judge_as_asked(const Shown& drive, const Wiring& wiring) {
  const std::string side = name_of(drive.side);
  if (drive.forward()) return ok(side + "-track", drive.figures);
  if (drive.back())
    return track_error(drive, side + " encoder counts backwards", encoder_fix(drive.side, wiring));
  if (drive.crossed())
    return track_error(drive, "the " + side + " track ran, but the other encoder counted",
                       "swap the plugs of the two encoders");
  return track_error(drive, "the " + side + " track ran, but its encoder did not count",
                     "check the plug and the two signals of the " + side + " encoder");
}

Finding judge_backwards(const Shown& drive, const Wiring& wiring) {
  const std::string side = name_of(drive.side);
  const std::string motor = motor_fix(drive.side, wiring);
  if (drive.back()) return track_error(drive, side + " motor runs backwards", motor);
  if (drive.forward())
    return track_error(drive, side + " motor and encoder are both backwards",
                       motor + ", and " + encoder_fix(drive.side, wiring));
  return track_error(drive, side + " motor runs backwards, and its encoder does not count",
                     motor + kAgain);
}

Finding judge_other(const Shown& drive, const Wiring& wiring) {
  const std::string side = name_of(drive.side);
  if (drive.crossed())
    return track_error(drive, "driving the " + side + " track, the other one runs and counts",
                       "swap the plugs of the two motors");
  return track_error(drive, "left and right are plugged the wrong way round",
                     turned_over("swap_tracks", wiring.swap_tracks) + kAgain);
}

Finding judge(const Shown& drive, const Wiring& wiring) {
  switch (drive.seen) {
    case ObservedMotion::kAsAsked:
      return judge_as_asked(drive, wiring);
    case ObservedMotion::kBackwards:
      return judge_backwards(drive, wiring);
    case ObservedMotion::kOtherTrack:
      return judge_other(drive, wiring);
    case ObservedMotion::kNothing:
      return track_error(drive, "the " + name_of(drive.side) + " track does not run",
                         "check the plug of its motor and that the motors' battery is switched on");
    case ObservedMotion::kUnknown:
      break;
  }
  return judge_unseen(drive, wiring);
}

}  // namespace

bool on_floor(double spin_rad) { return std::abs(spin_rad) > kSpunRad; }

Findings track_findings(const TrackDrive& left, const TrackDrive& right, const Wiring& wiring) {
  const Shown first = shown(Side::kLeft, left);
  const Shown second = shown(Side::kRight, right);
  // The body alone cannot distinguish one track running back from the other running forward;
  // encoders that agree with both drives can.
  const bool nobody_looked =
      left.seen == ObservedMotion::kUnknown && right.seen == ObservedMotion::kUnknown;
  const bool mirrored =
      first.seen == ObservedMotion::kBackwards && second.seen == ObservedMotion::kBackwards;
  if (nobody_looked && mirrored && first.forward() && second.forward())
    return {error(
        "tracks",
        "left and right are plugged the wrong way round (driving left: " + first.figures + ")",
        turned_over("swap_tracks", wiring.swap_tracks) + kAgain)};
  return {judge(first, wiring), judge(second, wiring)};
}

Findings gyro_findings(std::optional<double> hand_rad, double spin_rad, bool tracks_well) {
  if (!hand_rad) {
    if (on_floor(spin_rad) && tracks_well)
      return {ok("gyro",
                 text::format("tracks turning left, it reads %+.0f deg", spin_rad * kDegPerRad))};
    return {warning("gyro", "its sign was not tested",
                    tracks_well
                        ? "run this test in a terminal, and turn the robot when it asks for it"
                        : "fix the tracks, then run this test again")};
  }
  const std::string seen =
      text::format("turned left by hand, the gyro reads %+.0f deg", *hand_rad * kDegPerRad);
  if (*hand_rad > kHandTurnedRad) return {ok("gyro", seen)};
  if (*hand_rad < -kHandTurnedRad)
    return {error("gyro", seen, "mount the MPU6050 level, chip side up (firmware/WIRING.md)")};
  return {error(
      "gyro", seen,
      "run this test again and turn the robot by a quarter to the left; if it reads the same, "
      "check that the MPU6050 lies level")};
}

}  // namespace tp100::doctor
