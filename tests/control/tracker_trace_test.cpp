#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "control/tracker.h"
#include "core/arithmetic.h"
#include "lagging_robot.h"
#include "support/golden_trace.h"

namespace tp100::control {
namespace {

/// Lines, arcs and turns of all sizes, to both sides, away from the axes.
course::Course winding_course() {
  course::Course course = make_course(
      {course::Line{0.24}, course::Arc{0.3, 1.1}, course::Arc{0.08, -1.4}, course::Line{0.21},
       course::Pivot{1.3}, course::Line{0.17}, course::Pivot{-2.2}, course::Line{0.26},
       course::Arc{0.2, -0.9}, course::Pivot{0.5}, course::Line{0.15}, course::Pivot{2.95},
       course::Line{0.16}, course::Pivot{-0.2}, course::Line{0.12}, course::Arc{0.11, 1.2}});
  course.start = {.x_m = 0.31, .y_m = -0.17, .yaw_rad = 0.6};
  return course;
}

/// One run of the winding course: the robot, and what happens to it.
struct Scenario {
  LawName law = LawName::kStanley;
  double speed_mps = 0.12;
  double x_icr_m = 0.02;
  double slip_angle_rad = 0.02;
  TrackLimits limits{};
  double left_m = 0.02;   ///< start beside the path
  double yaw_rad = 0.25;  ///< ... and across it
  double side = 1.0;      ///< of all pushes
};

class TrackerRun {
 public:
  explicit TrackerRun(const Scenario& scenario)
      : scenario_(scenario),
        path_(winding_course()),
        tracker_(parameters(), path_,
                 {.speed_mps = scenario.speed_mps,
                  .slip_angle_rad = scenario.slip_angle_rad,
                  .tracks = tracks(),
                  .limits = scenario.limits}) {
    robot_.limits = scenario.limits;
    robot_.x_icr_m = scenario.x_icr_m;
    const Pose start = winding_course().start;
    robot_.pose = start;
    robot_.pose.x_m -= scenario.left_m * std::sin(start.yaw_rad);
    robot_.pose.y_m += scenario.left_m * std::cos(start.yaw_rad);
    robot_.pose.yaw_rad += scenario.yaw_rad;
  }

  std::string difference(const std::string& file) {
    test::GoldenTrace trace("control/" + file,
                            {"step", "desired_yaw_rad", "yaw_rate_radps", "speed_mps",
                             "cross_track_m", "off_path_m", "heading_error_rad", "progress_m",
                             "recovering", "done", "x_m", "y_m", "yaw_rad", "nominal_s"});
    for (step_ = 0; step_ < 16000; ++step_) {
      const bool disturbed = happens();
      const Target& target = tracker_.update(measured(), robot_.twist, kStepS, disturbed);
      robot_.obey(target);
      if (disturbed || step_ % 33 == 0 || target.done != done_) record(trace, target);
      if (done_ && ++after_end_ > 40) break;
      done_ = target.done;
    }
    EXPECT_TRUE(done_);
    return trace.difference();
  }

 private:
  static constexpr double kStepS = 0.0051;

  Parameters parameters() const {
    Parameters parameters;
    parameters.law = scenario_.law;
    return parameters;
  }

  model::TrackParameters tracks() const {
    model::TrackParameters tracks;
    tracks.x_icr_m = scenario_.x_icr_m;
    tracks.x_icr_tight_shift_m = 0.2 * scenario_.x_icr_m;
    tracks.x_icr_spin_shift_m = 0.3 * scenario_.x_icr_m;
    return tracks;
  }

  /// The pose as an estimate that wanders by a millimetre.
  Pose measured() const {
    Pose pose = robot_.pose;
    pose.x_m += 0.001 * std::sin(0.011 * step_);
    pose.y_m += 0.001 * std::sin(0.017 * step_ + 1.0);
    pose.yaw_rad += 0.004 * std::sin(0.007 * step_);
    return pose;
  }

  void push(double along_m, double left_m, double yaw_rad) {
    const double c = std::cos(robot_.pose.yaw_rad), s = std::sin(robot_.pose.yaw_rad);
    left_m *= scenario_.side;
    robot_.pose.x_m += c * along_m - s * left_m;
    robot_.pose.y_m += s * along_m + c * left_m;
    robot_.pose.yaw_rad += scenario_.side * yaw_rad;
  }

