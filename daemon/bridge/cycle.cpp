#include "bridge/cycle.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/angle.h"

namespace tp100::bridge {
namespace {

struct Namer {
  template <class T>
  void field(const char* name, const T&) {
    if (index++ == wanted) found = name;
  }
  unsigned wanted = 0;
  unsigned index = 0;
  const char* found = "unknown";
};

std::uint16_t rounded(double value) { return static_cast<std::uint16_t>(std::lround(value)); }

std::uint8_t flags(const bridge::Parameters& parameters) {
  const course::DriveValues& drive = parameters.drive;
  const bool gyro = parameters.setup != bridge::Setup::kBench;
  return static_cast<std::uint8_t>((gyro ? wire::kUseGyro : 0) |
                                   (drive.invert_left_encoder ? wire::kInvertLeftEncoder : 0) |
                                   (drive.invert_right_encoder ? wire::kInvertRightEncoder : 0) |
                                   (drive.invert_left_motor ? wire::kInvertLeftMotor : 0) |
                                   (drive.invert_right_motor ? wire::kInvertRightMotor : 0) |
                                   (drive.swap_tracks ? wire::kSwapTracks : 0));
}

}  // namespace

link::SessionSettings session_settings(const bridge::Parameters& parameters) {
  const course::DriveValues& drive = parameters.drive;
  const course::ModelValues& model = parameters.model;
  link::SessionSettings settings;
  wire::Parameters& out = settings.parameters;
  out.counts_per_metre = static_cast<float>(drive.counts_per_metre);
  out.wheelbase_m = static_cast<float>(model.wheelbase_m);
  out.slip_left = static_cast<float>(model.slip_left);
  out.slip_right = static_cast<float>(model.slip_right);
  out.max_track_mps = static_cast<float>(drive.max_track_mps);
  out.max_track_mps2 = static_cast<float>(drive.max_track_mps2);
  out.feed_forward = static_cast<float>(drive.feed_forward);
  out.dead_band = static_cast<float>(drive.dead_band);
  out.speed_kp = static_cast<float>(drive.speed_kp);
  out.speed_ki = static_cast<float>(drive.speed_ki);
  out.yaw_kp = static_cast<float>(drive.yaw_kp);
  out.max_yaw_radps = static_cast<float>(drive.max_yaw_radps);
  const double nominal = kRadPerDeg / static_cast<double>(wire::kGyroLsbPerDegps);
  out.gyro_z_radps_per_lsb = static_cast<float>(nominal * model.gyro_scale);
  out.battery_cutoff_mv = rounded(drive.battery_cutoff_v * 1e3);
  out.stall_duty = rounded(drive.stall_duty * wire::kFullDuty);
  out.stall_ms = rounded(drive.stall_s * 1e3);
  out.command_life_ms = wire::kMaxCommandLifeMs;
  out.yaw_window_ms = wire::kMaxCommandLifeMs;
  out.flags = flags(parameters);
  return settings;
}

const char* parameter_name(unsigned index) {
  wire::Parameters parameters{};
  Namer namer{index};
  parameters.visit(namer);
  return namer.found;
}

Cycle::Cycle(const link::SessionSettings& settings, const bridge::Parameters& parameters,
             std::shared_ptr<const course::Course> course)
    : session_(settings), step_(parameters, std::move(course)) {}

void Cycle::open(HostNs now) { session_.open(now); }
void Cycle::close(HostNs now) { session_.close(now); }

void Cycle::receive(std::span<const std::uint8_t> bytes, HostNs now) {
  session_.receive(bytes, now);
}

void Cycle::request(OperatorRequest request) {
  if (request_count_ < kMaxRequests) {
    requests_[request_count_++] = request;
  } else if (request == OperatorRequest::kStop) {
    requests_[kMaxRequests - 1] = request;
  }
}

void Cycle::change(const ParameterChange& change) {
  if (change_count_ < kMaxChanges) changes_[change_count_++] = change;
}

void Cycle::camera(const CameraSample& seen) {
  if (camera_count_ < kMaxCamera) camera_[camera_count_++] = seen;
}

void Cycle::world(const WorldSample& said) {
  if (world_count_ < kMaxWorld) {
    world_[world_count_++] = said;
    return;
  }
  const bool stop = world_.back().stop || said.stop;
  world_.back() = said;
  world_.back().stop = stop;
}

const bridge::Outputs& Cycle::step(HostNs now) {
  samples_ = session_.take_samples();
  inputs_ = {.samples = samples_,
             .requests = std::span(requests_.data(), request_count_),
             .camera = std::span(camera_.data(), camera_count_),
             .world = std::span(world_.data(), world_count_),
             .changes = std::span(changes_.data(), change_count_),
             .session = session_.state(),
             .clock = session_.clock(),
             .session_number = session_.session_number(),
             .robot_rebooted = session_.take_rebooted(),
             .answer = session_.take_answer()};
  outputs_ = &step_(inputs_, now);
  now_ns_ = now;
  ++steps_;
  request_count_ = 0;
  camera_count_ = 0;
  world_count_ = 0;
  change_count_ = 0;
  const bool disarming = stopping_ && outputs_->request != RobotRequest::kStop;
  if (outputs_->request != RobotRequest::kNone && !disarming)
    session_.request(outputs_->request, now);
  session_.poll(now);
  if (outputs_->command_valid) session_.send(outputs_->command, now);
  return *outputs_;
}

void Cycle::record(StepRecord& out) const {
  static_assert(StepRecord::kMaxSamples >= link::Session::kMaxSamples);
  static_assert(StepRecord::kMaxRequests >= kMaxRequests);
  static_assert(StepRecord::kMaxCamera >= kMaxCamera);
  static_assert(StepRecord::kMaxWorld >= kMaxWorld);
  static_assert(StepRecord::kMaxChanges >= kMaxChanges);
  // An input that is not recorded cannot be replayed: a new one does not compile before it is here.
  const auto& [samples, requests, camera, world, changes, session, clock, session_number, rebooted,
               answer] = inputs_;
  out.now_ns = now_ns_;
  out.step = steps_;
  std::copy(samples.begin(), samples.end(), out.samples.begin());
  out.sample_count = static_cast<std::uint32_t>(samples.size());
  std::copy(requests.begin(), requests.end(), out.requests.begin());
  out.request_count = static_cast<std::uint32_t>(requests.size());
  std::copy(camera.begin(), camera.end(), out.camera.begin());
  out.camera_count = static_cast<std::uint32_t>(camera.size());
  std::copy(world.begin(), world.end(), out.world.begin());
  out.world_count = static_cast<std::uint32_t>(world.size());
  std::copy(changes.begin(), changes.end(), out.changes.begin());
  out.change_count = static_cast<std::uint32_t>(changes.size());
  out.session = session;
  out.clock = clock;
  out.session_number = session_number;
  out.robot_rebooted = rebooted;
  out.answer = answer;
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
