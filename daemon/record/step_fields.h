#pragma once
// Lists every field of a StepRecord by name, once: encoding, decoding, the schema in a recording
// and the search for a difference all use this list. A type that grows does not compile until its
// new field is listed here.

#include <concepts>
#include <type_traits>

#include "core/step_record.h"

namespace tp100::record {

template <class T, class Plain>
concept MaybeConst = std::same_as<std::remove_const_t<T>, Plain>;

template <class Visitor, MaybeConst<Pose> T>
void visit_fields(Visitor& v, T& pose) {
  auto& [x, y, z, roll, pitch, yaw] = pose;
  v("x_m", x);
  v("y_m", y);
  v("z_m", z);
  v("roll_rad", roll);
  v("pitch_rad", pitch);
  v("yaw_rad", yaw);
}

template <class Visitor, MaybeConst<Twist> T>
void visit_fields(Visitor& v, T& twist) {
  auto& [vx, vy, rate] = twist;
  v("vx_mps", vx);
  v("vy_mps", vy);
  v("yaw_rate_radps", rate);
}

template <class Visitor, MaybeConst<Sample> T>
void visit_fields(Visitor& v, T& sample) {
  auto& [sequence, lost, device, measured, left, right, gyro, accel, temperature, battery,
         left_duty, right_duty, state, faults, last_command, imu_age] = sample;
  v("sequence", sequence);
  v("lost_before", lost);
  v("device_us", device);
  v("measured_ns", measured);
  v("left_counts", left);
  v("right_counts", right);
  v("gyro_radps", gyro);
  v("accel_mps2", accel);
  v("temperature_degc", temperature);
  v("battery_v", battery);
  v("left_duty", left_duty);
  v("right_duty", right_duty);
  v("state", state, RobotState::kFaulted);
  v("faults", faults);
  v("last_command", last_command);
  v("imu_age", imu_age);
}

template <class Visitor, MaybeConst<CameraSample> T>
void visit_fields(Visitor& v, T& seen) {
  auto& [x, y, yaw, measured, sequence] = seen;
  v("x_m", x);
  v("y_m", y);
  v("yaw_rad", yaw);
  v("measured_ns", measured);
  v("sequence", sequence);
}

template <class Visitor, MaybeConst<WorldSample> T>
void visit_fields(Visitor& v, T& sample) {
  auto& [session, answered, stop, has_ground, height, roll, pitch, slip_offset, step_height,
         blocked, has_pose, pose] = sample;
  v("session", session);
  v("answered_ns", answered);
  v("stop", stop);
  v("has_ground", has_ground);
  v("height_m", height);
  v("roll_rad", roll);
  v("pitch_rad", pitch);
  v("slip_offset", slip_offset);
  v("step_height_m", step_height);
  v("blocked", blocked);
  v("has_pose", has_pose);
  v("pose", pose);
}

template <class Visitor, MaybeConst<ParameterChange> T>
void visit_fields(Visitor& v, T& change) {
  auto& [parameter, value] = change;
  v("parameter", parameter, LiveParameter::kPivotAcceleration);
  v("value", value);
}

template <class Visitor, MaybeConst<VelocityInput> T>
void visit_fields(Visitor& v, T& input) {
  auto& [at, speed, yaw_rate] = input;
  v("at_ns", at);
  v("speed_mps", speed);
  v("yaw_rate_radps", yaw_rate);
}

template <class Visitor, MaybeConst<ClockState> T>
void visit_fields(Visitor& v, T& clock) {
  auto& [valid, reference_host, reference, drift, uncertainty] = clock;
  v("valid", valid);
  v("reference_host_ns", reference_host);
  v("reference_us", reference);
  v("drift", drift);
  v("uncertainty_us", uncertainty);
}

template <class Visitor, MaybeConst<LinkCounters> T>
void visit_fields(Visitor& v, T& link) {
  each_counter(link, v);
}

template <class Visitor, MaybeConst<Command> T>
void visit_fields(Visitor& v, T& command) {
  auto& [answers, answered, pose, desired_yaw, yaw_rate, speed, gyro_bias, expiry] = command;
  v("answers", answers);
  v("answered_us", answered);
  v("pose", pose);
  v("desired_yaw_rad", desired_yaw);
  v("yaw_rate_radps", yaw_rate);
  v("speed_mps", speed);
  v("gyro_bias_radps", gyro_bias);
  v("expiry_us", expiry);
}

template <class Visitor, MaybeConst<PlanarCovariance> T>
void visit_fields(Visitor& v, T& covariance) {
  auto& [xx, xy, x_yaw, yy, y_yaw, yaw_yaw] = covariance;
  v("xx", xx);
  v("xy", xy);
  v("x_yaw", x_yaw);
  v("yy", yy);
  v("y_yaw", y_yaw);
  v("yaw_yaw", yaw_yaw);
}

template <class Visitor, MaybeConst<FilterFigures> T>
void visit_fields(Visitor& v, T& filter) {
  auto& [slip_left, slip_right, gyro_bias, nis, nis_mean, nis_count, camera_age, camera_used,
         camera_rejected, recoveries] = filter;
  v("slip_left", slip_left);
  v("slip_right", slip_right);
  v("gyro_bias_radps", gyro_bias);
  v("nis", nis);
  v("nis_mean", nis_mean);
  v("nis_count", nis_count);
  v("camera_age_us", camera_age);
  v("camera_used", camera_used);
  v("camera_rejected", camera_rejected);
  v("recoveries", recoveries);
}

template <class Visitor, MaybeConst<TerrainContact> T>
void visit_fields(Visitor& v, T& terrain_contact) {
  auto& [pitch_source, obstacle, climbing, slope, slip_offset, traction] = terrain_contact;
  v("pitch_source", pitch_source, PitchSource::kExternal);
  v("obstacle", obstacle, ObstacleClass::kBlock);
  v("climbing", climbing);
  v("slope_rad", slope);
  v("slip_offset", slip_offset);
  v("traction", traction, Traction::kImmobilised);
}

template <class Visitor, MaybeConst<Snapshot> T>
void visit_fields(Visitor& v, T& snapshot) {
  auto& [now, sample, has_sample, age, estimates, odometry_twist, filter, world, terrain_contact,
         left, right, slip_left, slip_right, gyro_bias, imu_roll, imu_pitch, imu_slope,
         imu_obstacle, command, commanded_left, commanded_right, cross_track, heading_error,
         progress, recovering, steering, run_state, start_refusal, drive_refusal, at_fence,
         pause_left, faults] = snapshot;
  v("now_ns", now);
  v("sample", sample);
  v("has_sample", has_sample);
  v("age_us", age);
  for (const PoseSource source : kPoseSources) {
    const char* const name = to_string(source).data();
    v(name, estimates[source].pose);
    v(name, estimates[source].twist);
    v(name, estimates[source].covariance);
  }
  v("odometry_twist_covariance", odometry_twist);
  v("filter", filter);
  v("world", world);
  v("terrain_contact", terrain_contact);
  v("left_mps", left);
  v("right_mps", right);
  v("slip_left", slip_left);
  v("slip_right", slip_right);
  v("gyro_bias_radps", gyro_bias);
  v("imu_roll_rad", imu_roll);
  v("imu_pitch_rad", imu_pitch);
  v("imu_slope", imu_slope, Slope::kDown);
  v("imu_obstacle", imu_obstacle, ObstacleClass::kBlock);
  v("command", command);
  v("commanded_left_mps", commanded_left);
  v("commanded_right_mps", commanded_right);
  v("cross_track_m", cross_track);
  v("heading_error_rad", heading_error);
  v("progress_m", progress);
  v("recovering", recovering);
  v("steering", steering, kPoseSources.back());
  v("run_state", run_state, RunState::kDriving);
  v("start_refusal", start_refusal, StartRefusal::kDriven);
  v("drive_refusal", drive_refusal, StartRefusal::kDriven);
  v("at_fence", at_fence);
  v("pause_left_s", pause_left);
  v("faults", faults);
}

template <class Visitor, MaybeConst<CarriedEstimate> T>
void visit_fields(Visitor& v, T& estimate) {
  auto& [mean, covariance, slip_walk] = estimate;
  v("mean", mean);
  v("covariance", covariance);
  v("slip_walk", slip_walk);
}

template <class Visitor, MaybeConst<CarriedModelCovariance> T>
void visit_fields(Visitor& v, T& covariance) {
  auto& [errors, slip_density, seen] = covariance;
  v("errors", errors);
  v("slip_density_m", slip_density);
  v("seen_m", seen);
}

template <class Visitor, MaybeConst<CarriedFilter> T>
void visit_fields(Visitor& v, T& filter) {
  auto& [estimate, branch, camera, last_seen, camera_known, nis, nis_sum, nis_count, used, rejected,
         recoveries] = filter;
  v("estimate", estimate);
  v("branch_rad", branch);
  v("camera_ns", camera);
  v("last_seen_ns", last_seen);
  v("camera_known", camera_known);
  v("nis", nis);
  v("nis_sum", nis_sum);
  v("nis_count", nis_count);
  v("camera_used", used);
  v("camera_rejected", rejected);
  v("recoveries", recoveries);
}

template <class Visitor, MaybeConst<CarriedAttitude> T>
void visit_fields(Visitor& v, T& attitude) {
  auto& [levelled, gyro_offset, accel_offset, roll, pitch] = attitude;
  v("levelled_s", levelled);
  v("gyro_offset_radps", gyro_offset);
  v("accel_offset_mps2", accel_offset);
  v("roll_rad", roll);
  v("pitch_rad", pitch);
}

template <class Visitor, MaybeConst<CarriedState> T>
void visit_fields(Visitor& v, T& carried) {
  auto& [session_number, run_state, faults, parameters, cross_track, progress, sample, has_sample,
         continues, model, model_covariance, odometry, virtual_x, virtual_y, virtual_turn, filter,
         attitude, gyro_bias, gyro_bias_known] = carried;
  v("session_number", session_number);
  v("run_state", run_state, RunState::kAborted);
  v("faults", faults);
  v.list("parameters", parameters);
  v("cross_track_m", cross_track);
  v("progress_m", progress);
  v("sample", sample);
  v("has_sample", has_sample);
  v("continues", continues);
  v("model", model);
  v("model_covariance", model_covariance);
  v("odometry", odometry);
  v("virtual_x_m", virtual_x);
  v("virtual_y_m", virtual_y);
  v("virtual_turn_rad", virtual_turn);
  v("filter", filter);
  v("attitude", attitude);
  v("gyro_bias_radps", gyro_bias);
  v("gyro_bias_known", gyro_bias_known);
}

template <class Visitor, MaybeConst<StepInputs> T>
void visit_fields(Visitor& v, T& inputs) {
  auto& [restart, samples, requests, camera, world, changes, velocities, session, clock,
         session_number, rebooted, answer] = inputs;
  v.list("restart", restart);
  v.list("samples", samples);
  v.list("requests", requests, OperatorRequest::kResume);
  v.list("camera", camera);
  v.list("world", world);
  v.list("changes", changes);
  v.list("velocities", velocities);
  v("session", session, SessionState::kRefused);
  v("clock", clock);
  v("session_number", session_number);
  v("robot_rebooted", rebooted);
  v("answer", answer, RequestAnswer::kFailed);
}

/// The step's inputs, including its time and number.
template <class Visitor, MaybeConst<StepRecord> T>
void visit_inputs(Visitor& v, T& record) {
  v("now_ns", record.now_ns);
  v("step", record.step);
  visit_fields(v, record.inputs);
}

template <class Visitor, MaybeConst<StepRecord> T>
void visit_results(Visitor& v, T& record) {
  v("command_valid", record.command_valid);
  v("request", record.request, RobotRequest::kStop);
  v("snapshot", record.snapshot);
}

/// Inputs first, then the link's counters, then the results of the step.
template <class Visitor, MaybeConst<StepRecord> T>
void visit_fields(Visitor& v, T& record) {
  // A new field here belongs in visit_inputs, visit_results or below, too.
  auto& [now, step, inputs, link, command_valid, request, snapshot] = record;
  visit_inputs(v, record);
  v("link", link);
  visit_results(v, record);
}

}  // namespace tp100::record
