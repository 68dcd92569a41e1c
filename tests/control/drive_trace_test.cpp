// Golden traces of what a drive is made of: steering laws, track limits, progress, corners, and
// driving by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "control/corner.h"
#include "control/hand_drive.h"
#include "control/law.h"
#include "control/progress.h"
#include "control/track_limits.h"
#include "lagging_robot.h"
#include "support/golden_trace.h"
#include "support/sequence.h"

namespace tp100::control {
namespace {

TEST(DriveTrace, EachLawSteersByAllErrors) {
  std::vector<std::string> columns = {"i", "speed_mps"};
  for (const auto& [law, name] : kLawNames) {
    for (const char* value : {" look_ahead_m", " yaw_rad", " yaw_rate_radps", " retuned_yaw_rad"})
      columns.push_back(name + std::string(value));
  }
  test::GoldenTrace trace("control/laws.csv", columns);
  const TrackLimits limits{.yaw_kp = 3.4};
  std::vector<std::unique_ptr<Law>> laws;
  for (const auto& [name_of_law, name] : kLawNames) {
    Parameters parameters;
    parameters.law = name_of_law;
    laws.push_back(make_law(parameters, limits));
  }
  test::Sequence any(3);
  for (int i = 0; i < 300; ++i) {
    const double size = i % 4 == 0 ? 3.0 : 0.5;
    PathErrors errors;
    errors.cross_track_m = size * any.between(-0.05, 0.05);
    errors.heading_rad = size * any.between(-0.6, 0.6);
    errors.yaw_rate_radps = any.between(-0.5, 0.5);
    errors.speed_mps = any.between(0.0, i % 3 == 0 ? 1.2 : 0.25);
    errors.curvature_1pm = any.between(-4.0, 4.0);
    errors.crab_rad = any.between(-0.1, 0.1);
    errors.ahead.along_m = any.between(i % 5 == 0 ? -0.1 : 0.02, 0.15);
    errors.ahead.left_m = any.between(-0.04, 0.04);
    errors.ahead.yaw_rad = any.between(-0.3, 0.3);
    errors.ahead.curvature_1pm = any.between(-4.0, 4.0);
    std::vector<double> row = {static_cast<double>(i), errors.speed_mps};
    for (const auto& law : laws) {
      law->retune(Parameters{});
      const LawOutput steering = law->steer(errors);
      row.push_back(law->look_ahead_m(errors.speed_mps));
      row.push_back(steering.yaw_rad);
      row.push_back(steering.yaw_rate_radps);
      Parameters changed;
      changed.max_approach_rad = 0.3;
      changed.cross_track_gain_1ps = 2.2;
      changed.pursuit_min_m = 0.07;
      law->retune(changed);
      row.push_back(law->steer(errors).yaw_rad);
    }
    trace.row(row);
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(DriveTrace, TheRegulatorsGainsFollowSpeedAndWeights) {
  test::GoldenTrace trace("control/lqr_gains.csv",
                          {"speed_mps", "e", "psi", "w", "e_slow", "psi_slow", "w_slow", "e_soft",
                           "psi_soft", "w_soft"});
  Parameters slow, soft;
  slow.preview_s = 0.004;
  soft.preview_s = 0.11;
  soft.lqr_cross_track_m = 0.03;
  soft.lqr_heading_rad = 0.15;
  soft.lqr_turn_radps = 0.4;
  const Lqr regulators[] = {{Parameters{}, {}}, {slow, {}}, {soft, {}}};
  for (double speed_mps = 0.0037; speed_mps < 1.2; speed_mps *= 1.09) {
    std::vector<double> row = {speed_mps};
    for (const Lqr& regulator : regulators) {
      const Lqr::Gains gains = regulator.gains(speed_mps);
      row.insert(row.end(), {gains.cross_track, gains.heading, gains.rate});
    }
    trace.row(row);
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(DriveTrace, TracksGetWhatTheirLimitsLeave) {
  test::GoldenTrace trace("control/track_limits.csv",
                          {"i", "asked", "within", "along", "left", "right", "default_asked",
                           "default_within", "default_along", "default_left", "default_right"});
  test::Sequence any(5);
  for (int i = 0; i < 400; ++i) {
    TrackLimits limits;
    limits.wheelbase_m = any.between(0.2, 0.4);
    limits.slip_left = any.between(0.0, 0.3);
    limits.slip_right = any.between(0.0, 0.3);
    limits.max_track_mps = any.between(0.1, 0.3);
    limits.yaw_kp = any.between(2.0, 6.0);
    limits.max_yaw_radps = any.between(0.5, 3.0);
    const double speed_mps = any.between(-0.3, 0.3), turn_radps = any.between(-2.5, 2.5);
    const double error_rad = any.between(-0.4, 0.4), curvature_1pm = any.between(-8.0, 8.0);
    std::vector<double> row = {static_cast<double>(i)};
    for (const TrackLimits& each : {limits, TrackLimits{}}) {
      const TrackSpeeds tracks = tracks_for(speed_mps, turn_radps, each);
      row.insert(row.end(), {turn_asked(error_rad, turn_radps, each),
                             speed_within(speed_mps, turn_radps, each),
                             speed_along(std::abs(speed_mps), error_rad, curvature_1pm, each),
                             tracks.left_mps, tracks.right_mps});
    }
    trace.row(row);
  }
  EXPECT_EQ(trace.difference(), "");
}

course::Course joined_course() {
  course::Course course =
      make_course({course::Line{0.31}, course::Arc{0.12, 1.7}, course::Arc{0.05, -2.0},
                   course::Line{0.013}, course::Line{0.2}, course::Pivot{-1.2}, course::Line{0.11},
                   course::Arc{0.3, -0.8}, course::Pivot{0.9}, course::Pivot{0.4}});
  course.start = {.x_m = -0.4, .y_m = 0.2, .yaw_rad = -0.7};
  return course;
}

void record(test::GoldenTrace& trace, double i, const Progress& progress) {
  const course::PathPoint here = progress.here(), ahead = progress.ahead(0.04),
                          far = progress.ahead(0.3);
  trace.row({i, here.s_m, here.x_m, here.y_m, here.yaw_rad, here.curvature_1pm, ahead.s_m,
             ahead.curvature_1pm, far.s_m, far.x_m, far.y_m, far.yaw_rad,
             static_cast<double>(progress.next_turn()), progress.left_m()});
}

test::GoldenTrace progress_trace(const char* file) {
  return {file,
          {"i", "s_m", "x_m", "y_m", "yaw_rad", "curvature_1pm", "ahead_s_m", "ahead_curvature_1pm",
           "far_s_m", "far_x_m", "far_y_m", "far_yaw_rad", "next_turn", "left_m"}};
}

TEST(DriveTrace, ProgressFollowsARobotThatWeaves) {
  test::GoldenTrace trace = progress_trace("control/progress.csv");
  const course::Path path(joined_course());
  Progress progress(path);
  test::Sequence any(8);
  double x_m = -0.4, y_m = 0.2;
  for (int i = 0; i < 400; ++i) {
    // On along the path with a wobble, sometimes thrown back or ahead.
    const course::PathPoint next = progress.ahead(any.between(-0.01, 0.025));
    x_m = next.x_m + 0.03 * std::sin(0.31 * i);
    y_m = next.y_m + 0.02 * std::sin(0.23 * i);
    if (i % 11 == 10) {
      const double back_m = any.between(-0.12, 0.08);
      x_m += back_m * std::cos(next.yaw_rad);
      y_m += back_m * std::sin(next.yaw_rad);
      progress.reproject(x_m, y_m, i % 2 == 0 ? 0.1 : 0.04);
    } else {
      if (i % 13 == 6) {
        x_m += 0.09 * std::cos(next.yaw_rad);
        y_m += 0.09 * std::sin(next.yaw_rad);
      }
      progress.advance(x_m, y_m);
    }
    if (progress.left_m() < 0.002 && !progress.next()) {
      progress.restart();
    }
    record(trace, i, progress);
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(DriveTrace, ProgressIsResumedAnywhere) {
  test::GoldenTrace trace = progress_trace("control/resumed.csv");
  const course::Path path(joined_course());
  Progress progress(path);
  int i = 0;
  for (double s_m = -0.01; s_m < path.length_m() + 0.02; s_m += 0.0137) {
    progress.resume(s_m, 0.3 - s_m);
    record(trace, i++, progress);
  }
  // Around each joint: on which segment, and before or after a turn.
  for (const course::PathSegment& segment : path.segments()) {
    for (const double beside_m : {-0.0021, -0.0011, -0.0009, 0.0009, 0.0011, 0.0021}) {
      for (const double share : {-0.2, 0.45, 0.55, 1.3}) {
        progress.resume(segment.end.s_m + beside_m,
                        std::lerp(segment.begin.yaw_rad, segment.end.yaw_rad, share) + 2.0 * kPi);
        record(trace, i++, progress);
      }
    }
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(DriveTrace, CornersAreGuidedAround) {
  test::GoldenTrace trace("control/corners.csv",
                          {"angle_deg", "x_icr_m", "radius_m", "stop_before_m", "reach_m",
                           "worst_m", "speed0", "speed1", "speed2", "speed3", "speed4", "speed5"});
  test::Sequence any(13);
  for (int i = 0; i < 45; ++i) {
    double angle_deg = any.between(-178.0, 178.0);
    double x_icr_m = any.between(0.002, 0.05) * (i % 3 == 0 ? -1.0 : 1.0);
    if (i >= 27) angle_deg = (i % 2 == 0 ? 14.2 : -164.3) + 0.11 * (i - 27);
    if (i >= 39) {  // with the widest and the narrowest arcs
      angle_deg = i % 2 == 0 ? -20.0 + 0.1 * i : 151.0 + 0.3 * i;
      x_icr_m *= i % 2 == 0 ? 1.5 : 0.2;
    }
    const double room_m = i % 5 == 0 ? any.between(0.0, 0.1) : 0.4;
    course::Course course =
        make_course({course::Line{0.4}, course::Pivot{angle_deg * kRadPerDeg}, course::Line{0.4}});
    course.start = {.x_m = 0.1, .y_m = 0.3, .yaw_rad = 0.5};
    const course::Path path(course);
    const course::PathSegment& turn = path.segments()[1];
    const Corner corner(turn, x_icr_m, room_m);
    std::vector<double> row = {angle_deg,         x_icr_m,
                               corner.radius_m(), corner.stop_before_m(),
                               corner.reach_m(),  corner.worst_m()};
    for (int k = 0; k < 6; ++k) {
      Pose pose;
      pose.x_m = turn.begin.x_m + any.between(-0.008, 0.008) - 0.3 * x_icr_m;
      pose.y_m = turn.begin.y_m + any.between(-0.008, 0.008);
      pose.yaw_rad = std::lerp(turn.begin.yaw_rad, turn.end.yaw_rad, 0.05 + 0.18 * k);
      row.push_back(corner.speed_mps(pose, any.between(-0.7, 0.7)));
    }
    trace.row(row);
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(DriveTrace, ATurnOnTheSpotSpeedsUpAndBrakes) {
  test::GoldenTrace trace("control/pivot.csv", {"i", "left_rad", "left_radps", "left_arrived",
                                                "right_rad", "right_radps", "right_arrived"});
  course::Course course = make_course({course::Pivot{1.3}, course::Pivot{-0.7}});
  course.start.yaw_rad = 0.2;
  const course::Path path(course);
  PivotProfile left, right;
  left.begin(path.segments()[0], 10.0);
  right.begin(path.segments()[1], 0.47);
  right.begin_at(1.35 + 2.0 * kPi);
  for (int i = 0; i < 400; ++i) {
    if (i == 150) left.halt_at(0.61);
    if (i == 200) right.halt_at(1.0);
    if (i == 260) left.begin(path.segments()[0], 0.3);
    if (i == 280) left.begin(path.segments()[0], 0.9);
    const double dt_s = 0.0083 + 0.001 * std::sin(0.3 * i);
    left.update({}, dt_s);
    right.update({}, dt_s);
    trace.row({static_cast<double>(i), left.yaw_rad(), left.rate_radps(),
               left.arrived() ? 1.0 : 0.0, right.yaw_rad(), right.rate_radps(),
               right.arrived() ? 1.0 : 0.0});
  }
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::control