  /// What happens before this step. True: a disturbance was detected.
  bool happens() {
    switch (step_) {
      case 260:  // on the first line, and back again
        push(-0.03, 0.02, 0.5);
        return true;
      case 900:  // over the joint of two arcs
        push(0.05, -0.01, -0.1);
        return true;
      case 1500:
        push(0.01, 0.015, 0.2);
        return false;
      case 1900:
      case 2600:
      case 3300:
      case 4100:
        tracker_.pause(true);
        return false;
      case 2150:
      case 2750:
      case 3400:
      case 4300:
        tracker_.pause(false);
        return false;
      case 3000: {
        Parameters changed = parameters();
        changed.cross_track_gain_1ps *= 0.8;
        changed.preview_s = 0.04;
        changed.max_approach_rad *= 0.9;
        changed.acceleration_mps2 = 0.11;
        changed.pivot_rate_radps = 0.7;
        changed.pivot_acceleration_radps2 = 1.2;
        changed.min_speed_mps = 0.025;
        changed.pursuit_s = 0.7;
        tracker_.retune(changed);
        return false;
      }
      case 3600:
        push(-0.02, -0.03, 0.3);
        return true;
      default:
        return false;
    }
  }

  void record(test::GoldenTrace& trace, const Target& target) const {
    trace.row({static_cast<double>(step_), target.desired_yaw_rad, target.yaw_rate_radps,
               target.speed_mps, target.cross_track_m, target.off_path_m, target.heading_error_rad,
               target.progress_m, target.recovering ? 1.0 : 0.0, target.done ? 1.0 : 0.0,
               robot_.pose.x_m, robot_.pose.y_m, robot_.pose.yaw_rad,
               tracker_.nominal_duration_s()});
  }

