#include "estimation/pose_filter.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <random>

#include "core/arithmetic.h"
#include "interval.h"
#include "support/alloc_count.h"

namespace tp100::estimation {
namespace {

class PoseFilterTest : public testing::Test {
 protected:
  PoseFilterTest() {
    tracks_.slip_left = tracks_.slip_right = 0.16;
    tracks_.slip_angle_straight_rad = 0.0;
  }
  PoseFilter filter() const { return {tracks_, noise_, camera_, {}}; }

  /// Tracks that drive at `speed_mps` and turn at `rate_radps` with the given slip.
  FilterInput interval(double speed_mps, double rate_radps, model::Slip slip) {
    now_ += kPeriod;
    const double half = rate_radps * tracks_.wheelbase_m / 2.0;
    return {
        .end_ns = now_,
        .dt_s = kDt,
        .tracks = {(speed_mps - half) / (1.0 - slip.left), (speed_mps + half) / (1.0 - slip.right)},
        .gyro_z_radps = rate_radps,
        .gyro = true,
        .ground = {.slip = {tracks_.slip_left, tracks_.slip_right}}};
  }
  FilterInput interval(double speed_mps, double rate_radps) {
    return interval(speed_mps, rate_radps, {tracks_.slip_left, tracks_.slip_right});
  }
  CameraSample seen(const Pose& pose) {
    return {pose.x_m, pose.y_m, pose.yaw_rad, now_, ++sequence_};
  }

