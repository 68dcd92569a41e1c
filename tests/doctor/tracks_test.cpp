// What the doctor concludes from driving each track on its own, and from turning the robot.

#include "doctor/tracks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "fake_system.h"

namespace tp100::doctor {
namespace {

using test::find;
using ::testing::HasSubstr;

constexpr double kDistanceM = 0.09;
constexpr double kTurn = 0.3;

/// A drive of one track, by the encoder of that track and of the other one. On a stand the body
/// does not turn.
TrackDrive drive(Side side, double own_m, double other_m, ObservedMotion seen,
                 double turned_rad = 0.0) {
  return side == Side::kLeft ? TrackDrive{own_m, other_m, turned_rad, seen}
                             : TrackDrive{other_m, own_m, turned_rad, seen};
}

std::string replaced(std::string text, const std::string& word, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += by.size())
    text.replace(at, word.size(), by);
  return text;
}

// The advice must be for the track that was driven, and must turn over the key that is set now.
TEST(Tracks, EveryDefectNamesWhatMendsIt) {
  using enum ObservedMotion;
  const struct {
    double own_m, other_m;
    ObservedMotion seen;
    const char* fix;  // empty: the track is well
  } cases[] = {
      {kDistanceM, 0.0, kAsAsked, ""},
      {kDistanceM, 0.0, kUnknown, ""},
      {-kDistanceM, 0.0, kAsAsked, "set drive.invert_SIDE_encoder = NOT in the robot file"},
      {-kDistanceM, 0.0, kBackwards, "set drive.invert_SIDE_motor = NOT in the robot file"},
      {kDistanceM, 0.0, kBackwards,
       "set drive.invert_SIDE_motor = NOT in the robot file, and "
       "set drive.invert_SIDE_encoder = NOT in the robot file"},
      {0.0, 0.0, kBackwards, "set drive.invert_SIDE_motor = NOT in the robot file, then run this"},
      {-kDistanceM, 0.0, kUnknown,
       "if the track ran forward first: set drive.invert_SIDE_encoder = NOT in the robot file; "
       "else: set drive.invert_SIDE_motor = NOT in the robot file"},
      {0.0, kDistanceM, kUnknown, "swap the plugs of the two encoders, or of the two motors"},
      {0.0, 0.0, kUnknown, "check the plugs of its motor and its encoder"},
      {0.0, kDistanceM, kAsAsked, "swap the plugs of the two encoders"},
      {0.0, kDistanceM, kOtherTrack, "swap the plugs of the two motors"},
      {kDistanceM, 0.0, kOtherTrack, "set drive.swap_tracks = NOT in the robot file"},
      {0.0, 0.0, kAsAsked, "check the plug and the two signals of the SIDE encoder"},
      {0.0, 0.0, kNothing, "the motors' battery is switched on"},
  };
  for (const auto& it : cases) {
    for (const Side side : {Side::kLeft, Side::kRight}) {
      for (const bool set : {false, true}) {
        const std::string name = side == Side::kLeft ? "left" : "right";
        SCOPED_TRACE(name + " track, keys " + (set ? "set" : "not set") + ": " + it.fix);
        const Side other = side == Side::kLeft ? Side::kRight : Side::kLeft;
        const TrackDrive driven = drive(side, it.own_m, it.other_m, it.seen);
        const TrackDrive good = drive(other, kDistanceM, 0.0, kAsAsked);
        const bool left = side == Side::kLeft;
        // Only the keys of the driven track, and the one that swaps both, are in question.
        const Wiring wiring = {.invert_left_motor = set == left,
                               .invert_right_motor = set != left,
                               .invert_left_encoder = set == left,
                               .invert_right_encoder = set != left,
                               .swap_tracks = set};
        const Findings findings =
            track_findings(left ? driven : good, left ? good : driven, wiring);
        EXPECT_EQ(find(findings, (left ? "right" : "left") + std::string("-track")).severity,
                  Severity::kOk);
        const Finding found = find(findings, name + "-track");
        const std::string fix =
            replaced(replaced(it.fix, "SIDE", name), "NOT", set ? "false" : "true");
        EXPECT_EQ(found.severity, fix.empty() ? Severity::kOk : Severity::kError);
        EXPECT_THAT(found.fix, HasSubstr(fix));
      }
    }
  }
}

// A left track that runs forward turns the body to the right.
TEST(Tracks, OnTheFloorAreJudgedByTheBodysTurn) {
  constexpr auto kUnseen = ObservedMotion::kUnknown;
  const TrackDrive right = drive(Side::kRight, kDistanceM, 0.0, kUnseen, kTurn);
  const auto left_fix = [&](double own_m, double other_m, double turned_rad) {
    const TrackDrive left = drive(Side::kLeft, own_m, other_m, kUnseen, turned_rad);
    return find(track_findings(left, right, {}), "left-track").fix;
  };
  EXPECT_EQ(left_fix(kDistanceM, 0.0, -kTurn), "");
  EXPECT_EQ(left_fix(-kDistanceM, 0.0, -kTurn),
            "set drive.invert_left_encoder = true in the robot file");
  EXPECT_EQ(left_fix(-kDistanceM, 0.0, kTurn),
            "set drive.invert_left_motor = true in the robot file");
  // The other track is dragged along.
  EXPECT_EQ(left_fix(kDistanceM, 0.8 * kDistanceM, -kTurn), "");
  EXPECT_EQ(left_fix(0.8 * kDistanceM, kDistanceM, -kTurn), "swap the plugs of the two encoders");

  const Findings swapped =
      track_findings(drive(Side::kLeft, kDistanceM, 0.0, kUnseen, kTurn),
                     drive(Side::kRight, kDistanceM, 0.0, kUnseen, -kTurn), {});
  ASSERT_EQ(swapped.size(), 1U);
  EXPECT_EQ(swapped[0].name, "tracks");
  EXPECT_THAT(swapped[0].fix, HasSubstr("set drive.swap_tracks = true"));
}

// By a turn to the left by hand; without one, by the turn of the body on the floor, if the tracks
// are well.
TEST(Gyro, IsJudgedByATurnToTheLeft) {
  const struct {
    std::optional<double> hand_rad;
    double spin_rad;
    bool tracks_well;
    Severity severity;
    const char* fix;
  } cases[] = {
      {1.5, 0.0, true, Severity::kOk, ""},
      {-1.5, 0.0, true, Severity::kError, "chip side up"},
      {0.1, 0.0, true, Severity::kError, "by a quarter"},
      {-0.1, 0.0, true, Severity::kError, "by a quarter"},
      {std::nullopt, 0.5, true, Severity::kOk, ""},
      {std::nullopt, 0.05, true, Severity::kWarning, "in a terminal"},
      {std::nullopt, -0.5, false, Severity::kWarning, "fix the tracks"},
  };
  for (const auto& it : cases) {
    const Findings findings = gyro_findings(it.hand_rad, it.spin_rad, it.tracks_well);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].severity, it.severity) << it.fix;
    EXPECT_THAT(findings[0].fix, HasSubstr(it.fix));
  }
  EXPECT_TRUE(on_floor(0.5));
  EXPECT_FALSE(on_floor(0.05));
}

}  // namespace
}  // namespace tp100::doctor
