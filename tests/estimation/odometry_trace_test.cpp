// Golden traces of odometry, of the walk of the slip difference, and of the covariance of the
// model's pose over the same drive.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/arithmetic.h"
#include "core/step_record.h"
#include "estimation/model_covariance.h"
#include "estimation/odometry.h"
#include "model/track_model.h"
#include "trace_rows.h"
#include "uneven_tracks.h"

namespace tp100::estimation {
namespace {

/// Windows of 0.3 s, so that a short drive has many.
FilterParameters short_windows() {
  FilterParameters noise;
  noise.residual_window_s = 0.3;
  noise.residual_sd_radps = 1e-3;
  noise.edge_m = 1.0 / 3000.0;
  return noise;
}

/// A drive whose speed and turn change from window to window, by much and by little.
class Drive {
 public:
  static constexpr double kStepS = 0.0101;
  /// `unevenness`: of the floor, as what it does to the yaw rate [rad/s].
  explicit Drive(std::uint32_t seed = 23, double unevenness = 0.01)
      : draws_(seed), unevenness_(unevenness) {}

  /// The next interval.
  FilterInput next() {
    if (step_ % 30 == 0) change();
    FilterInput in;
    in.dt_s = step_ % 11 == 7 ? 3.0 * kStepS : kStepS;
    end_ns_ += from_s(in.dt_s);
    // The relation of the clocks jumps now and then.
    in.end_ns = end_ns_ - (step_ % 97 == 50 ? 40 * kNsPerMs : 0);
    const double half = 0.5 * 0.29 * rate_radps_;
    in.tracks = {(speed_mps_ - half) / 0.84, (speed_mps_ + half) / 0.89};
    in.gyro_z_radps =
        rate_radps_ + 0.03 + pushed_radps_ + 0.2 * unevenness_ * std::sin(0.7 * step_);
    in.gyro = gyro_;
    in.warming_degc = step_ % 61 == 33 ? draws_.uniform(0.7, 1.3) * draws_.sign() : 0.003;
    in.ground = ground_;
    ++step_;
    return in;
  }
  int step() const { return step_; }

 private:
  void change() {
    ++window_;
    const int kind = window_ % 17;
    speed_mps_ =
        kind == 16 ? draws_.uniform(-0.012, 0.012) : speed_mps_ + draws_.uniform(-0.05, 0.05);
    if (std::abs(speed_mps_) > 0.2) speed_mps_ *= 0.5;
    if (window_ == 40) speed_mps_ = -0.12;
    if (kind != 16 && window_ % 9 == 0) speed_mps_ = std::copysign(0.12, speed_mps_);
    rate_radps_ =
        kind % 4 == 3 ? draws_.uniform(-0.7, 0.7) : rate_radps_ + draws_.uniform(-0.12, 0.12);
    pushed_radps_ = kind == 5 ? draws_.sign() * draws_.uniform(0.3, 0.7)
                              : draws_.uniform(-1.0, 1.0) * unevenness_;
    gyro_ = kind != 9;
    ground_ = {.slip = {0.16, 0.11}};
    if (kind == 11 || kind == 12) {
      ground_ = {.horizontal_fraction = 0.97,
                 .z_m = 0.03,
                 .roll_rad = 0.04 * draws_.sign(),
                 .pitch_rad = 0.25 * draws_.sign(),
                 .slip = {0.2, 0.24},
                 .hold_slip = kind == 12};
    }
  }

