#include "bridge/cycle.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/arithmetic.h"
#include "model/track_model.h"

namespace tp100::bridge {
namespace {

struct NameByIndex {
  template <class T>
  void field(const char* name, const T&) {
    if (index++ == wanted) found = std::string(name, std::strcspn(name, ","));
  }
  unsigned wanted = 0;
  unsigned index = 0;
  std::string found = "unknown";
};

std::uint16_t rounded(double value) { return static_cast<std::uint16_t>(std::lround(value)); }

std::uint8_t flags(const bridge::Parameters& parameters) {
  const course::DriveValues& drive = parameters.drive;
  const bool gyro = parameters.setup != bridge::Setup::kStand;
  return static_cast<std::uint8_t>((gyro ? wire::kUseGyro : 0) |
                                   (drive.invert_left_encoder ? wire::kInvertLeftEncoder : 0) |
                                   (drive.invert_right_encoder ? wire::kInvertRightEncoder : 0) |
                                   (drive.invert_left_motor ? wire::kInvertLeftMotor : 0) |
                                   (drive.invert_right_motor ? wire::kInvertRightMotor : 0) |
                                   (drive.swap_tracks ? wire::kSwapTracks : 0));
}

}  // namespace

link::SessionSettings session_settings(const bridge::Parameters& parameters,
                                       const course::Course* course) {
  const course::DriveValues& drive = parameters.drive;
  const model::TrackParameters& tracks = parameters.model;
  link::SessionSettings settings;
  wire::Parameters& out = settings.parameters;
  const auto wheelbase_of = [&](const model::TurnShape& shape) {
    return static_cast<float>(turn_of(tracks, model::Mode::kExtended, shape).wheelbase_m);
  };
  out.counts_per_metre = static_cast<float>(drive.counts_per_metre);
  // The firmware has three wheelbases. In turns wider than medium arcs it uses the first one: its
  // allowance for slip by distance exceeds the difference there.
  out.wheelbase_m = wheelbase_of({.medium = 1.0});
  out.wheelbase_tight_m = wheelbase_of({.medium = 1.0, .arc = 1.0});
  out.wheelbase_spin_m = wheelbase_of({.medium = 1.0, .arc = 1.0, .spin = 1.0});
  const bool turn_known = course == nullptr || !course->identifies;
  out.turn_slip_share =
      turn_known ? static_cast<float>(std::min(parameters.control.turn_slip_share, 1.0)) : 1.0F;
  out.slip_left = static_cast<float>(tracks.slip_left);
  out.slip_right = static_cast<float>(tracks.slip_right);
  out.max_track_mps = static_cast<float>(drive.max_track_mps);
  out.max_track_mps2 = static_cast<float>(drive.max_track_mps2);
  out.feed_forward = static_cast<float>(drive.feed_forward);
  out.dead_band = static_cast<float>(drive.dead_band);
  out.speed_kp = static_cast<float>(drive.speed_kp);
  out.speed_ki = static_cast<float>(drive.speed_ki);
  out.yaw_kp = static_cast<float>(drive.yaw_kp);
  out.max_yaw_radps = static_cast<float>(drive.max_yaw_radps);
  const double nominal = kRadPerDeg / static_cast<double>(wire::kGyroLsbPerDegps);
  out.gyro_z_radps_per_lsb = static_cast<float>(nominal * tracks.gyro_scale);
  out.battery_cutoff_mv = rounded(drive.battery_cutoff_v * 1e3);
  out.stall_duty = rounded(drive.stall_duty * wire::kFullDuty);
  out.stall_ms = rounded(drive.stall_s * 1e3);
  out.command_life_ms = wire::kMaxCommandLifeMs;
  out.yaw_window_ms = wire::kMaxCommandLifeMs;
  out.flags = flags(parameters);
  return settings;
}

std::string parameter_name(unsigned index) {
  wire::Parameters parameters{};
  NameByIndex namer{index};
  parameters.visit(namer);
  return namer.found;
}

static_assert(StepInputs::Samples::kCapacity >= link::Session::kMaxSamples);

Cycle::Cycle(const link::SessionSettings& settings, const bridge::Parameters& parameters,
             std::shared_ptr<const course::Course> course)
    : session_(settings), step_(parameters, std::move(course)) {}

void Cycle::request(OperatorRequest request) {
  if (!next_->requests.push(request) && request == OperatorRequest::kStop)
    next_->requests.back() = request;
}

void Cycle::change(const ParameterChange& change) { next_->changes.push(change); }

void Cycle::velocity(const VelocityInput& input) {
  if (!next_->velocities.push(input)) next_->velocities.back() = input;
}

void Cycle::camera(const CameraSample& seen) { next_->camera.push(seen); }

void Cycle::world(const WorldSample& received) {
  if (next_->world.push(received)) return;
  const bool stop = next_->world.back().stop || received.stop;
  next_->world.back() = received;
  next_->world.back().stop = stop;
}

bool Cycle::change_setup(SetupChange& change, HostNs now) {
  if (!step_.changeable()) return false;
  next_->restart.clear();
  next_->restart.push(step_.restart_state(change.place, now));
  restarted_ns_ = now;
  if (!change.step) return true;
  std::swap(step_, *change.step);
  outputs_ = &none_;  // the others belong to the old step
  if (change.parameters) session_.use(*change.parameters, now);
  return true;
}

const bridge::Outputs& Cycle::step(HostNs now) {
  next_->samples.assign(session_.take_samples());
  next_->session = session_.state();
  next_->clock = session_.clock();
  next_->session_number = session_.session_number();
  next_->robot_rebooted = session_.take_rebooted();
  next_->answer = session_.take_answer();
  restart_at_rest(now);
  std::swap(inputs_, next_);
  next_->restart.clear();
  next_->requests.clear();
  next_->changes.clear();
  next_->velocities.clear();
  next_->camera.clear();
  next_->world.clear();
  outputs_ = &step_(*inputs_, now);
  now_ns_ = now;
  ++steps_;
  const bool disarming = stopping_ && outputs_->request != RobotRequest::kStop;
  if (outputs_->request != RobotRequest::kNone && !disarming)
    session_.request(outputs_->request, now);
  session_.poll(now);
  if (outputs_->command_valid) session_.send(outputs_->command, now);
  return *outputs_;
}

void Cycle::restart_at_rest(HostNs now) {
  if (steps_ == 0) restarted_ns_ = now;
  if (now - restarted_ns_ < kRestartPeriodNs || !step_.at_rest()) return;
  next_->restart.push(step_.carried());
  restarted_ns_ = now;
}

void Cycle::record(StepRecord& out) const {
  out.now_ns = now_ns_;
  out.step = steps_;
  out.inputs = *inputs_;
  out.link = session_.counters();
  out.command_valid = outputs_->command_valid;
  out.request = outputs_->request;
  out.snapshot = outputs_->snapshot;
}

void Cycle::disarm(HostNs now) {
  stopping_ = true;
  request(OperatorRequest::kHold);
  session_.request(RobotRequest::kDisarm, now);
}

}  // namespace tp100::bridge
