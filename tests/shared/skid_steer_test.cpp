// Track speeds, as robot and host compute them.
#include "shared/skid_steer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../support/sequence.h"

namespace tp100::shared {
namespace {

struct Robot {
  double wheelbase_m, slip_left, slip_right, max_track_mps;
  template <class Real>
  SkidSteer<Real> as() const {
    return {static_cast<Real>(wheelbase_m), static_cast<Real>(slip_left),
            static_cast<Real>(slip_right), static_cast<Real>(max_track_mps)};
  }
};

Robot any_robot(test::Sequence& any) {
  return {any.between(0.1, 0.5), any.between(-0.2, 0.5), any.between(-0.2, 0.5),
          any.between(0.05, 0.5)};
}

// The inverse of eqs 1 and 5. A robot that cannot do both keeps the turn and drives slower.
TEST(SkidSteer, GivesTheTurnAndAsMuchOfTheSpeedAsTheTracksCan) {
  test::Sequence any(1);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Robot robot = any_robot(any);
    const double speed = any.between(-0.6, 0.6), rate = any.between(-3.0, 3.0);
    const SkidSteer<double> skid = robot.as<double>();
    const TrackPair<double> tracks = skid.tracks_for(speed, rate);
    const double most = std::max(std::abs(tracks.left), std::abs(tracks.right));
    EXPECT_LE(most, robot.max_track_mps);
    const double left = tracks.left * (1.0 - robot.slip_left);
    const double right = tracks.right * (1.0 - robot.slip_right);
    // On the spot at full speed of both tracks.
    const double fastest =
        robot.max_track_mps * (2.0 - robot.slip_left - robot.slip_right) / robot.wheelbase_m;
    EXPECT_NEAR((right - left) / robot.wheelbase_m, std::clamp(rate, -fastest, fastest), 1e-9);
    EXPECT_NEAR((left + right) / 2.0, skid.speed_within(speed, rate), 1e-9);
    if (std::abs(speed - (left + right) / 2.0) > 1e-9) {
      EXPECT_NEAR(most, robot.max_track_mps, 1e-9) << "slower than necessary";
    }

    const TrackPair<double> back = skid.tracks_for(-speed, -rate);
    EXPECT_DOUBLE_EQ(back.left, -tracks.left);
    EXPECT_DOUBLE_EQ(back.right, -tracks.right);
    Robot other = robot;
    std::swap(other.slip_left, other.slip_right);
    const TrackPair<double> mirrored = other.as<double>().tracks_for(speed, -rate);
    EXPECT_DOUBLE_EQ(mirrored.left, tracks.right);
    EXPECT_DOUBLE_EQ(mirrored.right, tracks.left);
  }
}

TEST(SkidSteer, RobotAndHostAgreeAndANumberThatIsNoneMovesNoTrack) {
  test::Sequence any(2);
  for (int i = 0; i < 1000; ++i) {
    const Robot robot = any_robot(any);
    const double speed = any.between(-0.6, 0.6), rate = any.between(-3.0, 3.0);
    const TrackPair<double> host = robot.as<double>().tracks_for(speed, rate);
    const TrackPair<float> board =
        robot.as<float>().tracks_for(static_cast<float>(speed), static_cast<float>(rate));
    EXPECT_NEAR(host.left, static_cast<double>(board.left), 2e-6);
    EXPECT_NEAR(host.right, static_cast<double>(board.right), 2e-6);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(robot.as<float>().tracks_for(nan, 0.0f).left, 0.0f);
    EXPECT_EQ(robot.as<float>().tracks_for(nan, 0.0f).right, 0.0f);
  }
}

}  // namespace
}  // namespace tp100::shared
