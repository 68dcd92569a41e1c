// Golden traces of single steps: the motion model's functions, and what one camera sample does.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/arithmetic.h"
#include "estimation/motion.h"
#include "estimation/pose_filter.h"
#include "trace_rows.h"
#include "uneven_tracks.h"

namespace tp100::estimation {
namespace {

/// Each of them shows within one interval.
FilterParameters loud_noise() {
  FilterParameters noise;
  noise.gyro_sd_rad_rts = 0.011;
  noise.gyro_scale_sd = 0.03;
  noise.gyro_scale_s = 1.7;
  noise.bias_walk_radps_rts = 0.013;
  noise.along_sd_m_rtm = 0.024;
  noise.across_sd_m_rtm = 0.017;
  noise.obstacle_sd_m_rtm = 0.035;
  noise.turn_sd_m_rtrad = 0.015;
  noise.slip_s = 0.6;
  noise.residual_window_s = 0.7;
  noise.residual_sd_radps = 3e-3;
  noise.edge_m = 1.0 / 700.0;
  noise.disturbance_sd_m = 0.021;
  noise.disturbance_sd_rad = 0.037;
  return noise;
}

StateVector some_mean(Draws& draws) {
  StateVector mean;
  mean << draws.uniform(-2.0, 2.0), draws.uniform(-2.0, 2.0), draws.uniform(-7.0, 7.0),
      draws.uniform(-0.1, 0.1), draws.uniform(-0.1, 0.2), draws.uniform(-0.05, 0.05),
      draws.uniform(-0.1, 0.1), draws.uniform(-0.01, 0.01);
  return mean;
}

FilterState some_state(Draws& draws) {
  FilterState state;
  state.mean = some_mean(draws);
  StateMatrix root;
  for (Eigen::Index i = 0; i < kStates; ++i) {
    for (Eigen::Index k = 0; k < kStates; ++k) root(i, k) = draws.uniform(-0.01, 0.01);
  }
  state.covariance = root * root.transpose();
  return state;
}

/// Every kind of interval: forward, backward, arcs, spins, creeping; level, sloping, tipping.
Motion some_motion(Draws& draws, int i) {
  Motion motion;
  motion.dt_s = draws.uniform(0.004, 0.04);
  const double fastest = i % 5 == 0 ? 0.0022 : 0.25;
  motion.tracks = {draws.sign() * draws.uniform(0.7, 1.0) * fastest,
                   draws.sign() * draws.uniform(0.7, 1.0) * fastest};
  if (i % 3 == 1) motion.tracks.right_mps = motion.tracks.left_mps * draws.uniform(0.1, 1.1);
  motion.shape = model::turn_shape(motion.tracks.left_mps, motion.tracks.right_mps);
  motion.gyro = i % 2 == 0;
  motion.warming_degc = draws.uniform(-0.3, 0.3);
  motion.gyro_z_radps = draws.sign() * (i % 3 == 0 ? 0.04 : draws.uniform(0.2, 1.5));
  Ground& ground = motion.ground;
  ground.horizontal_fraction = draws.uniform(0.6, 1.0);
  ground.hold_slip = i % 4 == 3;
  ground.tilt_radps = i % 3 == 2 ? draws.uniform(0.0, 2.0) : 0.0;
  ground.slip = {draws.uniform(0.05, 0.3), draws.uniform(0.05, 0.3)};
  ground.pitch_rad = draws.uniform(-1.3, 1.3) * kRadPerDeg;
  ground.roll_rad = draws.uniform(-1.3, 1.3) * kRadPerDeg;
  motion.slip_walk_rtm = draws.uniform(0.0, 0.1);
  return motion;
}

TEST(MotionTrace, APredictionKeepsItsValues) {
  const MotionModel model(uneven_tracks(), loud_noise());
  Draws draws(3);
  TraceRows rows;
  for (int i = 0; i < 64; ++i) {
    FilterState state = some_state(draws);
    const Motion motion = some_motion(draws, i);
    model.predict(state, motion);
    add_mean(rows, "mean", state.mean);
    add_covariance(rows, "p", state.covariance);
    rows.end_row();
  }
  EXPECT_EQ(rows.difference("motion_predict.csv"), "");
}

TEST(MotionTrace, ATwistAndItsCovarianceKeepTheirValues) {
  const FilterParameters noise = loud_noise();
  const MotionModel model(uneven_tracks(), noise);
  Draws draws(5);
  TraceRows rows;
  for (int i = 0; i < 90; ++i) {
    const FilterState state = some_state(draws);
    const Motion motion = some_motion(draws, i);
    add(rows, "twist", model.twist(state.mean, motion));
    add(rows, "twist", model.twist_covariance(state, motion));
    const TrackSpeeds speeds = model.over_ground(state.mean, motion);
    rows.add("left", speeds.left_mps);
    rows.add("right", speeds.right_mps);
    const model::Slip slip = model.slip(state.mean, motion);
    rows.add("slip_left", slip.left);
    rows.add("slip_right", slip.right);
    const model::Turn turn = model.turn_of(motion);
    rows.add("wheelbase", turn.wheelbase_m);
    rows.add("x_icr", turn.x_icr_m);
    rows.add("kept", kept_slip(noise, motion));
    rows.add("shows", shows_slip(motion.ground));
    const ShiftVariance shift =
        shift_variance(noise, 0.03 * motion.tracks.left_mps, 0.01 * motion.gyro_z_radps, motion);
    rows.add("along", shift.along_m2);
    rows.add("across", shift.across_m2);
    rows.end_row();
  }
  EXPECT_EQ(rows.difference("motion_twist.csv"), "");
}

/// Tracks and gyro that disagree by up to twice the gate, and all that a measurement depends on.
void measure_something(Motion& motion, const MotionModel& model, const StateVector& mean,
                       Draws& draws, int i) {
  motion.rest = {mean[kBias] + draws.uniform(-0.02, 0.02), i % 3 == 0 ? 0.004 : 0.0};
  motion.disturbed = i % 7 == 3;
  motion.has_residual = i % 8 != 5;
  motion.turn_change = draws.uniform(-1.0, 1.0);
  Residual& residual = motion.residual;
  residual.left_radps = draws.uniform(-0.8, 0.8);
  residual.right_radps = i % 3 == 0 ? residual.left_radps : draws.uniform(-0.8, 0.8);
  residual.gyro_z_radps = 0.0;
  residual.gyro_z_radps = draws.uniform(-0.12, 0.12) - model.innovation_radps(mean, residual);
}

TEST(MotionTrace, MeasurementsKeepTheirValues) {
  const MotionModel model(uneven_tracks(), loud_noise());
  Draws draws(7);
  TraceRows rows;
  for (int i = 0; i < 100; ++i) {
    FilterState state = some_state(draws);
    Motion motion = some_motion(draws, i);
    measure_something(motion, model, state.mean, draws, i);
    rows.add("innovation", model.innovation_radps(state.mean, motion.residual));
    rows.add("ratio", model.turn_ratio(state.mean, motion.residual));
    rows.add("noise", model.residual_sd_radps(motion));
    model.measure(state, motion);
    add_mean(rows, "mean", state.mean);
    add_spread(rows, "sd", state.covariance, 3);
    rows.end_row();
  }
  EXPECT_EQ(rows.difference("motion_measure.csv"), "");
}

TEST(MotionTrace, AResidualIsTakenUpToItsGate) {
  const MotionModel model(uneven_tracks(), loud_noise());
  TraceRows rows;
  for (int i = 0; i < 60; ++i) {
    Draws draws(11);
    FilterState state = some_state(draws);
    Motion motion = some_motion(draws, 0);
    motion.has_residual = true;
    motion.residual = {.left_radps = 0.3, .right_radps = 0.5, .gyro_z_radps = 0.0};
    motion.residual.gyro_z_radps =
        0.002 * i * (i % 2 == 0 ? 1.0 : -1.0) - model.innovation_radps(state.mean, motion.residual);
    model.measure(state, motion);
    rows.add("bias", state.mean[kBias]);
    rows.end_row();
  }
  EXPECT_EQ(rows.difference("motion_gate.csv"), "");
}

TEST(MotionTrace, ThePriorAndWhatADisturbanceLeavesKeepTheirValues) {
  for (const bool loud : {false, true}) {
    const MotionModel model(uneven_tracks(), loud ? loud_noise() : FilterParameters{});
    TraceRows rows;
    FilterState state = model.prior();
    add_mean(rows, "mean", state.mean);
    add_spread(rows, "prior", state.covariance, kStates);
    Draws draws(13);
    state = some_state(draws);
    model.disturb(state);
    add_spread(rows, "disturbed", state.covariance, kStates);
    state = some_state(draws);
    Motion motion;
    motion.disturbed = true;
    model.measure(state, motion);
    add_spread(rows, "pushed", state.covariance, kStates);
    rows.end_row();
    EXPECT_EQ(rows.difference(loud ? "motion_prior_loud.csv" : "motion_prior.csv"), "");
  }
}

}  // namespace
}  // namespace tp100::estimation
