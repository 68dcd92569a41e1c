#pragma once
// A course with one obstacle of each kind, and a record whose numbers differ from field to field.

#include <memory>
#include <numbers>

#include "core/step_record.h"
#include "messages/messages.h"

namespace tp100::messages {

inline RunContext example_subject() {
  course::Course course;
  course.name = "example";
  course.path = {course::Line{1.0}, course::Pivot{std::numbers::pi / 2}, course::Arc{0.5, -1.0}};
  course.terrain.obstacles = {
      course::Ramp{.place = {1.0, 2.0, std::numbers::pi / 2},
                   .height_m = 0.1,
                   .up_rad = 0.5,
                   .top_m = 0.2,
                   .down_rad = 0.25,
                   .width_m = 0.4},
      course::Block{.place = {0.5, 0.0, 0.0}, .height_m = 0.03, .depth_m = 0.1, .width_m = 0.4}};
  course.terrain.surfaces = {{.name = "ice", .place = {}, .length_m = 0.3, .width_m = 0.2}};
  course.fence = {-1, 2, -3, 4};
  RunContext run_context;
  run_context.course = std::make_shared<const course::Course>(std::move(course));
  run_context.robot.name = "end-loaded";
  return run_context;
}

inline StepRecord example_record() {
  StepRecord record;
  record.now_ns = 12 * kNsPerS;
  record.step = 2400;
  record.inputs.session = SessionState::kReady;
  record.inputs.clock.valid = true;
  record.command_valid = true;
  Snapshot& snapshot = record.snapshot;
  snapshot.now_ns = record.now_ns;
  snapshot.has_sample = true;
  snapshot.age_us = 3000;
  snapshot.sample.measured_ns = record.now_ns - 3 * kNsPerMs;
  snapshot.sample.state = RobotState::kRunning;
  snapshot.sample.battery_v = 7.9;
  snapshot.estimates[PoseSource::kModel].pose.x_m = 0.11;
  snapshot.estimates[PoseSource::kOdometry].pose.x_m = 0.22;
  snapshot.estimates[PoseSource::kOdometry].pose.yaw_rad = 0.3;
  snapshot.estimates[PoseSource::kFused].pose.x_m = 0.33;
  snapshot.world = snapshot.estimates[PoseSource::kOdometry].pose;
  snapshot.world.z_m = 0.05;
  snapshot.command.pose = snapshot.estimates[PoseSource::kOdometry].pose;
  snapshot.command.desired_yaw_rad = 0.3;
  snapshot.command.speed_mps = 0.1;
  snapshot.progress_m = 0.2;
  snapshot.run_state = RunState::kRunning;
  snapshot.start_refusal = StartRefusal::kUnderWay;
  return record;
}

/// A clock that was started at host time 2 s, when the wall clock showed 1000 s.
inline PublishClock example_clock() { return {2 * kNsPerS, 1000 * kNsPerS}; }

}  // namespace tp100::messages
