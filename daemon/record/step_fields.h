#pragma once
// Lists every field of a StepRecord by name, once: encoding, decoding, the schema in a recording
// and the search for a difference all use this list.

#include "core/fields.h"
#include "core/step_record.h"

namespace tp100 {

// The last value of each enumeration; tables of names are in the order of the values.
constexpr auto last_of(RobotState) { return kRobotStateNames.back().value; }
constexpr auto last_of(LiveParameter) { return static_cast<LiveParameter>(kLiveParameters - 1); }
constexpr auto last_of(PitchSource) { return kPitchSourceNames.back().value; }
constexpr auto last_of(ObstacleClass) { return kObstacleClassNames.back().value; }
constexpr auto last_of(Traction) { return kTractionNames.back().value; }
constexpr auto last_of(Slope) { return kSlopeNames.back().value; }
constexpr auto last_of(PoseSource) { return kPoseSources.back(); }
constexpr auto last_of(RunState) { return kRunStateNames.back().value; }
constexpr auto last_of(StartRefusal) { return StartRefusal::kOffPath; }
constexpr auto last_of(OperatorRequest) { return kOperatorRequestNames.back().value; }
constexpr auto last_of(SessionState) { return kSessionStateNames.back().value; }
constexpr auto last_of(RequestAnswer) { return RequestAnswer::kFailed; }
constexpr auto last_of(RobotRequest) { return RobotRequest::kStop; }

TP100_FIELDS(Sample, sequence, lost_before, device_us, measured_ns, left_counts, right_counts,
             gyro_radps, accel_mps2, temperature_degc, battery_v, left_duty, right_duty, state,
             faults, last_command, imu_age)
TP100_FIELDS(CameraSample, x_m, y_m, yaw_rad, measured_ns, sequence)
TP100_FIELDS(WorldSample, session, answered_ns, stop, has_ground, height_m, roll_rad, pitch_rad,
             slip_offset, step_height_m, blocked, has_pose, pose)
TP100_FIELDS(ParameterChange, parameter, value)
TP100_FIELDS(VelocityInput, at_ns, speed_mps, yaw_rate_radps)
TP100_FIELDS(ClockState, valid, reference_host_ns, reference_us, drift, uncertainty_us)
TP100_FIELDS(Command, answers, answered_us, pose, desired_yaw_rad, yaw_rate_radps, speed_mps,
             gyro_bias_radps, expiry_us)
TP100_FIELDS(PlanarCovariance, xx, xy, x_yaw, yy, y_yaw, yaw_yaw)
TP100_FIELDS(FilterFigures, slip_left, slip_right, gyro_bias_radps, nis, nis_mean, nis_count,
             camera_age_us, camera_used, camera_rejected, recoveries)
TP100_FIELDS(StartPlaces, unsaid, placed, here)
TP100_FIELDS(TerrainContact, pitch_source, obstacle, climbing, slope_rad, slip_offset, traction)
TP100_FIELDS(CarriedEstimate, mean, covariance, track_trust)
TP100_FIELDS(CarriedModelCovariance, errors)
TP100_FIELDS(CarriedFilter, estimate, branch_rad, camera_ns, last_seen_ns, camera_known, nis,
             nis_sum, nis_count, shift_scale, camera_used, camera_rejected, recoveries)
TP100_FIELDS(CarriedAttitude, levelled_s, gyro_offset_radps, accel_offset_mps2, roll_rad, pitch_rad)
TP100_FIELDS(StepInputs, restart, samples, requests, camera, world, changes, velocities, session,
             clock, session_number, robot_rebooted, answer)

template <class Visitor, MaybeConst<Snapshot> T>
void visit_fields(Visitor& visit, T& snapshot) {
  auto& [now_ns, sample, has_sample, age_us, estimates, odometry_twist_covariance, filter, world,
         terrain_contact, left_mps, right_mps, slip_left, slip_right, gyro_bias_radps, imu_roll_rad,
         imu_pitch_rad, imu_slope, imu_obstacle, command, commanded_left_mps, commanded_right_mps,
         cross_track_m, heading_error_rad, progress_m, recovering, steering, run_state,
         start_refusal, drive_refusal, start_places, onward_m, at_fence, pause_left_s, faults] =
      snapshot;
  TP100_VISIT(visit, now_ns, sample, has_sample, age_us);
  for (const PoseSource source : kPoseSources) {
    visit(to_string(source), estimates[source].pose);
    visit(to_string(source), estimates[source].twist);
    visit(to_string(source), estimates[source].covariance);
  }
  TP100_VISIT(visit, odometry_twist_covariance, filter, world, terrain_contact, left_mps, right_mps,
              slip_left, slip_right, gyro_bias_radps, imu_roll_rad, imu_pitch_rad, imu_slope,
              imu_obstacle, command, commanded_left_mps, commanded_right_mps, cross_track_m,
              heading_error_rad, progress_m, recovering, steering, run_state, start_refusal,
              drive_refusal, start_places, onward_m, at_fence, pause_left_s, faults);
}

template <class Visitor, MaybeConst<CarriedState> T>
void visit_fields(Visitor& visit, T& carried) {
  auto& [session_number, run_state, faults, parameters, cross_track_m, progress_m, moved, sample,
         has_sample, continues, model, model_covariance, odometry, virtual_x_m, virtual_y_m,
         virtual_turn_rad, filter, attitude, gyro_bias_radps, gyro_bias_known] = carried;
  TP100_VISIT(visit, session_number);
  visit("run_state", run_state, RunState::kAborted);
  TP100_VISIT(visit, faults, parameters, cross_track_m, progress_m, moved, sample, has_sample,
              continues, model, model_covariance, odometry, virtual_x_m, virtual_y_m,
              virtual_turn_rad, filter, attitude, gyro_bias_radps, gyro_bias_known);
}

/// The step's inputs, including its time and number.
template <class Visitor, MaybeConst<StepRecord> T>
void visit_inputs(Visitor& visit, T& record) {
  visit("now_ns", record.now_ns);
  visit("step", record.step);
  visit_fields(visit, record.inputs);
}

template <class Visitor, MaybeConst<StepRecord> T>
void visit_results(Visitor& visit, T& record) {
  visit("command_valid", record.command_valid);
  visit("request", record.request);
  visit("snapshot", record.snapshot);
}

/// Inputs first, then the link's counters, then the results of the step.
template <class Visitor, MaybeConst<StepRecord> T>
void visit_fields(Visitor& visit, T& record) {
  // A new field here belongs in visit_inputs, visit_results or below, too.
  auto& [now, step, inputs, link, command_valid, request, snapshot] = record;
  visit_inputs(visit, record);
  visit("link", link);
  visit_results(visit, record);
}

}  // namespace tp100
