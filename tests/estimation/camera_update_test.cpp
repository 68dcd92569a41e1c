// One camera sample: where the marker is expected, how much it counts, and whether it is believed.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <utility>

#include "any_motion.h"
#include "core/arithmetic.h"
#include "estimation/pose_filter.h"

namespace tp100::estimation {
namespace {

constexpr CameraPlace kPlace{0.4, -0.3};

Ground any_ground(AnyMotion& any) {
  return {.z_m = any.between(0.0, 0.2),
          .roll_rad = any.between(-0.5, 0.5),
          .pitch_rad = any.between(-0.7, 0.7),
          .tilt_radps = any.between(0.0, 3.0)};
}

// Two points of the marker, rotated with the body in space and seen from the lens on the plane of
// the marker of a level robot.
TEST(ExpectedMarker, IsTheImageOfAMarkerThatTiltsWithTheBody) {
  AnyMotion any(17);
  for (int i = 0; i < 500; ++i) {
    CameraParameters camera;
    camera.height_m = any.between(1.5, 3.0);
    camera.marker_height_m = any.between(0.03, 0.3);
    const Ground ground = any_ground(any);
    const Eigen::Vector3d pose(any.between(-1.0, 1.0), any.between(-1.0, 1.0),
                               any.between(-7.0, 7.0));
    const Eigen::Matrix3d turned = (Eigen::AngleAxisd(pose[2], Eigen::Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(ground.pitch_rad, Eigen::Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(ground.roll_rad, Eigen::Vector3d::UnitX()))
                                       .toRotationMatrix();
    const Eigen::Vector3d lens(kPlace.x_m, kPlace.y_m, camera.height_m);
    const auto pictured = [&](double ahead_m) {
      const Eigen::Vector3d at = Eigen::Vector3d(pose[0], pose[1], ground.z_m) +
                                 turned * Eigen::Vector3d(ahead_m, 0.0, camera.marker_height_m);
      const Eigen::Vector3d ray = at - lens;
      return Eigen::Vector3d(lens + ray * (camera.marker_height_m - lens[2]) / ray[2]);
    };
    const Eigen::Vector3d seen = expected_marker(pose, ground, camera, kPlace);
    const Eigen::Vector3d middle = pictured(0.0), along = pictured(1e-5) - pictured(-1e-5);
    ASSERT_NEAR(seen[0], middle[0], 1e-9) << i;
    ASSERT_NEAR(seen[1], middle[1], 1e-9) << i;
    ASSERT_NEAR(wrap_angle(seen[2] - std::atan2(along[1], along[0])), 0.0, 1e-6) << i;
    ASSERT_LT(std::abs(seen[2] - pose[2]), kPi / 2) << i << ": on the branch of the pose";
  }
}

/// A robot that does not change by the samples that it is shown, and its camera.
class Watched {
 public:
  /// `pose_sd_m`: of x, y and yaw [rad].
  explicit Watched(double pose_sd_m) {
    state_.mean << 0.7, -0.5, 2.9, 0.02, 0.03, -0.01, 0.04, 0.001;
    state_.covariance.diagonal().setConstant(square(pose_sd_m));
  }

  /// A sample that lies aside by this.
  CameraVerdict see(const Eigen::Vector3d& aside) {
    const Eigen::Vector3d marker = expected_marker(state_.mean.head<3>(), ground, {}, kPlace);
    after = state_;
    return update_.apply(after,
                         {.x_m = marker[0] + aside[0],
                          .y_m = marker[1] + aside[1],
                          .yaw_rad = marker[2] + aside[2] + 2.0 * kPi},
                         ground, twist, model_);
  }
  double nis() const { return update_.nis(); }
  Eigen::Vector3d moved() const { return (after.mean - state_.mean).head<3>(); }
  void resume() { update_.resume(update_.nis()); }

  Ground ground{};
  Twist twist{};
  FilterState after{};

 private:
  FilterState state_{};
  CameraUpdate update_{CameraParameters{}, kPlace};
  MotionModel model_{model::TrackParameters{}, FilterParameters{}};
};

// The noise of the place is that of an image, of a marker that sways with an attitude that is wrong
// by 3 deg while climbing and by what the body turns in 5 ms, and of the way in the time stamp's
// error; that of the yaw accordingly.
TEST(CameraUpdate, ASampleCountsByItsNoiseAgainstTheStates) {
  AnyMotion any(19);
  const CameraParameters camera;
  for (int i = 0; i < 200; ++i) {
    Watched watched(0.004);
    watched.ground = any_ground(any);
    watched.ground.hold_slip = any.chance(0.5);
    watched.twist = {any.between(-3.0, 3.0), 1.0, any.between(-9.0, 9.0)};
    const double attitude_rad = magnitude(watched.ground.hold_slip ? 3.0 * kRadPerDeg : 0.0,
                                          0.005 * watched.ground.tilt_radps);
    const double place = magnitude(camera.position_sd_m, camera.marker_height_m * attitude_rad,
                                   camera.time_sd_s * watched.twist.vx_mps);
    const double yaw =
        magnitude(camera.yaw_sd_rad, camera.time_sd_s * watched.twist.yaw_rate_radps);
    const Eigen::Vector3d aside(0.002, -0.003, 0.004);
    ASSERT_EQ(watched.see(aside), CameraVerdict::kUsed) << i;
    const double of_place = square(0.004) + square(place), of_yaw = square(0.004) + square(yaw);
    ASSERT_NEAR(watched.nis(), (square(0.002) + square(0.003)) / of_place + square(0.004) / of_yaw,
                1e-9);
    ASSERT_NEAR(watched.moved()[0], 0.002 * square(0.004) / of_place, 1e-9);
    ASSERT_NEAR(watched.moved()[1], -0.003 * square(0.004) / of_place, 1e-9);
    ASSERT_NEAR(watched.moved()[2], 0.004 * square(0.004) / of_yaw, 1e-9);
  }
}

TEST(CameraUpdate, ASampleIsBelievedUpToTheGateAndFoundMovedBeyondTheTriggerAndFarEnough) {
  const CameraParameters camera;
  // A state that is known so well that the gate is within the least movement, and one that is not.
  for (const double sd : {0.001, 0.006}) {
    const double sd_m = magnitude(sd, camera.position_sd_m);
    const double sd_rad = magnitude(sd, camera.yaw_sd_rad);
    for (const double side : {1.0, -1.0}) {
      for (double share = 0.1; share < 5.0; share += 0.0437) {
        const Eigen::Vector3d places[] = {{side * share * 0.012, 0.0, 0.0},
                                          {0.0, side * share * 0.012, 0.0},
                                          {0.0, 0.0, side * share * 0.04}};
        for (const Eigen::Vector3d& aside : places) {
          Watched watched(sd);
          const double nis = square(aside.head<2>().norm() / sd_m) + square(aside[2] / sd_rad);
          const bool far = aside.head<2>().norm() > 0.015 || std::abs(aside[2]) > 3.0 * kRadPerDeg;
          const CameraVerdict first = watched.see(aside), second = watched.see(aside);
          ASSERT_NEAR(watched.nis(), nis, 1e-6 * nis);
          const bool used = nis <= 11.3, moved = nis > 16.3 && far;
          ASSERT_EQ(first, used ? CameraVerdict::kUsed : CameraVerdict::kRejected) << aside;
          ASSERT_EQ(second, used    ? CameraVerdict::kUsed
                            : moved ? CameraVerdict::kRecovered
                                    : CameraVerdict::kRejected)
              << aside;
          if (second != CameraVerdict::kRecovered) continue;
          // The estimate is nearly that of the sample, and as certain.
          ASSERT_LT((watched.moved() - aside).norm(), 0.01 * aside.norm());
          ASSERT_LT(watched.after.covariance(kX, kX), 1.01 * square(camera.position_sd_m));
        }
      }
    }
  }
}

TEST(CameraUpdate, TwoSamplesThatFindTheRobotMovedConfirmEachOtherIfTheyAgree) {
  const Eigen::Vector3d first(0.2, -0.15, 0.1);
  const auto confirmed = [&](const Eigen::Vector3d& apart) {
    Watched watched(0.004);
    EXPECT_EQ(watched.see(first), CameraVerdict::kRejected);
    return watched.see(first + apart) == CameraVerdict::kRecovered;
  };
  for (const double side : {1.0, -1.0}) {
    for (const auto& [apart, far] : {std::pair{0.0299, false}, std::pair{0.0301, true}}) {
      EXPECT_NE(confirmed({side * apart, 0.0, 0.0}), far);
      EXPECT_NE(confirmed({0.0, side * apart, 0.0}), far);
      EXPECT_NE(confirmed({0.6 * side * apart, 0.8 * apart, 0.0}), far);
    }
    EXPECT_TRUE(confirmed({0.0, 0.0, side * 9.9 * kRadPerDeg}));
    EXPECT_FALSE(confirmed({0.0, 0.0, side * 10.1 * kRadPerDeg}));
  }
}

// Letters: a good sample, one that is a little too far away, ones that find the robot moved to one
// place or to another, and a resumed filter. The verdicts: used, rejected, recovered.
TEST(CameraUpdate, SequencesOfSamplesHaveTheirVerdicts) {
  const std::pair<const char*, const char*> sequences[] = {
      {"MMMMM", "rRrRr"},
      {"MNMNNN", "rrrrRr"},
      {"MgMM", "rurR"},
      {"MfMM", "rrRr"},
      {"M-MM", "r-rR"},
      {"ffffffffffffffffffff", "rrrrrrrrrurrrrrrrrru"},
      {"ffffffgfffffffffff", "rrrrrrurrrrrrrrrur"},
      {"fff-ffffffffff", "rrr-rrrrrrrrru"},
      {"fffffffffMf", "rrrrrrrrrru"},
      {"MNMNMNMNMNf", "rrrrrrrrrru"},
      {"ffffffffMMffffffffff", "rrrrrrrrrRrrrrrrrrru"}};
  for (const auto& [samples, expected] : sequences) {
    Watched watched(0.0012);
    std::string verdicts;
    for (const char* sample = samples; *sample != '\0'; ++sample) {
      if (*sample == '-') watched.resume();
      const CameraVerdict verdict = *sample == '-'   ? CameraVerdict::kRejected
                                    : *sample == 'g' ? watched.see({0.001, 0.0, 0.0})
                                    : *sample == 'f' ? watched.see({-0.01, 0.0, 0.0})
                                    : *sample == 'M' ? watched.see({0.1, 0.2, 0.5})
                                                     : watched.see({-0.3, 0.1, -1.0});
      verdicts += *sample == '-'                         ? '-'
                  : verdict == CameraVerdict::kUsed      ? 'u'
                  : verdict == CameraVerdict::kRecovered ? 'R'
                                                         : 'r';
    }
    EXPECT_EQ(verdicts, expected) << samples;
  }
}

}  // namespace
}  // namespace tp100::estimation