  Scenario scenario_;
  course::Path path_;
  Tracker tracker_;
  LaggingRobot robot_;
  int step_ = 0;
  int after_end_ = 0;
  bool done_ = false;
};

TEST(TrackerTrace, FollowsAWindingCourseByStanley) {
  EXPECT_EQ(TrackerRun({}).difference("tracker_stanley.csv"), "");
}

TEST(TrackerTrace, FollowsAWindingCourseByPurePursuit) {
  EXPECT_EQ(TrackerRun({.law = LawName::kPurePursuit,
                        .speed_mps = 0.13,
                        .x_icr_m = -0.03,
                        .slip_angle_rad = -0.03,
                        .limits = {.slip_left = 0.08,
                                   .slip_right = 0.05,
                                   .max_track_mps = 0.14,
                                   .yaw_kp = 3.6,
                                   .max_yaw_radps = 1.0},
                        .left_m = -0.03,
                        .yaw_rad = 0.5,
                        .side = -1.0})
                .difference("tracker_pure_pursuit.csv"),
            "");
}

TEST(TrackerTrace, FollowsAWindingCourseByLqr) {
  EXPECT_EQ(TrackerRun({.law = LawName::kLqr,
                        .speed_mps = 0.09,
                        .x_icr_m = 0.004,
                        .slip_angle_rad = 0.01,
                        .limits = {.wheelbase_m = 0.24,
                                   .slip_left = 0.1,
                                   .slip_right = 0.14,
                                   .max_track_mps = 0.075,
                                   .yaw_kp = 4.5},
                        .left_m = 0.05,
                        .yaw_rad = -0.8,
                        .side = -1.0})
                .difference("tracker_lqr.csv"),
            "");
}

/// Steps until a robot that stands at the end of these segments, with these errors, is done.
int steps_to_settle(const std::vector<course::Segment>& segments, const Twist& twist,
                    double short_of_m, double yaw_error_rad, const Parameters& parameters = {}) {
  const course::Path path(make_course(segments));
  Tracker tracker(parameters, path, {});
  const course::PathPoint end = path.segments().back().end;
  const Pose pose{.x_m = end.x_m - short_of_m * std::cos(end.yaw_rad),
                  .y_m = end.y_m - short_of_m * std::sin(end.yaw_rad),
                  .yaw_rad = end.yaw_rad + yaw_error_rad};
  tracker.resume(0.97 * path.length_m(), end.yaw_rad - std::copysign(0.02, end.yaw_rad));
  int steps = 0;
  while (!tracker.update(pose, twist, 0.0047).done && steps < 600) ++steps;
  return steps;
}

TEST(TrackerTrace, SettlesAtTheEndOfALineOrATurn) {
  test::GoldenTrace trace("control/settling.csv",
                          {"i", "line", "short_of_end", "turning", "turn", "turn_right", "off_yaw",
                           "moving", "patient", "two_turns"});
  Parameters patient;
  patient.settle_s = 0.5;
  patient.stop_tolerance_m = 0.005;
  patient.pivot_tolerance_rad = 0.03;
  for (int i = -24; i < 24; ++i) {
    const double x = i + 0.37;
    const auto steps = [&](const std::vector<course::Segment>& segments, const Twist& twist,
                           double short_of_m, double yaw_error_rad,
                           const Parameters& parameters = {}) {
      return static_cast<double>(
          steps_to_settle(segments, twist, short_of_m, yaw_error_rad, parameters));
    };
    const std::vector<course::Segment> line{course::Line{0.4}}, left{course::Pivot{0.8}},
        right{course::Pivot{-0.7}}, two{course::Pivot{0.02}, course::Pivot{-0.012}};
    trace.row({x, steps(line, {.vx_mps = 0.0004 * x}, 0.0, 0.1), steps(line, {}, 0.0003 * x, -0.1),
               steps(line, {.yaw_rate_radps = 0.004 * x}, 0.0, 0.2),
               steps(left, {.yaw_rate_radps = 0.004 * x}, 0.0, 0.005),
               steps(right, {.vx_mps = 0.0004 * x}, 0.01, -0.01),
               steps(left, {.vx_mps = -0.003}, 0.0, 0.0015 * x),
               steps(right, {.vx_mps = 0.004, .yaw_rate_radps = 0.03}, 0.0, 0.0016 * x),
               steps(left, {}, 0.0, 0.0027 * x, patient), steps(two, {}, 0.0, 0.0015 * x)});
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(TrackerTrace, RecoversFromAndDetectsDisturbances) {
  test::GoldenTrace trace("control/recovery.csv",
                          {"i", "beside", "across", "both", "crossing", "turned", "noisy",
                           "contradicted", "fresh", "restarted"});
  for (int i = -30; i < 30; ++i) {
    const double x = i + 0.41;
    const auto recovered = [](auto cross_track_m, auto heading_rad) {
      Recovery recovery;
      recovery.begin();
      int step = 0;
      for (; recovery.active() && step < 500; ++step)
        recovery.update(cross_track_m(step), heading_rad(step), 0.0047);
      return static_cast<double>(step);
    };
    const auto always = [](double value) { return [value](int) { return value; }; };
    const auto detected = [](auto gyro_radps, double tracks_radps, int contradicts_at) {
      DisturbanceDetector detector{Parameters{}};
      detector.restart(7);
      double steps = 0.0;
      for (int step = 0; step < 40; ++step) {
        const std::uint32_t contradictions = step < contradicts_at ? 7 : 8;
        steps = 2.0 * steps + (detector.update({.gyro_radps = gyro_radps(step),
                                                .tracks_radps = tracks_radps,
                                                .contradictions = contradictions},
                                               0.0047)
                                   ? 1.0
                                   : 0.0);
      }
      return steps;
    };
    DisturbanceDetector detector{Parameters{}};
    double fresh = 0.0, restarted = 0.0;
    for (int step = 0; step < 8; ++step)
      fresh = 2.0 * fresh + detector.update({.gyro_radps = 0.03 * x}, 0.0047);
    detector.restart(3);
    for (int step = 0; step < 8; ++step) {
      if (step == 3) detector.restart(3);
      restarted = 2.0 * restarted +
                  detector.update({.tracks_radps = 0.03 * x, .contradictions = 3}, 0.0047);
    }
    trace.row({x, recovered(always(0.0006 * x), always(0.01)),
               recovered(always(-0.005), always(0.0035 * x)),
               recovered(always(0.0006 * x), always(-0.0035 * x)),
               recovered([x](int n) { return 0.0011 * x * std::cos(0.01 * n); },
                         [](int n) { return 0.06 * std::exp(-0.01 * n); }),
               detected(always(0.03 * x), 0.1, 100),
               detected([x](int n) { return 0.03 * x * (n % 5 == 0 ? 0.7 : 1.3); }, -0.2, 100),
               detected(always(0.1), 0.01 * x, 15 + i / 4), fresh, restarted});
  }
  EXPECT_EQ(trace.difference(), "");
}

/// Interrupted anywhere, paused or not, and restarted or resumed.
TEST(TrackerTrace, BeginsAnewAtAnyTime) {
  test::GoldenTrace trace("control/tracker_restarts.csv",
                          {"step", "desired_yaw_rad", "yaw_rate_radps", "speed_mps",
                           "cross_track_m", "off_path_m", "progress_m", "recovering", "yaw_rad"});
  const course::Path path(winding_course());
  Tracker tracker(Parameters{}, path, {});
  LaggingRobot robot;
  for (int step = 0; step < 6000; ++step) {
    const int since = step % 500;
    if (step > 0 && since == 0) {
      const double progress_m = 0.19 * (step / 500) - 0.1;
      const course::PathPoint at = path.at(progress_m);
      robot.twist = {};
      robot.pose = {.x_m = at.x_m + 0.004, .y_m = at.y_m - 0.003, .yaw_rad = at.yaw_rad + 0.1};
      if (step % 1500 == 0) {
        tracker.restart();
        robot.pose = winding_course().start;
      } else {
        tracker.resume(progress_m, robot.pose.yaw_rad);
      }
    }
    if (since == 497 && step % 1000 > 500) tracker.pause(true);
    const bool disturbed = since == 498;
    const Target& target = tracker.update(robot.pose, robot.twist, 0.0052, disturbed);
    robot.obey(target);
    if (since < 6 || since > 492 || since % 50 == 0) {
      trace.row({static_cast<double>(step), target.desired_yaw_rad, target.yaw_rate_radps,
                 target.speed_mps, target.cross_track_m, target.off_path_m, target.progress_m,
                 target.recovering ? 1.0 : 0.0, robot.pose.yaw_rad});
    }
  }
  EXPECT_EQ(trace.difference(), "");
}

/// Slower than the speed to which other courses are slowed down in narrow curves.
TEST(TrackerTrace, CreepsAlongASlowCourse) {
  test::GoldenTrace trace("control/tracker_slow.csv",
                          {"step", "desired_yaw_rad", "yaw_rate_radps", "speed_mps",
                           "cross_track_m", "heading_error_rad", "progress_m"});
  const course::Path path(
      make_course({course::Line{0.02}, course::Arc{0.03, 0.8}, course::Line{0.02}}));
  Tracker tracker(Parameters{}, path, {.speed_mps = 0.013});
  LaggingRobot robot;
  robot.pose = {.y_m = 0.004, .yaw_rad = -0.5};
  for (int step = 0; step < 1500; ++step) {
    if (step == 300) robot.pose.y_m += 0.003;
    const Target& target = tracker.update(robot.pose, robot.twist, 0.0053, step == 300);
    robot.obey(target);
    if (step % 12 == 0) {
      trace.row({static_cast<double>(step), target.desired_yaw_rad, target.yaw_rate_radps,
                 target.speed_mps, target.cross_track_m, target.heading_error_rad,
                 target.progress_m});
    }
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(TrackerTrace, KnowsHowLongACourseTakes) {
  test::GoldenTrace trace("control/nominal.csv",
                          {"i", "lines", "arcs", "turns", "slow_s", "default_s"});
  for (int i = 1; i < 40; ++i) {
    const double x = 0.05 * i;
    const auto duration_s = [&](std::vector<course::Segment> segments, double speed_mps) {
      const course::Path path(make_course(std::move(segments)));
      return Tracker({}, path, {.speed_mps = speed_mps}).nominal_duration_s();
    };
    trace.row({x, duration_s({course::Line{x}, course::Line{2.0 - x}}, 0.07 + 0.1 * x),
               duration_s({course::Arc{0.1 * x, 1.3}, course::Arc{0.21 - 0.1 * x, -2.0}}, 0.16),
               duration_s({course::Pivot{x}, course::Arc{0.2, 1.0}, course::Pivot{-1.0}}, 0.11),
               duration_s({course::Arc{0.1 * x, 1.3}, course::Line{0.3}}, 0.011),
               duration_s({course::Line{x}}, DriveModel{}.speed_mps)});
  }
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::control
