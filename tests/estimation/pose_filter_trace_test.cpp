// Golden traces of the pose filter: camera samples in time, late, early, out of order and wrong.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/arithmetic.h"
#include "core/step_record.h"
#include "estimation/pose_filter.h"
#include "trace_rows.h"
#include "uneven_tracks.h"

namespace tp100::estimation {
namespace {

constexpr HostNs kFollowedNs = 7 * kNsPerMs + 123;
constexpr double kFollowedS = 0.007000123;
constexpr CameraPlace kLens{0.3, 0.2};
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// A robot that drives in bows over floor and ramp, and the filter that follows it.
class Followed {
 public:
  explicit Followed(const FilterParameters& noise) : filter_(tracks_, noise, {}, kLens) {}

  void step() {
    ++count_;
    const double t_s = kFollowedS * count_;
    const bool rests = count_ % 700 > 600;
    const double speed_mps = rests ? 0.0 : 0.12 * std::sin(0.41 * t_s) + 0.05;
    rate_radps_ = rests ? 0.0 : 0.5 * std::sin(0.9 * t_s);
    FilterInput in{.end_ns = now_ns() + (count_ % 37 == 5 ? 3 * kNsPerMs : 0), .dt_s = kFollowedS};
    const double half = 0.5 * 0.28 * rate_radps_;
    in.tracks = {(speed_mps - half) / 0.87, (speed_mps + half) / 0.9};
    in.gyro = count_ % 400 < 380;
    in.gyro_z_radps = rate_radps_ + 0.02 + (count_ % 900 > 870 ? 0.8 : 0.0);
    in.warming_degc = 0.002;
    ground_ = Ground{.slip = {0.16, 0.12}};
    if (count_ % 500 > 400)
      ground_ = {.horizontal_fraction = 0.97,
                 .z_m = 0.05,
                 .roll_rad = 0.03,
                 .pitch_rad = -0.2 + 0.001 * (count_ % 50),
                 .slip = {0.2, 0.22},
                 .hold_slip = count_ % 500 > 450};
    in.ground = ground_;
    const double turn = rate_radps_ * kFollowedS;
    x_m += speed_mps * kFollowedS * std::cos(yaw_rad + turn / 2.0);
    y_m += speed_mps * kFollowedS * std::sin(yaw_rad + turn / 2.0);
    yaw_rad += turn;
    filter_.advance(in);
    if (rests && count_ % 3 == 0) filter_.standstill({0.021, 0.004});
  }
  /// What a camera sees now.
  CameraSample seen() const {
    CameraParameters camera;
    const Eigen::Vector3d marker = expected_marker({x_m, y_m, yaw_rad}, ground_, camera, kLens);
    return {.x_m = marker[0] + 0.0013 * std::sin(1.7 * count_),
            .y_m = marker[1] + 0.0011 * std::sin(2.3 * count_),
            .yaw_rad = wrap_angle(marker[2] + 0.006 * std::sin(2.9 * count_)),
            .measured_ns = now_ns() - 2 * kNsPerMs};
  }
  HostNs now_ns() const { return kNsPerS + count_ * kFollowedNs; }
  int count() const { return count_; }
  PoseFilter& filter() { return filter_; }

  double x_m = 0.4, y_m = 0.3, yaw_rad = 2.6;

