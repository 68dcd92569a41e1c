#include "control/track_limits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "firmware/yaw_loop.h"

namespace tp100::control {
namespace {

constexpr TrackLimits kLimits{.wheelbase_m = 0.27,
                              .slip_left = 0.10,
                              .slip_right = 0.16,
                              .max_track_mps = 0.2,
                              .yaw_kp = 4.0,
                              .max_yaw_radps = 1.2};

wire::Parameters as_sent(const TrackLimits& limits) {
  wire::Parameters sent = {};
  sent.wheelbase_m = static_cast<float>(limits.wheelbase_m);
  sent.slip_left = static_cast<float>(limits.slip_left);
  sent.slip_right = static_cast<float>(limits.slip_right);
  sent.max_track_mps = static_cast<float>(limits.max_track_mps);
  sent.yaw_kp = static_cast<float>(limits.yaw_kp);
  sent.max_yaw_radps = static_cast<float>(limits.max_yaw_radps);
  return sent;
}

template <class Visit>
void for_many(Visit visit) {
  for (double speed = -0.3; speed <= 0.3; speed += 0.05) {
    for (double turn = -3.0; turn <= 3.0; turn += 0.25) visit(speed, turn);
  }
}

TEST(TrackLimits, AreTheFirmwares) {
  const wire::Parameters sent = as_sent(kLimits);
  for_many([&](double speed, double turn) {
    const firmware::TrackSpeeds theirs =
        firmware::track_speeds(static_cast<float>(speed), static_cast<float>(turn), sent);
    const TrackSpeeds ours = tracks_for(speed, turn, kLimits);
    EXPECT_NEAR(ours.left_mps, static_cast<double>(theirs.left), 1e-6) << speed << ' ' << turn;
    EXPECT_NEAR(ours.right_mps, static_cast<double>(theirs.right), 1e-6) << speed << ' ' << turn;
    EXPECT_NEAR(turn_asked(turn / 3.0, speed, kLimits),
                static_cast<double>(firmware::turn_rate(static_cast<float>(turn / 3.0),
                                                        static_cast<float>(speed), sent)),
                1e-5);
  });
}

TEST(TrackLimits, TheTurnIsKeptAndTheSpeedGivesWay) {
  for_many([](double speed, double turn) {
    const TrackSpeeds tracks = tracks_for(speed, turn, kLimits);
    EXPECT_LE(std::abs(tracks.left_mps), kLimits.max_track_mps + 1e-12);
    EXPECT_LE(std::abs(tracks.right_mps), kLimits.max_track_mps + 1e-12);
    const double made = (tracks.right_mps * (1.0 - kLimits.slip_right) -
                         tracks.left_mps * (1.0 - kLimits.slip_left)) /
                        kLimits.wheelbase_m;
    const double greatest = kLimits.max_track_mps * (2.0 - kLimits.slip_left - kLimits.slip_right) /
                            kLimits.wheelbase_m;
    EXPECT_NEAR(made, std::clamp(turn, -greatest, greatest), 1e-9);
  });
}

TEST(TrackLimits, ACommandWithinThemIsNotCutByTheFirmware) {
  const wire::Parameters sent = as_sent(kLimits);
  for (const double error : {-0.5, -0.1, 0.0, 0.2}) {
    for (const double curvature : {-8.0, 0.0, 3.0, 20.0}) {
      const double speed = speed_along(0.3, error, curvature, kLimits);
      ASSERT_GE(speed, 0.0);
      const auto turn = static_cast<float>(turn_asked(error, curvature * speed, kLimits));
      const firmware::TrackSpeeds tracks =
          firmware::track_speeds(static_cast<float>(speed), turn, sent);
      const double driven = (static_cast<double>(tracks.left) * (1.0 - kLimits.slip_left) +
                             static_cast<double>(tracks.right) * (1.0 - kLimits.slip_right)) /
                            2.0;
      EXPECT_NEAR(driven, speed, 1e-5) << error << ' ' << curvature;
    }
  }
}

TEST(TrackLimits, TheSpeedAlongACurveIsTheGreatestThatFits) {
  const double speed = speed_along(1.0, 0.0, 3.0, kLimits);
  const double turn = 3.0 * speed;
  const TrackSpeeds tracks = tracks_for(speed, turn, kLimits);
  EXPECT_NEAR(std::max(tracks.left_mps, tracks.right_mps), kLimits.max_track_mps, 1e-3);
}

TEST(TrackLimits, AYawErrorThatTakesAllLeavesNoSpeed) {
  TrackLimits slow = kLimits;
  slow.wheelbase_m = 0.5;
  EXPECT_EQ(speed_along(0.1, 1.0, 0.0, slow), 0.0);
}

}  // namespace
}  // namespace tp100::control
