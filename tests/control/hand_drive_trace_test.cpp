#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "control/hand_drive.h"
#include "support/golden_trace.h"
#include "support/sequence.h"

namespace tp100::control {
namespace {

const course::Fence kRectangle{-1.0, 1.2, -0.5, 0.6};

course::Fence dented() {
  course::Fence fence{-1.0, 1.2, -0.5, 0.6};
  fence.corners = {{-1.0, -0.5}, {1.2, -0.4}, {1.1, 0.6}, {0.2, 0.5},
                   {0.0, 0.1},   {-0.2, 0.5}, {-0.9, 0.6}};
  return fence;
}

course::Fence with_areas() {
  course::Fence fence = kRectangle;
  fence.keep_out = {{{0.0, -0.1}, {0.3, -0.1}, {0.3, 0.1}, {0.0, 0.1}},
                    {{-0.8, 0.1}, {-0.4, 0.15}, {-0.6, 0.4}}};
  return fence;
}

TEST(HandDriveTrace, TheFenceLimitsTheSpeed) {
  test::GoldenTrace trace("control/speed_inside.csv",
                          {"x_m", "y_m", "yaw_rad", "wanted_mps", "rectangle_mps", "dented_mps",
                           "areas_mps", "default_mps", "narrow_mps"});
  test::Sequence any(31);
  course::Fence narrow = kRectangle;
  narrow.min_y_m = 0.1;
  narrow.max_y_m = 0.25;
  for (int i = 0; i < 500; ++i) {
    FenceMotion motion;
    // Mostly near an edge, and inside.
    const double from_edge_m = any.between(-0.02, 0.14), along_edge_m = any.between(-0.4, 0.5);
    switch (i % 6) {
      case 0:
        motion.pose.x_m = -1.0 + from_edge_m;
        motion.pose.y_m = along_edge_m;
        break;
      case 1:
        motion.pose.x_m = 1.2 - from_edge_m;
        motion.pose.y_m = along_edge_m;
        break;
      case 2:
        motion.pose.x_m = 2.0 * along_edge_m;
        motion.pose.y_m = -0.5 + from_edge_m;
        break;
      case 3:
        motion.pose.x_m = 2.0 * along_edge_m;
        motion.pose.y_m = 0.6 - from_edge_m;
        break;
      default:
        motion.pose.x_m = any.between(-0.9, 0.4);
        motion.pose.y_m = any.between(-0.2, 0.5);
    }
    if (i % 37 == 0) motion.pose.x_m *= 1.3;
    if (i % 41 == 0) {  // on an edge
      motion.pose.x_m = 0.3;
      motion.pose.y_m = any.between(-0.09, 0.09);
    } else if (i % 43 == 0) {
      motion.pose.x_m = any.between(0.01, 0.2);
      motion.pose.y_m = 0.1;
    }
    motion.pose.yaw_rad = any.between(-3.5, 3.5);
    const double wanted_mps = any.between(-0.4, 0.4);
    FenceMotion by_default;
    by_default.pose = motion.pose;
    motion.yaw_rate_radps = any.between(0.0, 1.2);
    motion.braking_mps2 = any.between(0.3, 1.0);
    motion.uncertainty_m = any.between(0.0, 0.015);
    trace.row(
        {motion.pose.x_m, motion.pose.y_m, motion.pose.yaw_rad, wanted_mps,
         speed_inside(wanted_mps, motion, kRectangle), speed_inside(wanted_mps, motion, dented()),
         speed_inside(wanted_mps, motion, with_areas()),
         speed_inside(wanted_mps, by_default, dented()), speed_inside(wanted_mps, motion, narrow)});
  }
  EXPECT_EQ(trace.difference(), "");
}

/// A robot that is driven about by a person with changing wishes, and lags.
void drive_about(test::GoldenTrace& trace, const std::optional<course::Fence>& fence,
                 const TrackLimits& limits, double side) {
  HandDrive drive(fence);
  HandDriveState state;
  state.limits = limits;
  state.pose = {.x_m = -0.25, .y_m = -0.1 * side, .yaw_rad = 0.3 * side};
  HostNs now = 0;
  Parameters parameters;
  double speed_mps = 0.0;
  for (int step = 0; step < 8400; ++step) {
    const double dt_s = 0.0048 + 0.0006 * std::sin(0.1 * step);
    now += from_s(dt_s);
    const double t = step * 0.005;
    VelocityInput input;
    input.at_ns = now - (step % 17 == 16 ? 20 : 3) * kNsPerMs;
    input.speed_mps =
        side * 0.25 * std::sin(0.9 * t + 0.6) * (std::fmod(t, 7.0) < 5.0 ? 1.0 : 0.04);
    input.yaw_rate_radps =
        std::fmod(t + 2.0, 5.0) < 1.5 ? 0.0 : side * 1.4 * std::sin(1.7 * t + 0.4);
    if (std::fmod(t, 11.0) > 9.0) input.yaw_rate_radps *= 0.04;
    // Now and then nobody drives; once for long.
    const bool silent = std::fmod(t, 4.0) > 3.7 || (t > 30.0 && t < 32.5);
    if (!silent) drive.take(input, now);
    if (step % 900 == 450) drive.take({now + kNsPerS, 0.1, side * 0.3}, now);
    if (step == 7000) {
      drive.restart(now);
      state.limits.max_track_mps *= 0.6;
      state.braking_mps2 = 0.4;
    }
    if (step == 1000) state.position_sd_m = 0.004;
    if (step == 5000) state.pose.x_m = -0.35;
    const HandCommand command = drive.update(state, parameters, now, dt_s);
    // The robot follows with a lag, now and then it is blocked.
    const bool blocked = std::fmod(t, 9.0) > 8.2;
    const double rate =
        command.yaw_rate_radps + limits.yaw_kp * (command.desired_yaw_rad - state.pose.yaw_rad);
    state.measured_yaw_rate_radps +=
        ((blocked ? 0.0 : rate) - state.measured_yaw_rate_radps) * dt_s / 0.12;
    speed_mps += ((blocked ? 0.0 : command.speed_mps) - speed_mps) * dt_s / 0.1;
    if (step % 28 == 0) {
      trace.row({t, command.desired_yaw_rad, command.desired_yaw_rad - state.pose.yaw_rad,
                 command.yaw_rate_radps, command.speed_mps, command.at_fence ? 1.0 : 0.0,
                 drive.silent(now) ? 1.0 : 0.0, state.measured_yaw_rate_radps, state.pose.x_m,
                 state.pose.y_m});
    }
    state.pose.yaw_rad += state.measured_yaw_rate_radps * dt_s;
    state.pose.x_m += speed_mps * std::cos(state.pose.yaw_rad) * dt_s;
    state.pose.y_m += speed_mps * std::sin(state.pose.yaw_rad) * dt_s;
  }
}

test::GoldenTrace hand_drive_trace(const char* file) {
  return {file,
          {"t", "desired_yaw_rad", "ahead_rad", "yaw_rate_radps", "speed_mps", "at_fence", "silent",
           "measured_yaw_rate_radps", "x_m", "y_m"}};
}

TEST(HandDriveTrace, APersonDrivesAboutInsideAFence) {
  test::GoldenTrace trace = hand_drive_trace("control/hand_drive_fence.csv");
  const course::Fence room{-0.5, 0.1, -0.35, 0.1, {}, {{{-0.3, -0.3}, {-0.1, -0.3}, {-0.2, -0.2}}}};
  drive_about(trace, room, {.slip_left = 0.1, .slip_right = 0.05}, 1.0);
  EXPECT_EQ(trace.difference(), "");
}

TEST(HandDriveTrace, APersonDrivesAboutWithoutAFence) {
  test::GoldenTrace trace = hand_drive_trace("control/hand_drive_free.csv");
  drive_about(trace, std::nullopt, {.max_track_mps = 0.17, .yaw_kp = 3.3, .max_yaw_radps = 1.0},
              -1.0);
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::control
