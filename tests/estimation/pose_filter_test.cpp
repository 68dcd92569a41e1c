// Odometry corrected by a camera whose samples arrive late.

#include "estimation/pose_filter.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include "core/arithmetic.h"
#include "interval.h"
#include "support/sequence.h"

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

// Over floor and slopes, at rest, with outliers, delivered up to half a second late.
TEST_F(PoseFilterTest, LateSamplesDoWhatTheyWouldHaveDoneInTime) {
  PoseFilter in_time = filter(), late = filter();
  test::Sequence any(3);
  std::deque<std::pair<HostNs, CameraSample>> under_way;
  for (int i = 0; i < 4000; ++i) {
    const bool rests = i % 900 > 800;
    FilterInput in = interval(rests ? 0.0 : 0.1, rests ? 0.0 : 0.5 * std::cos(i * 0.01));
    if (!rests) in.tracks.left_mps *= 1.02;
    if (i % 1000 > 900) in.ground.pitch_rad = -0.2;
    for (PoseFilter* each : {&in_time, &late}) {
      each->advance(in);
      if (rests) each->standstill({0.001 * (i % 3), 0.003});
    }
    if (i % 7 == 3) {
      Pose pose = in_time.pose();
      pose.x_m +=
          any.between(-0.003, 0.003) + (any.chance(0.1) ? 0.2 * any.between(-1.0, 1.0) : 0.0);
      pose.yaw_rad += any.between(-0.01, 0.01);
      CameraSample sample = seen(pose);
      sample.measured_ns -= any.below(3) * 2 * kNsPerMs;
      in_time.camera(sample);
      const HostNs due = now_ + any.below(i % 500 < 250 ? 3 : 100) * kPeriod;
      under_way.emplace_back(under_way.empty() ? due : std::max(due, under_way.back().first),
                             sample);
    }
    for (; !under_way.empty() && under_way.front().first <= now_; under_way.pop_front())
      late.camera(under_way.front().second);
    if (!under_way.empty()) continue;
    ASSERT_EQ(late.figures(now_).camera_used, in_time.figures(now_).camera_used) << i;
    ASSERT_EQ(late.figures(now_).camera_rejected, in_time.figures(now_).camera_rejected) << i;
    ASSERT_LT((in_time.state().mean - late.state().mean).norm(), 2e-4) << i;
    ASSERT_LT(std::abs(std::log(in_time.pose_covariance().xx / late.pose_covariance().xx)), 0.01);
  }
  EXPECT_GT(late.figures(now_).camera_used, 300u);
  EXPECT_GT(late.figures(now_).camera_rejected, 10u);
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
  for (int i = 0; i < 2; ++i) {
    fused.advance(interval(0.0, 0.0));
    fused.camera(seen({.x_m = 0.5}));
  }
  EXPECT_EQ(fused.recoveries(), 1u) << "two that agree show that it was moved";
  EXPECT_NEAR(fused.pose().x_m, 0.5, 1e-3);
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
  EXPECT_EQ(fused.figures(now_).camera_age_us, 8000);
  EXPECT_EQ(fused.camera_age_s(now_), 0.008);
  for (int i = 1; i <= 5; ++i) {
    CameraSample next = seen(fused.pose());
    next.measured_ns += i * kPeriod;
    fused.camera(next);
  }
  EXPECT_EQ(fused.figures(now_).camera_rejected, 1u) << "four can wait";
  for (int i = 1; i <= 4; ++i) {
    fused.advance(interval(0.0, 0.0));
    EXPECT_EQ(fused.figures(now_).camera_used, 1u + static_cast<std::uint32_t>(i));
  }
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

TEST_F(PoseFilterTest, YawIsKnownOnTheBranchOfTheCourse) {
  PoseFilter fused = filter();
  for (int i = 0; i < 100; ++i) {
    fused.advance(interval(0.0, 0.0));
    if (i % 6 == 0) fused.camera(seen({.yaw_rad = -2.0 * kPi}));
  }
  EXPECT_NEAR(fused.pose().yaw_rad, 0.0, 1e-6);
  fused.begin({.x_m = 1.0, .yaw_rad = 2.0 * kPi + 2.0}, now_ + 470 * kNsPerMs);
  EXPECT_NEAR(fused.pose().yaw_rad, 2.0 * kPi, 1e-6);
  EXPECT_EQ(fused.figures(now_).camera_used, 0u) << "of this run";
  fused.begin({.x_m = 1.0, .yaw_rad = 2.0 * kPi + 2.0}, now_ + 510 * kNsPerMs);
  EXPECT_EQ(fused.pose().yaw_rad, 2.0 * kPi + 2.0) << "the camera saw it too long ago";
  EXPECT_EQ(fused.pose().x_m, 1.0);
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