  model::TrackParameters tracks_{};
  FilterParameters noise_{};
  CameraParameters camera_{};
  HostNs now_ = kNsPerS;
  std::uint32_t sequence_ = 0;
};

TEST_F(PoseFilterTest, WithoutACameraItIsOdometryToTheBit) {
  for (const bool gyro : {true, false}) {
    PoseFilter fused = filter();
    Odometry odometry(tracks_, noise_);
    fused.begin({.x_m = 0.3, .yaw_rad = 1.0}, now_);
    odometry.begin({.x_m = 0.3, .yaw_rad = 1.0});
    for (int i = 0; i < 2000; ++i) {
      FilterInput in = interval(0.1, 0.3 * std::sin(i * kDt), {0.18, 0.17});
      in.gyro = gyro;
      fused.advance(in);
      odometry.advance(in);
      if (i > 500) continue;
      fused.standstill({0.01, 0.003});
      odometry.standstill({0.01, 0.003});
    }
    EXPECT_EQ(fused.state().mean, odometry.state().mean);
    EXPECT_EQ(fused.state().covariance, odometry.state().covariance);
    EXPECT_EQ(fused.twist().vx_mps, odometry.twist().vx_mps);
    EXPECT_EQ(fused.figures(now_).camera_age_us, -1);
  }
}

TEST_F(PoseFilterTest, ALateSampleDoesWhatItWouldHaveDoneInTime) {
  PoseFilter in_time = filter(), late = filter();
  CameraSample sample;
  for (int i = 0; i < 100; ++i) {
    FilterInput in = interval(0.1, 0.5 * std::cos(i * 0.1));
    in.tracks.left_mps *= 1.05;
    in_time.advance(in);
    late.advance(in);
    if (i == 60) {
      sample = seen({.x_m = in_time.pose().x_m + 0.004,
                     .y_m = in_time.pose().y_m - 0.003,
                     .yaw_rad = in_time.pose().yaw_rad + 0.01});
      in_time.camera(sample);
    }
    if (i == 85) late.camera(sample);
  }
  EXPECT_EQ(late.figures(now_).camera_used, 1u);
  EXPECT_LT((in_time.state().mean - late.state().mean).norm(), 1e-12);
  EXPECT_LT((in_time.state().covariance - late.state().covariance).norm(), 1e-12);
}

TEST_F(PoseFilterTest, ASampleFromWithinAnIntervalIsPutThere) {
  PoseFilter fine = filter(), coarse = filter();
  CameraSample sample;
  for (int i = 0; i < 20; ++i) {
    FilterInput in = interval(0.1, 0.0);
    coarse.advance(in);
    FilterInput first = in, second = in;
    first.dt_s = 0.003;
    first.end_ns -= 2 * kNsPerMs;
    second.dt_s = 0.002;
    if (i == 19) {
      fine.advance(first);
      sample = {fine.pose().x_m + 0.003, 0.002, 0.0, first.end_ns, 1};
      fine.camera(sample);
      fine.advance(second);
    } else {
      fine.advance(in);
    }
  }
  coarse.camera(sample);
  EXPECT_LT((fine.state().mean.head<3>() - coarse.state().mean.head<3>()).norm(), 1e-9);
}

TEST_F(PoseFilterTest, SamplesThatMakeNoSenseAreNotUsed) {
  PoseFilter fused = filter();
  for (int i = 0; i < 400; ++i) fused.advance(interval(0.0, 0.0));
  const FilterState before = fused.state();
  for (double Pose::*const value : {&Pose::x_m, &Pose::y_m, &Pose::yaw_rad}) {
    Pose bad;
    bad.*value = std::numeric_limits<double>::quiet_NaN();
    fused.camera(seen(bad));
  }
  CameraSample old = seen({});
  old.measured_ns -= 2 * kNsPerS;
  fused.camera(old);
  fused.camera(seen({.x_m = 0.5}));
  EXPECT_EQ(fused.state().mean, before.mean);
  EXPECT_EQ(fused.figures(now_).camera_rejected, 5u);
  CameraSample again = seen({});
  again.measured_ns -= kNsPerMs;  // older than the one above
  fused.camera(again);
  EXPECT_EQ(fused.figures(now_).camera_rejected, 6u);
}

TEST_F(PoseFilterTest, ASampleAheadOfTheEncodersWaitsForThem) {
  PoseFilter fused = filter();
  fused.advance(interval(0.1, 0.0));
  CameraSample early = seen({.x_m = 0.003});
  early.measured_ns += 12 * kNsPerMs;
  fused.camera(early);
  fused.advance(interval(0.1, 0.0));
  EXPECT_EQ(fused.figures(now_).camera_used, 0u);
  for (int i = 0; i < 3; ++i) fused.advance(interval(0.1, 0.0));
  EXPECT_EQ(fused.figures(now_).camera_used, 1u);
}

TEST_F(PoseFilterTest, TheErrorCommonToAllImagesCountsOnceACameraIsUsed) {
  PoseFilter fused = filter();
  const auto common_m2 = [&](double PlanarCovariance::*of, Eigen::Index state) {
    return fused.pose_covariance().*of - fused.state().covariance(state, state);
  };
  fused.advance(interval(0.0, 0.0));
  EXPECT_EQ(common_m2(&PlanarCovariance::xx, kX), 0.0);
  EXPECT_EQ(common_m2(&PlanarCovariance::yy, kY), 0.0);
  fused.camera(seen({}));
  EXPECT_NEAR(common_m2(&PlanarCovariance::xx, kX), square(camera_.constant_sd_m), 1e-15);
  EXPECT_NEAR(common_m2(&PlanarCovariance::yy, kY), square(camera_.constant_sd_m), 1e-15);
  EXPECT_EQ(common_m2(&PlanarCovariance::yaw_yaw, kYaw), 0.0);
}

TEST_F(PoseFilterTest, OneOutlierIsRejectedAndARobotThatWasMovedIsFoundInTwoFrames) {
  PoseFilter fused = filter();
  for (int i = 0; i < 200; ++i) {
    fused.advance(interval(0.0, 0.0));
    if (i % 6 == 0) fused.camera(seen({}));
  }
  fused.camera(seen({.x_m = 0.3, .y_m = -0.2}));
  EXPECT_NEAR(fused.pose().x_m, 0.0, 1e-6);
  for (int i = 0; i < 6; ++i) fused.advance(interval(0.0, 0.0));
  // A second outlier at another pose does not confirm the first.
  fused.camera(seen({.x_m = -0.3, .y_m = 0.1}));
  EXPECT_NEAR(fused.pose().x_m, 0.0, 1e-6);
  for (int i = 0; i < 6; ++i) fused.advance(interval(0.0, 0.0));
  const Pose moved{.x_m = 0.02, .y_m = 0.04, .yaw_rad = 0.26};
  fused.camera(seen(moved));
  for (int i = 0; i < 6; ++i) fused.advance(interval(0.0, 0.0));
  fused.camera(seen(moved));
  EXPECT_NEAR(fused.pose().x_m, 0.02, 1e-3);
  EXPECT_NEAR(fused.pose().y_m, 0.04, 1e-3);
  EXPECT_NEAR(fused.pose().yaw_rad, 0.26, 5e-3);
  EXPECT_EQ(fused.figures(now_).recoveries, 1u);
  EXPECT_EQ(fused.recoveries(), 1u);
  EXPECT_NEAR(fused.figures(now_).slip_left, tracks_.slip_left, 1e-3);
}

// Worn tracks slide while they turn on the spot: the estimate follows, but nobody moved the robot.
TEST_F(PoseFilterTest, ASlideIsFollowedAndAPushIsARecovery) {
  for (const double shift_m : {0.006, 0.009, 0.012, 0.02, 0.04}) {
    for (const double direction_rad : {0.0, 0.8, 2.0, -1.6}) {
      PoseFilter fused = filter();
      Pose true_pose;
      for (int i = 0; i < 600; ++i) {
        if (i == 200) {
          true_pose.x_m = shift_m * std::cos(direction_rad);
          true_pose.y_m = shift_m * std::sin(direction_rad);
        }
        fused.advance(interval(0.0, 0.0));
        if (i % 6 == 0) fused.camera(seen(true_pose));
      }
      EXPECT_NEAR(fused.pose().x_m, true_pose.x_m, 1e-3) << shift_m;
      EXPECT_NEAR(fused.pose().y_m, true_pose.y_m, 1e-3) << shift_m;
      EXPECT_EQ(fused.recoveries(), shift_m < 0.015 ? 0u : 1u) << shift_m << " " << direction_rad;
    }
  }
}

TEST_F(PoseFilterTest, FalseDetectionsThatDisagreeAreNeverFollowed) {
  PoseFilter fused = filter();
  for (int i = 0; i < 600; ++i) {
    fused.advance(interval(0.0, 0.0));
    if (i % 6 != 0) continue;
    const double side = i % 12 == 0 ? 0.3 : -0.3;
    fused.camera(seen(i < 200 ? Pose{} : Pose{.x_m = side, .y_m = -side}));
  }
  EXPECT_NEAR(fused.pose().x_m, 0.0, 1e-3);
  EXPECT_NEAR(fused.pose().y_m, 0.0, 1e-3);
  EXPECT_EQ(fused.recoveries(), 0u);
}

TEST_F(PoseFilterTest, RestTeachesTheGyroBias) {
  PoseFilter fused = filter();
  for (int i = 0; i < 200; ++i) {
    FilterInput in = interval(0.0, 0.0);
    in.gyro_z_radps = 0.03;
    fused.advance(in);
    fused.standstill({0.03, 0.003});
  }
  EXPECT_NEAR(fused.figures(now_).gyro_bias_radps, 0.03, 1e-3);
  const double yaw = fused.pose().yaw_rad;
  for (int i = 0; i < 200; ++i) {
    FilterInput in = interval(0.0, 0.0);
    in.gyro_z_radps = 0.03;
    fused.advance(in);
  }
  EXPECT_NEAR(fused.pose().yaw_rad, yaw, 1e-3);
}

TEST_F(PoseFilterTest, GyroAgainstTracksShowsTheDifferenceOfTheSlipsButNotTheirMean) {
  PoseFilter fused = filter();
  for (int i = 0; i < 200; ++i) {
    fused.advance(interval(0.0, 0.0));
    fused.standstill({0.0, 0.003});
  }
  for (int i = 0; i < 4000; ++i) fused.advance(interval(0.1, 0.0, {0.18, 0.22}));
  const FilterFigures known = fused.figures(now_);
  EXPECT_NEAR(known.slip_right - known.slip_left, 0.04, 0.02);
  EXPECT_NEAR((known.slip_right + known.slip_left) / 2.0, 0.16, 0.01);
}

TEST_F(PoseFilterTest, TheCameraShowsTheMeanSlip) {
  PoseFilter fused = filter();
  double x_m = 0.0;
  for (int i = 0; i < 2000; ++i) {
    fused.advance(interval(0.1, 0.0, {0.20, 0.20}));
    x_m += 0.1 * kDt;
    if (i % 6 == 0) fused.camera(seen({.x_m = x_m}));
  }
  EXPECT_NEAR((fused.figures(now_).slip_left + fused.figures(now_).slip_right) / 2.0, 0.20, 0.015);
  EXPECT_NEAR(fused.pose().x_m, x_m, 1e-3);
}

TEST_F(PoseFilterTest, YawIsKnownOnTheBranchOfTheCourse) {
  PoseFilter fused = filter();
  for (int i = 0; i < 100; ++i) {
    fused.advance(interval(0.0, 0.0));
    if (i % 6 == 0) fused.camera(seen({.yaw_rad = -2.0 * kPi}));
  }
  EXPECT_NEAR(fused.pose().yaw_rad, 0.0, 1e-6);
  fused.begin({.yaw_rad = 2.0 * kPi}, now_);
  EXPECT_NEAR(fused.pose().yaw_rad, 2.0 * kPi, 1e-6);
}

TEST_F(PoseFilterTest, ABeginWithoutACameraTakesTheStartAndKeepsTheBias) {
  PoseFilter fused = filter();
  for (int i = 0; i < 200; ++i) {
    fused.advance(interval(0.0, 0.0));
    fused.standstill({0.02, 0.003});
  }
  fused.begin({.x_m = 0.4, .y_m = -0.2, .yaw_rad = 1.0}, now_);
  EXPECT_EQ(fused.pose().x_m, 0.4);
  EXPECT_EQ(fused.pose().yaw_rad, 1.0);
  EXPECT_NEAR(fused.figures(now_).gyro_bias_radps, 0.02, 1e-3);
}

TEST_F(PoseFilterTest, AfterAnInterruptionTheCameraOfBeforeKnowsTheStartNoBetter) {
  PoseFilter fused = filter();
  for (int i = 0; i < 60; ++i) {
    fused.advance(interval(0.0, 0.0));
    if (i % 6 == 0) fused.camera(seen({}));
  }
  ASSERT_GE(fused.figures(now_).camera_age_us, 0);
  ASSERT_LT(fused.pose_covariance().xx, square(0.005));
  fused.interrupt();
  EXPECT_GE(fused.pose_covariance().xx, square(noise_.disturbed_sd_m));
  EXPECT_GE(fused.pose_covariance().yaw_yaw, square(noise_.disturbed_sd_rad));
  EXPECT_EQ(fused.figures(now_).camera_age_us, -1);
  fused.begin({.x_m = 0.4, .y_m = -0.2, .yaw_rad = 1.0}, now_);
  EXPECT_EQ(fused.pose().x_m, 0.4);
  EXPECT_EQ(fused.pose().y_m, -0.2);
}

TEST_F(PoseFilterTest, TheCovarianceStaysSymmetricAndPositive) {
  PoseFilter fused = filter();
  for (int i = 0; i < 20000; ++i) {
    fused.advance(interval(0.1, std::sin(i * 0.01)));
    if (i % 6 == 0) fused.camera(seen(fused.pose()));
    if (i % 500 == 0) {
      const StateMatrix& p = fused.state().covariance;
      ASSERT_EQ(p, p.transpose());
      ASSERT_GT(Eigen::SelfAdjointEigenSolver<StateMatrix>(p).eigenvalues().minCoeff(), 0.0);
    }
  }
}

TEST_F(PoseFilterTest, AllocatesNothing) {
  PoseFilter fused = filter();
  const test::AllocCount count;
  for (int i = 0; i < 500; ++i) {
    fused.advance(interval(0.1, 0.2));
    fused.standstill({0.0, 0.003});
    CameraSample sample = seen(fused.pose());
    sample.measured_ns -= 60 * kNsPerMs;
    fused.camera(sample);
  }
  EXPECT_EQ(count.calls(), 0u);
}

// A robot is placed by hand: both ways must lead to the same estimates, with and without a camera.
TEST_F(PoseFilterTest, CarriedFromAPlaceIsAsIfARunBeganThere) {
  for (const bool camera : {false, true}) {
    PoseFilter begun = filter();
    const auto ahead_of = [](Pose pose) {
      pose.x_m += 0.002;
      return pose;
    };
    for (int i = 0; i < 400; ++i) {
      begun.advance(interval(0.1, 0.2));
      if (camera && i % 10 == 0) begun.camera(seen(ahead_of(begun.pose())));
    }
    const Pose place{.x_m = 3.0, .y_m = -1.0, .yaw_rad = 8.0};
    PoseFilter carried = filter();
    carried.resume(begun.carried_from(place, now_));
    begun.begin(place, now_);
    EXPECT_EQ(carried.state().mean, begun.state().mean) << camera;
    EXPECT_EQ(carried.state().covariance, begun.state().covariance) << camera;
    EXPECT_EQ(carried.pose().yaw_rad, begun.pose().yaw_rad) << camera;
    EXPECT_EQ(carried.figures(now_).camera_used, begun.figures(now_).camera_used) << camera;
    EXPECT_EQ(std::abs(begun.pose().x_m - place.x_m) < 1e-9, !camera)
        << "a camera that sees the robot knows better where it is";
    const FilterInput next = interval(0.1, 0.2);
    for (PoseFilter* fused : {&begun, &carried}) {
      fused->advance(next);
      fused->camera(seen(ahead_of(fused->pose())));
      EXPECT_GT(fused->figures(now_).nis, 0.0);
      EXPECT_EQ(fused->figures(now_).nis_mean, fused->figures(now_).nis) << "of one sample";
    }
  }
}

}  // namespace
}  // namespace tp100::estimation