 private:
  model::TrackParameters tracks_ = uneven_tracks();
  PoseFilter filter_;
  int count_ = 0;
  double rate_radps_ = 0.0;
  Ground ground_{};
};

void add(TraceRows& rows, const FilterFigures& figures) {
  rows.add("slip_left", figures.slip_left);
  rows.add("slip_right", figures.slip_right);
  rows.add("bias", figures.gyro_bias_radps);
  rows.add("nis", figures.nis);
  rows.add("nis_mean", figures.nis_mean);
  rows.add("nis_count", figures.nis_count);
  rows.add("age_us", static_cast<double>(figures.camera_age_us));
  rows.add("used", figures.camera_used);
  rows.add("rejected", figures.camera_rejected);
  rows.add("recoveries", figures.recoveries);
}

void add(TraceRows& rows, const Followed& followed, const PoseFilter& filter) {
  const Pose pose = filter.pose();
  rows.add("x", pose.x_m);
  rows.add("y", pose.y_m);
  rows.add("yaw", pose.yaw_rad);
  add(rows, "twist", filter.twist());
  add(rows, "pose", filter.pose_covariance());
  add(rows, filter.figures(followed.now_ns()));
  rows.add("age_s", filter.camera_age_s(followed.now_ns()));
  rows.add("recovered", filter.recoveries());
  add_mean(rows, "mean", filter.state().mean);
  add_spread(rows, "sd", filter.state().covariance);
  rows.end_row();
}

TEST(PoseFilterTrace, ADriveUnderALateCameraKeepsItsValues) {
  Followed followed(FilterParameters{});
  PoseFilter& filter = followed.filter();
  filter.begin({.x_m = 0.4, .y_m = 0.3, .yaw_rad = 2.6}, 0);
  TraceRows rows;
  std::array<CameraSample, 300> images{};
  std::size_t taken = 0, sent = 0;
  while (followed.count() < 2700) {
    followed.step();
    const int count = followed.count();
    if (count == 1000) followed.x_m += 0.2;  // it is moved
    if (count == 1900) followed.yaw_rad -= 0.3;
    if (count % 9 == 4) images[taken++ % images.size()] = followed.seen();
    // The way takes 4 to 24 steps.
    const std::size_t in_time =
        static_cast<std::size_t>(std::max(0, count - 4 - count / 7 % 20)) / 9;
    if (sent < std::min(in_time, taken)) {
      CameraSample image = images[sent++ % images.size()];
      if (sent % 31 == 20) image.x_m += 0.06;
      if (sent % 47 == 30) image.yaw_rad += 0.5;
      filter.camera(image);
    }
    if (count % 36 == 0) add(rows, followed, filter);
  }
  EXPECT_EQ(rows.difference("pose_filter.csv"), "");
}

TEST(PoseFilterTrace, SamplesInAWrongOrderAndWrongOnesKeepTheirEffect) {
  FilterParameters noise;
  noise.residual_window_s = 0.2;
  Followed followed(noise);
  PoseFilter& filter = followed.filter();
  filter.begin({.x_m = 0.4, .y_m = 0.3, .yaw_rad = 2.6}, 0);
  TraceRows rows;
  const auto step = [&](int times) {
    for (int i = 0; i < times; ++i) followed.step();
    add(rows, followed, filter);
  };
  const auto show = [&](const CameraSample& seen) {
    filter.camera(seen);
    add(rows, followed, filter);
  };
  show(followed.seen());
  step(10);
  step(30);
  show(followed.seen());
  show(followed.seen());  // again
  const CameraSample early = followed.seen();
  step(3);
  CameraSample seen = followed.seen();
  for (double CameraSample::*value :
       {&CameraSample::x_m, &CameraSample::y_m, &CameraSample::yaw_rad}) {
    CameraSample wrong = seen;
    wrong.*value = kNoNumber;
    show(wrong);
  }
  show(seen);
  show(early);
  // Five samples from the future, of which four can wait.
  for (int i = 1; i <= 5; ++i) {
    seen.measured_ns = followed.now_ns() + i * kFollowedNs - kNsPerMs;
    seen.x_m += 0.0005;
    show(seen);
  }
  for (int i = 0; i < 7; ++i) step(1);
  // Older and older ones, until the filter no longer remembers their time; each from within an
  // interval and from its end.
  for (int i = 0; i < 12; ++i) {
    step(3);
    // Two from within one interval.
    seen = followed.seen();
    seen.measured_ns -= 2 * kNsPerMs;
    show(seen);
    show(followed.seen());
    for (int k = 0; k < 200; ++k) {
      followed.step();
      if (k == 45 - i) seen = followed.seen();
    }
    if (i % 3 == 1) seen.measured_ns += 2 * kNsPerMs;
    show(seen);
    step(2);
  }
  EXPECT_EQ(rows.difference("pose_filter_order.csv"), "");
}

void add(TraceRows& rows, const CarriedFilter& carried) {
  rows.add("x", carried.estimate.mean[kX]);
  rows.add("yaw", carried.estimate.mean[kYaw]);
  rows.add("xx", carried.estimate.covariance[0]);
  rows.add("branch", carried.branch_rad);
  rows.add("camera_s", to_s(carried.camera_ns));
  rows.add("last_seen_s", to_s(carried.last_seen_ns));
  rows.add("known", carried.camera_known);
  rows.add("nis", carried.nis);
  rows.add("nis_sum", carried.nis_sum);
  rows.add("nis_count", carried.nis_count);
  rows.add("used", carried.camera_used);
  rows.add("rejected", carried.camera_rejected);
  rows.add("recoveries", carried.recoveries);
  rows.end_row();
}

/// A filter after half a second under a camera, whose run began two turns aside, and a recovery.
Followed watched() {
  Followed followed{FilterParameters{}};
  PoseFilter& filter = followed.filter();
  const auto drive = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      followed.step();
      if (followed.count() % 8 == 0) filter.camera(followed.seen());
    }
  };
  drive(60);
  followed.y_m += 0.15;
  drive(30);
  return followed;
}