  Draws draws_;
  double unevenness_;
  int step_ = 0, window_ = 0;
  HostNs end_ns_ = kNsPerS;
  double speed_mps_ = 0.1, rate_radps_ = 0.05, pushed_radps_ = 0.0;
  bool gyro_ = true;
  Ground ground_{};
};

void add(TraceRows& rows, const Motion& motion) {
  rows.add("end", to_s(motion.end_ns));
  rows.add("dt", motion.dt_s);
  rows.add("warming", motion.warming_degc);
  rows.add("tilt", motion.ground.tilt_radps);
  rows.add("curved", motion.shape.curved);
  rows.add("wide", motion.shape.wide);
  rows.add("has_residual", motion.has_residual);
  rows.add("left", motion.residual.left_radps);
  rows.add("right", motion.residual.right_radps);
  rows.add("gyro", motion.residual.gyro_z_radps);
  rows.add("walk", std::log(motion.slip_walk_rtm));
  rows.add("turn_change", motion.turn_change);
  rows.add("disturbed", motion.disturbed);
  rows.add("rest", motion.rest.radps);
}

void add(TraceRows& rows, const Odometry& odometry) {
  add_mean(rows, "mean", odometry.state().mean);
  add_spread(rows, "sd", odometry.state().covariance);
  add(rows, odometry.motion());
  add(rows, "twist", odometry.twist());
  rows.add("z", odometry.pose().z_m);
  rows.add("roll", odometry.pose().roll_rad);
  rows.add("pitch", odometry.pose().pitch_rad);
  rows.add("slip_left", odometry.slip().left);
  rows.add("slip_right", odometry.slip().right);
  rows.add("pose_yyaw", odometry.pose_covariance().y_yaw);
  rows.add("twist_yawyaw", odometry.twist_covariance().yaw_yaw);
  rows.end_row();
}

TEST(OdometryTrace, ADriveOfManyWindowsKeepsItsValues) {
  Odometry odometry(uneven_tracks(), short_windows());
  odometry.begin({.x_m = 0.3, .y_m = -0.2, .yaw_rad = 0.7});
  Drive drive;
  TraceRows rows;
  while (drive.step() < 3600) {
    const Motion motion = odometry.advance(drive.next());
    if (drive.step() == 20) odometry.standstill({0.031, 0.002});
    if ((motion.has_residual || motion.disturbed) && drive.step() % 5 == 0)
      odometry.standstill({0.033, 0.02});
    if (motion.has_residual || (motion.disturbed && drive.step() % 3 == 0) ||
        drive.step() % 211 == 0)
      add(rows, odometry);
  }
  EXPECT_EQ(rows.difference("odometry.csv"), "");
}

TEST(OdometryTrace, FloorsFromEvenToRoughKeepTheirEffect) {
  TraceRows rows;
  for (const double unevenness : {1e-5, 3e-4, 3e-3, 2e-2}) {
    model::TrackParameters tracks;
    tracks.wheelbase_m = 0.29;
    Odometry odometry(tracks, short_windows());
    Drive drive(41, unevenness);
    while (drive.step() < 2400) {
      const Motion motion = odometry.advance(drive.next());
      if (!motion.has_residual && motion.ground.tilt_radps == 0.0) continue;
      rows.add("walk", std::log(motion.slip_walk_rtm));
      rows.add("change", motion.turn_change);
      rows.add("tilt", motion.ground.tilt_radps);
      rows.add("bias", odometry.state().mean[kBias]);
      for (const auto of : {kX, kBias, kSlipDifference, kTurnGain, kBiasPerDegc})
        rows.add("sd" + std::to_string(of), std::log(odometry.state().covariance(of, of)));
      rows.end_row();
    }
  }
  EXPECT_EQ(rows.difference("odometry_floors.csv"), "");
}

void add(TraceRows& rows, const CarriedEstimate& carried) {
  for (std::size_t i = 0; i < carried.mean.size(); ++i)
    rows.add("mean" + std::to_string(i), carried.mean[i]);
  for (std::size_t i = 0; i < carried.covariance.size(); ++i)
    rows.add("p" + std::to_string(i), carried.covariance[i]);
  for (std::size_t i = 0; i < carried.slip_walk.size(); ++i)
    rows.add("walk" + std::to_string(i), carried.slip_walk[i]);
  rows.end_row();
}

TEST(OdometryTrace, WhatIsCarriedAndWhatInterruptsKeepTheirValues) {
  Drive drive;
  TraceRows rows, states;
  Odometry odometry(uneven_tracks(), short_windows());
  add(states, odometry);
  const auto run = [&](int steps) {
    for (int i = 0; i < steps; ++i) odometry.advance(drive.next());
    add(rows, odometry.carried());
    add(states, odometry);
  };
  run(100);
  odometry.standstill({0.031, 0.002});
  add(states, odometry);
  run(1015);
  odometry.begin({.x_m = 0.4, .y_m = 0.1, .yaw_rad = -0.3});
  add(rows, odometry.carried());
  run(20);  // the window ends later than without a begin
  run(50);
  run(110);
  odometry.interrupt();
  add(rows, odometry.carried());
  run(20);
  run(100);
  add(rows, odometry.carried_from({.x_m = -0.4, .y_m = 0.3, .yaw_rad = 5.0}));
  const CarriedEstimate carried = odometry.carried();
  odometry = Odometry(uneven_tracks(), short_windows());
  odometry.resume(carried);
  add(states, odometry);
  run(1);
  run(40);
  run(200);
  odometry.resume(carried);
  add(states, odometry);
  run(30);
  FilterState corrected = odometry.state();
  corrected.mean[kYaw] += 0.2;
  corrected.mean[kBias] -= 0.1;
  odometry.correct(corrected);
  add(states, odometry);
  EXPECT_EQ(rows.difference("odometry_carried.csv"), "");
  EXPECT_EQ(states.difference("odometry_interrupted.csv"), "");
}

TEST(OdometryTrace, TheWalkOfTheSlipDifferenceKeepsItsLikelihoods) {
  SlipWalk walk;
  Draws draws(29);
  TraceRows rows;
  for (int i = 0; i < 60; ++i) {
    const double change = draws.uniform(-1.0, 1.0) * (i < 30 ? 0.002 : 0.03);
    walk.add(change, draws.uniform(1e-4, 3e-3), draws.uniform(0.1, 0.8));
    if (i == 45) walk = SlipWalk(walk.log_likelihoods());
    rows.add("step", walk.step_rtm());
    for (std::size_t k = 0; k < SlipWalk::kCandidates; ++k)
      rows.add("log" + std::to_string(k), walk.log_likelihoods()[k]);
    rows.end_row();
  }
  EXPECT_EQ(rows.difference("slip_walk.csv"), "");
}

void add(TraceRows& rows, const CarriedModelCovariance& carried) {
  for (std::size_t i = 0; i < carried.errors.size(); ++i) {
    const std::size_t row = i / 5, column = i % 5;
    if (row > column) continue;
    const double sds = std::sqrt(carried.errors[6 * row] * carried.errors[6 * column]);
    rows.add("p" + std::to_string(row) + std::to_string(column),
             row == column ? std::log(sds) : carried.errors[i] / sds);
  }
  rows.add("density", carried.slip_density_m);
  rows.add("seen", carried.seen_m);
}

TEST(ModelCovarianceTrace, ADriveKeepsItsValues) {
  FilterParameters noise = short_windows();
  Odometry odometry(uneven_tracks(), noise);
  ModelCovariance covariance(uneven_tracks(), noise);
  model::TrackModel model(uneven_tracks(), model::Mode::kExtended);
  Drive drive;
  TraceRows rows;
  while (drive.step() < 3600) {
    const FilterInput in = drive.next();
    const Pose before = model.pose();
    model.advance(in.tracks.left_mps, in.tracks.right_mps, in.dt_s);
    const Motion motion = odometry.advance(in);
    covariance.advance(before, model.pose(), motion, odometry.state().mean[kBias]);
    if (drive.step() % 45 == 0) {
      add(rows, covariance.carried());
      add(rows, "pose", covariance.pose());
      rows.end_row();
    }
    if (drive.step() % 45 == 20) {
      if (drive.step() / 45 % 9 == 4) covariance.interrupt();
      if (drive.step() / 45 % 9 == 7) covariance.begin();
      if (drive.step() / 45 % 9 == 8) covariance.resume(covariance.carried());
    }
  }
  add(rows, covariance.carried_from_start());
  add(rows, "pose", covariance.pose());
  rows.end_row();
  EXPECT_EQ(rows.difference("model_covariance.csv"), "");
}

/// A floor that becomes rougher, whose pieces become longer and take longer.
TEST(ModelCovarianceTrace, PiecesOfAFloorKeepWhatTheyShow) {
  TraceRows rows;
  for (const double edge_m : {0.0, 1.0 / 9000.0, 1.0 / 1500.0}) {
    FilterParameters noise;
    noise.edge_m = edge_m;
    FloorSlip slip(noise);
    Draws draws(31);
    for (int i = 0; i < 1300; ++i) {
      const double distance_m =
          i % 40 < 3 ? 0.0 : draws.uniform(0.002, 0.006) * (i % 50 > 44 ? 0.05 : 1.0);
      const double turn_rad = draws.uniform(-0.02, 0.03);
      slip.add(0.0403 + (i % 80 > 70 ? 0.0013 * i : 0.0), distance_m, turn_rad,
               turn_rad + 2e-5 * i * draws.uniform(-1.0, 1.2), 0.27);
      if (i % 111 == 100) slip.skip();
      if (i % 13 != 0) continue;
      rows.add("density", slip.slip_density_m());
      rows.add("seen", slip.seen_m());
      rows.end_row();
    }
  }
  // Longer and longer pauses within a piece.
  for (int i = 0; i < 40; ++i) {
    FloorSlip slip{FilterParameters{}};
    slip.add(0.1, 0.02, 0.003, 0.001, 0.27);
    slip.add(0.23 * i, 0.001, 0.0, 0.0, 0.27);
    slip.add(0.1, 0.035, 0.0, 0.002, 0.27);
    rows.add("density", slip.slip_density_m());
    rows.add("seen", slip.seen_m());
    rows.end_row();
  }
  EXPECT_EQ(rows.difference("floor_slip.csv"), "");
}

}  // namespace
}  // namespace tp100::estimation
