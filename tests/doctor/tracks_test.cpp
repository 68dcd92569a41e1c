#include "doctor/tracks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fake_system.h"

namespace tp100::doctor {
namespace {

using test::find;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double kDistanceM = 0.09;
constexpr double kTurn = 0.3;

// A drive of the left track on a stand; `seen` is what a person observed.
TrackDrive left(double own_m, double other_m, ObservedMotion seen) {
  return {own_m, other_m, 0.0, seen};
}
// The right track is always in order.
const TrackDrive kGoodRight = {0.0, kDistanceM, 0.0, ObservedMotion::kAsAsked};

Finding judged(const TrackDrive& drive, const Wiring& wiring = {}) {
  const Findings findings = track_findings(drive, kGoodRight, wiring);
  EXPECT_EQ(find(findings, "right-track").severity, Severity::kOk);
  return find(findings, "left-track");
}

TEST(Tracks, ThatRunAsAskedAreWell) {
  EXPECT_EQ(judged(left(kDistanceM, 0.0, ObservedMotion::kAsAsked)).severity, Severity::kOk);
  EXPECT_EQ(judged(left(kDistanceM, 0.0, ObservedMotion::kUnknown)).severity, Severity::kOk);
}

TEST(Tracks, WithAnEncoderThatCountsBackwardsNameItsKey) {
  const Finding finding = judged(left(-kDistanceM, 0.0, ObservedMotion::kAsAsked));
  EXPECT_EQ(finding.severity, Severity::kError);
  EXPECT_EQ(finding.fix, "set drive.invert_left_encoder = true in the robot file");
  Wiring wiring;
  wiring.invert_left_encoder = true;
  EXPECT_EQ(judged(left(-kDistanceM, 0.0, ObservedMotion::kAsAsked), wiring).fix,
            "set drive.invert_left_encoder = false in the robot file");
  const Findings mirrored = track_findings(left(kDistanceM, 0.0, ObservedMotion::kAsAsked),
                                           {0.0, -kDistanceM, 0.0, ObservedMotion::kAsAsked}, {});
  EXPECT_EQ(find(mirrored, "right-track").fix,
            "set drive.invert_right_encoder = true in the robot file");
}

TEST(Tracks, WithAMotorThatRunsBackwardsNameItsKey) {
  const Finding finding = judged(left(-kDistanceM, 0.0, ObservedMotion::kBackwards));
  EXPECT_EQ(finding.severity, Severity::kError);
  EXPECT_EQ(finding.fix, "set drive.invert_left_motor = true in the robot file");
}

TEST(Tracks, WithMotorAndEncoderBackwardsNameBothKeys) {
  EXPECT_THAT(judged(left(kDistanceM, 0.0, ObservedMotion::kBackwards)).fix,
              AllOf(HasSubstr("drive.invert_left_motor = true"),
                    HasSubstr("drive.invert_left_encoder = true")));
}

TEST(Tracks, ThatNobodyLookedAtNameBothPossibilities) {
  EXPECT_THAT(judged(left(-kDistanceM, 0.0, ObservedMotion::kUnknown)).fix,
              AllOf(HasSubstr("drive.invert_left_motor"), HasSubstr("drive.invert_left_encoder")));
  EXPECT_THAT(judged(left(0.0, kDistanceM, ObservedMotion::kUnknown)).fix,
              HasSubstr("swap the plugs"));
  EXPECT_THAT(judged(left(0.0, 0.0, ObservedMotion::kUnknown)).fix, HasSubstr("check the plugs"));
}

TEST(Tracks, WithCrossedEncodersSaySo) {
  EXPECT_EQ(judged(left(0.0, kDistanceM, ObservedMotion::kAsAsked)).fix,
            "swap the plugs of the two encoders");
}

TEST(Tracks, WithCrossedMotorsSaySo) {
  EXPECT_EQ(judged(left(0.0, kDistanceM, ObservedMotion::kOtherTrack)).fix,
            "swap the plugs of the two motors");
}

TEST(Tracks, ThatAreSwappedWhollyNameTheKey) {
  EXPECT_THAT(judged(left(kDistanceM, 0.0, ObservedMotion::kOtherTrack)).fix,
              HasSubstr("set drive.swap_tracks = true"));
}

TEST(Tracks, WithADeadEncoderOrMotorNameItsPlug) {
  EXPECT_THAT(judged(left(0.0, 0.0, ObservedMotion::kAsAsked)).fix, HasSubstr("left encoder"));
  EXPECT_THAT(judged(left(0.0, 0.0, ObservedMotion::kBackwards)).fix,
              HasSubstr("set drive.invert_left_motor = true"));
  EXPECT_THAT(judged(left(0.0, 0.0, ObservedMotion::kNothing)).fix, HasSubstr("motors' battery"));
}

TEST(Tracks, OnTheFloorAreJudgedByTheBodysTurn) {
  const TrackDrive right = {0.0, kDistanceM, kTurn, ObservedMotion::kUnknown};
  EXPECT_EQ(find(track_findings({-kDistanceM, 0.0, -kTurn, ObservedMotion::kUnknown}, right, {}),
                 "left-track")
                .fix,
            "set drive.invert_left_encoder = true in the robot file");
  EXPECT_EQ(find(track_findings({-kDistanceM, 0.0, kTurn, ObservedMotion::kUnknown}, right, {}),
                 "left-track")
                .fix,
            "set drive.invert_left_motor = true in the robot file");
  const Findings swapped = track_findings({kDistanceM, 0.0, kTurn, ObservedMotion::kUnknown},
                                          {0.0, kDistanceM, -kTurn, ObservedMotion::kUnknown}, {});
  ASSERT_EQ(swapped.size(), 1U);
  EXPECT_EQ(swapped[0].name, "tracks");
  EXPECT_THAT(swapped[0].fix, HasSubstr("set drive.swap_tracks = true"));
}

TEST(Tracks, OnTheFloorDragTheOtherOneAlong) {
  const TrackDrive right = {0.8 * kDistanceM, kDistanceM, kTurn, ObservedMotion::kUnknown};
  EXPECT_EQ(count(track_findings({kDistanceM, 0.8 * kDistanceM, -kTurn, ObservedMotion::kUnknown},
                                 right, {}),
                  Severity::kOk),
            2U);
  EXPECT_EQ(find(track_findings({0.8 * kDistanceM, kDistanceM, -kTurn, ObservedMotion::kUnknown},
                                right, {}),
                 "left-track")
                .fix,
            "swap the plugs of the two encoders");
}

TEST(Gyro, IsJudgedByATurnToTheLeft) {
  EXPECT_EQ(gyro_findings(1.5, 0.0, true)[0].severity, Severity::kOk);
  const Finding wrong = gyro_findings(-1.5, 0.0, true)[0];
  EXPECT_EQ(wrong.severity, Severity::kError);
  EXPECT_THAT(wrong.fix, HasSubstr("chip side up"));
  const Finding none = gyro_findings(0.1, 0.0, true)[0];
  EXPECT_EQ(none.severity, Severity::kError);
  EXPECT_THAT(none.fix, HasSubstr("by a quarter"));
}

TEST(Gyro, IsJudgedByTheBodysTurnOrNotAtAll) {
  EXPECT_TRUE(on_floor(0.5));
  EXPECT_FALSE(on_floor(0.05));
  EXPECT_EQ(gyro_findings(std::nullopt, 0.5, true)[0].severity, Severity::kOk);
  EXPECT_EQ(gyro_findings(std::nullopt, 0.0, true)[0].severity, Severity::kWarning);
  const Finding untried = gyro_findings(std::nullopt, -0.5, false)[0];
  EXPECT_EQ(untried.severity, Severity::kWarning);
  EXPECT_THAT(untried.fix, HasSubstr("fix the tracks"));
}

}  // namespace
}  // namespace tp100::doctor