TEST(PoseFilterTrace, BeginningsAndResumedFiltersKeepTheirValues) {
  TraceRows rows, states;
  for (int i = -1; i < 13; ++i) {
    Followed followed = watched();
    PoseFilter& filter = followed.filter();
    const Pose start{.x_m = 0.2, .y_m = -0.1, .yaw_rad = 1.3 * i - 4.0};
    // The camera counts for half a second.
    const HostNs now = followed.now_ns() + 60 * i * kNsPerMs;
    if (i == 12) filter.interrupt();
    add(rows, filter.carried());
    add(rows, filter.carried_from(start, now));
    add(states, followed, filter);
    filter.begin(start, now);
    add(rows, filter.carried());
    add(states, followed, filter);
    CameraSample future = followed.seen();
    future.measured_ns += 5 * kNsPerMs;
    filter.camera(future);
    if (i % 3 == 0) filter.interrupt();
    const CarriedFilter carried = filter.carried();
    if (i % 3 == 1) {
      filter = PoseFilter(uneven_tracks(), FilterParameters{}, {}, kLens);
      filter.resume(carried);
    }
    add(states, followed, filter);
    filter.standstill({0.03, 0.001});
    for (int k = 0; k < 3; ++k) followed.step();
    filter.camera(followed.seen());
    add(rows, filter.carried());
    add(states, followed, filter);
    // Long after the last image.
    add(rows, filter.carried_from(start, now + 9 * kNsPerS));
    filter.begin(start, now + 9 * kNsPerS);
    add(states, followed, filter);
  }
  EXPECT_EQ(rows.difference("pose_filter_carried.csv"), "");
  EXPECT_EQ(states.difference("pose_filter_begin.csv"), "");
}

TEST(PoseFilterTrace, AResumedFilterRemembersNoImageThatFoundTheRobotMoved) {
  TraceRows rows;
  for (const bool resumed : {false, true}) {
    Followed followed = watched();
    PoseFilter& filter = followed.filter();
    followed.x_m += 0.3;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 5; ++k) followed.step();
      filter.camera(followed.seen());
      add(rows, filter.carried());
      if (resumed && i == 0) filter.resume(filter.carried());
    }
  }
  EXPECT_EQ(rows.difference("pose_filter_resumed.csv"), "");
}

}  // namespace
}  // namespace tp100::estimation
