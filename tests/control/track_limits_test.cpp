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

// The greatest speed at which the firmware cuts nothing.
TEST(TrackLimits, TheSpeedAlongACurveLeavesTheTracksWhatTheTurnNeeds) {
  for (const double wheelbase_m : {0.27, 0.5}) {
    TrackLimits limits = kLimits;
    limits.wheelbase_m = wheelbase_m;
    const wire::Parameters sent = as_sent(limits);
    const auto driven = [&](double speed, double error, double curvature) {
      const auto turn = static_cast<float>(turn_asked(error, curvature * speed, limits));
      const firmware::TrackSpeeds tracks =
          firmware::track_speeds(static_cast<float>(speed), turn, sent);
      return (static_cast<double>(tracks.left) * (1.0 - limits.slip_left) +
              static_cast<double>(tracks.right) * (1.0 - limits.slip_right)) /
             2.0;
    };
    for (const double error : {-0.5, -0.1, 0.0, 0.2, 1.0}) {
      for (const double curvature : {-8.0, 0.0, 3.0, 20.0}) {
        SCOPED_TRACE(testing::Message() << wheelbase_m << ' ' << error << ' ' << curvature);
        const double speed = speed_along(0.3, error, curvature, limits);
        ASSERT_GE(speed, 0.0);
        if (speed > 0.0) {
          EXPECT_NEAR(driven(speed, error, curvature), speed, 1e-5);
        }
        EXPECT_LT(driven(speed + 1e-3, error, curvature), speed + 9e-4);
      }
    }
  }
}

}  // namespace
}  // namespace tp100::control
