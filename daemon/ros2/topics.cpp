#include "ros2/topics.h"

#include <limits>
#include <string>
#include <utility>

#include "core/arithmetic.h"
#include "core/faults.h"
#include "messages/status_messages.h"
#include "ros2/message_types.h"
#include "ros2/robot_description.h"
#include "text/format.h"

namespace tp100::ros2 {
namespace {

using Status = diagnostic_msgs::DiagnosticStatus;

constexpr const char* kOdom = "odom";

constexpr HostNs kSlowPeriodNs = kNsPerS;  // of battery and state
// Noise densities of the MPU6050 (data sheet rev 3.4, 6.1 and 6.2) through the low pass that the
// firmware sets (42 and 44 Hz, of first order). [(rad/s)^2, (m/s^2)^2]
const double kGyroVariance = square(0.005 * kRadPerDeg) * 42.0 * kPi / 2.0;
const double kAccelVariance = square(400e-6 * kStandardGravityMps2) * 44.0 * kPi / 2.0;

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

builtin_interfaces::Time time_of(std::uint64_t unix_ns) {
  return {.sec = static_cast<std::int32_t>(unix_ns / 1'000'000'000U),
          .nanosec = static_cast<std::uint32_t>(unix_ns % 1'000'000'000U)};
}

geometry_msgs::Quaternion rotation_of(const Pose& pose) {
  const Quaternion rotation = quaternion(pose);
  return {.x = rotation.x, .y = rotation.y, .z = rotation.z, .w = rotation.w};
}

geometry_msgs::Pose pose_of(const Pose& pose) {
  return {.position = {.x = pose.x_m, .y = pose.y_m, .z = pose.z_m},
          .orientation = rotation_of(pose)};
}

geometry_msgs::TransformStamped transform_of(const std_msgs::Header& header, const char* child,
                                             const Pose& pose) {
  return {.header = header,
          .child_frame_id = child,
          .transform = {.translation = {.x = pose.x_m, .y = pose.y_m, .z = pose.z_m},
                        .rotation = rotation_of(pose)}};
}

/// Covariance of x, y, z and the rotations about x, y, z, or of their rates.
std::array<double, 36> covariance_of(const PlanarCovariance& planar) {
  std::array<double, 36> covariance{};
  constexpr std::size_t kX = 0, kY = 1, kYaw = 5;
  const auto put = [&](std::size_t row, std::size_t column, double value) {
    covariance[6 * row + column] = covariance[6 * column + row] = value;
  };
  put(kX, kX, planar.xx);
  put(kX, kY, planar.xy);
  put(kX, kYaw, planar.x_yaw);
  put(kY, kY, planar.yy);
  put(kY, kYaw, planar.y_yaw);
  put(kYaw, kYaw, planar.yaw_yaw);
  for (std::size_t other = kY + 1; other < kYaw; ++other) put(other, other, kUnknownVariance);
  return covariance;
}

/// Covariance of three independent axes.
std::array<double, 9> covariance_of(double variance) {
  return {variance, 0.0, 0.0, 0.0, variance, 0.0, 0.0, 0.0, variance};
}

nav_msgs::Odometry odometry_of(const std_msgs::Header& header, const Snapshot& snapshot) {
  const Estimate& estimate = snapshot.estimates[PoseSource::kOdometry];
  nav_msgs::Odometry odometry{.header = header, .child_frame_id = kBaseLink};
  odometry.pose.pose = pose_of(estimate.pose);
  odometry.pose.covariance = covariance_of(estimate.covariance);
  odometry.twist.twist.linear = {.x = estimate.twist.vx_mps, .y = estimate.twist.vy_mps};
  odometry.twist.twist.angular.z = estimate.twist.yaw_rate_radps;
  odometry.twist.covariance = covariance_of(snapshot.odometry_twist_covariance);
  return odometry;
}

/// Places the odometry's frame so that the robot stands at the fused x, y, z and yaw. Tilt is the
/// odometry's: a difference of it would swing the whole frame.
Pose map_to_odom(const Snapshot& snapshot) {
  const Pose& odometry = snapshot.estimates[PoseSource::kOdometry].pose;
  const Pose& fused = snapshot.estimates[PoseSource::kFused].pose;
  const Transform2d shift = Transform2d::between(odometry, fused);
  return {.x_m = shift.x_m,
          .y_m = shift.y_m,
          .z_m = fused.z_m - odometry.z_m,
          .yaw_rad = shift.turn_rad};
}

sensor_msgs::Imu imu_of(const std_msgs::Header& header, const Sample& sample) {
  sensor_msgs::Imu imu{.header = header};
  imu.orientation.w = 1.0;
  imu.orientation_covariance[0] = -1.0;  // no orientation
  imu.angular_velocity = {
      .x = sample.gyro_radps[0], .y = sample.gyro_radps[1], .z = sample.gyro_radps[2]};
  imu.angular_velocity_covariance = covariance_of(kGyroVariance);
  imu.linear_acceleration = {
      .x = sample.accel_mps2[0], .y = sample.accel_mps2[1], .z = sample.accel_mps2[2]};
  imu.linear_acceleration_covariance = covariance_of(kAccelVariance);
  return imu;
}

sensor_msgs::JointState joints_of(const std_msgs::Header& header, const Snapshot& snapshot,
                                  const course::Robot& robot) {
  const double radius_m = robot.shape.wheel_radius_m;
  const double rad_per_count = 1.0 / (robot.drive.counts_per_metre * radius_m);
  const Sample& sample = snapshot.sample;
  return {.header = header,
          .name = {kLeftJoint, kRightJoint},
          .position = {static_cast<double>(sample.left_counts) * rad_per_count,
                       static_cast<double>(sample.right_counts) * rad_per_count},
          .velocity = {snapshot.left_mps / radius_m, snapshot.right_mps / radius_m}};
}

sensor_msgs::BatteryState battery_of(const std_msgs::Header& header, const Sample& sample) {
  return {.header = header,
          .voltage = static_cast<float>(sample.battery_v),
          .temperature = kUnknown,
          .current = kUnknown,
          .charge = kUnknown,
          .capacity = kUnknown,
          .design_capacity = kUnknown,
          .percentage = kUnknown,
          .present = true};
}

nav_msgs::Path path_of(const std_msgs::Header& header, const course::Path& path) {
  nav_msgs::Path out{.header = header};
  for (const course::PathPoint& point : messages::path_points(path))
    out.poses.push_back(
        {.header = header,
         .pose = pose_of({.x_m = point.x_m, .y_m = point.y_m, .yaw_rad = point.yaw_rad})});
  return out;
}

diagnostic_msgs::KeyValue entry(std::string_view key, std::string value) {
  return {.key = std::string(key), .value = std::move(value)};
}

Status run_status(const StepRecord& record, const messages::RunContext& run_context) {
  const Snapshot& snapshot = record.snapshot;
  Status status{.level = Status::kOk,
                .name = "tp100d: run",
                .message = std::string(to_string(snapshot.run_state)),
                .hardware_id = run_context.robot.name};
  std::string names;
  FaultMask faults = snapshot.faults;
  while (const auto fault = first_fault(faults)) {
    const FaultText& text = describe(*fault);
    if (names.empty()) {
      status.level = Status::kError;
      status.message += ": " + std::string(text.cause) + "; " + std::string(text.fix);
    }
    names += (names.empty() ? "" : " ") + std::string(text.name);
    faults &= ~fault_bit(*fault);
  }
  status.values = {
      entry("run", std::string(to_string(snapshot.run_state))),
      entry("faults", names),
      entry("course", run_context.course == nullptr ? "" : run_context.course->name),
      entry("setup", run_context.setup),
      entry("steering", std::string(to_string(snapshot.steering))),
      entry("progress_m", text::number_text(snapshot.progress_m)),
      entry("cross_track_m", text::number_text(snapshot.cross_track_m)),
      entry("heading_error_rad", text::number_text(snapshot.heading_error_rad)),
  };
  return status;
}

Status link_status(const StepRecord& record, const messages::RunContext& run_context) {
  const SessionState session = record.inputs.session;
  const bool ready = session == SessionState::kReady;
  const bool none = session == SessionState::kClosed || session == SessionState::kRefused;
  Status status{.level = ready  ? Status::kOk
                         : none ? Status::kError
                                : Status::kWarn,
                .name = "tp100d: link",
                .message = std::string(to_string(session)),
                .hardware_id = run_context.robot.name};
  if (record.snapshot.has_sample) {
    status.values = {entry("robot_state", to_string(record.snapshot.sample.state)),
                     entry("age_us", std::to_string(record.snapshot.age_us))};
  }
  const auto add = [&](std::string_view name, std::uint64_t count) {
    status.values.push_back(entry(name, std::to_string(count)));
  };
  visit_fields(add, record.link);
  return status;
}

Status answer_status(const messages::Event& answer) {
  const bool refused = answer.level != messages::Event::Level::kInfo;
  return {.level = refused ? Status::kWarn : Status::kOk,
          .name = "tp100d: answer",
          .message = answer.text};
}

}  // namespace

const std::array<TopicText, kTopicCount>& topics() {
  static const std::array<TopicText, kTopicCount> kTopics = {{
      {Topic::kOdometry, "/odom", &nav_msgs::Odometry::kType, {}},
      {Topic::kTransforms, "/tf", &tf2_msgs::TFMessage::kType, {.depth = 100}},
      {Topic::kStaticTransforms,
       "/tf_static",
       &tf2_msgs::TFMessage::kType,
       {.transient_local = true, .depth = 1}},
      {Topic::kFusedPose, "/pose/fused", &geometry_msgs::PoseWithCovarianceStamped::kType, {}},
      {Topic::kImu, "/imu/data", &sensor_msgs::Imu::kType, {.reliable = false, .depth = 5}},
      {Topic::kJointStates, "/joint_states", &sensor_msgs::JointState::kType, {}},
      {Topic::kBatteryState, "/battery_state", &sensor_msgs::BatteryState::kType, {}},
      {Topic::kPath, "/path", &nav_msgs::Path::kType, {.transient_local = true, .depth = 1}},
      {Topic::kState, "/tp100/state", &diagnostic_msgs::DiagnosticArray::kType, {}},
      {Topic::kRobotDescription,
       "/robot_description",
       &std_msgs::String::kType,
       {.transient_local = true, .depth = 1}},
      {Topic::kMark, "/tp100/mark", &std_msgs::String::kType, {}},
      {Topic::kGroundTruth, "/ground_truth", &geometry_msgs::PoseStamped::kType, {}},
      {Topic::kClock, "/clock", &rosgraph_msgs::Clock::kType, {.reliable = false, .depth = 1}},
  }};
  return kTopics;
}

Bytes ground_truth(std::uint64_t unix_ns, const Pose& pose) {
  return serialized(
      geometry_msgs::PoseStamped{.header = {time_of(unix_ns), kMap}, .pose = pose_of(pose)});
}

SetupMessages setup_messages(const messages::Messages& messages, HostNs at) {
  const auto stamp = time_of(messages.clock().unix_ns(at));
  const course::Robot& robot = messages.run_context().robot;
  SetupMessages all = {
      {Topic::kRobotDescription, serialized(std_msgs::String{.data = robot_description(robot)})},
      {Topic::kStaticTransforms,
       serialized(tf2_msgs::TFMessage{{transform_of({stamp, kBaseLink}, kImuLink, Pose{})}})}};
  if (messages.path() != nullptr)
    all.emplace_back(Topic::kPath, serialized(path_of({stamp, kMap}, *messages.path())));
  return all;
}

TopicMessages::TopicMessages(messages::RunContext run_context, messages::PublishClock clock,
                             bool virtual_time)
    : messages_(std::move(run_context), clock), virtual_time_(virtual_time) {}

void TopicMessages::exchange(messages::RunContext run_context) {
  messages_ = messages::Messages(std::move(run_context), messages_.clock());
  state_due_ns_ = 0;
}

void TopicMessages::answer(const messages::Event& answer) {
  answer_ = answer;
  state_due_ns_ = 0;
}

void TopicMessages::begin(HostNs at, const Send& send) const {
  for (auto& [topic, cdr] : setup_messages(messages_, at)) send(topic, std::move(cdr));
}

bool TopicMessages::state_is_due(const StepRecord& record) {
  const std::tuple state{record.inputs.session, record.snapshot.run_state, record.snapshot.faults};
  if (std::exchange(state_, state) == state && record.now_ns < state_due_ns_) return false;
  state_due_ns_ = record.now_ns + kSlowPeriodNs;
  return true;
}

void TopicMessages::take(const StepRecord& record, const Send& send) {
  const HostNs now = record.now_ns;
  const Snapshot& snapshot = record.snapshot;
  const messages::RunContext& run_context = messages_.run_context();
  const auto stamp = [this](HostNs at) { return time_of(messages_.clock().unix_ns(at)); };
  if (virtual_time_) send(Topic::kClock, serialized(rosgraph_msgs::Clock{stamp(now)}));
  for (std::uint32_t i = 0; i < record.inputs.samples.size(); ++i) {
    const Sample& sample = record.inputs.samples[i];
    // A value that the robot only repeats is no new measurement.
    if (sample.imu_age != 0) continue;
    send(Topic::kImu, serialized(imu_of({stamp(sample.measured_ns), kImuLink}, sample)));
  }
  if (!record.inputs.samples.empty() && snapshot.has_sample) {
    const HostNs at = snapshot.sample.measured_ns;
    const std_msgs::Header odom{stamp(at), kOdom}, map{stamp(at), kMap}, base{stamp(at), kBaseLink};
    send(Topic::kOdometry, serialized(odometry_of(odom, snapshot)));
    send(Topic::kTransforms,
         serialized(tf2_msgs::TFMessage{
             {transform_of(map, kOdom, map_to_odom(snapshot)),
              transform_of(odom, kBaseLink, snapshot.estimates[PoseSource::kOdometry].pose)}}));
    send(Topic::kFusedPose,
         serialized(geometry_msgs::PoseWithCovarianceStamped{
             .header = map,
             .pose = {
                 .pose = pose_of(snapshot.estimates[PoseSource::kFused].pose),
                 .covariance = covariance_of(snapshot.estimates[PoseSource::kFused].covariance)}}));
    send(Topic::kJointStates, serialized(joints_of(base, snapshot, run_context.robot)));
    if (now >= battery_due_ns_) {
      battery_due_ns_ = now + kSlowPeriodNs;
      send(Topic::kBatteryState, serialized(battery_of(base, snapshot.sample)));
    }
  }
  if (!state_is_due(record)) return;
  diagnostic_msgs::DiagnosticArray state{
      .header = {.stamp = stamp(now)},
      .status = {run_status(record, run_context), link_status(record, run_context)}};
  if (answer_) state.status.push_back(answer_status(*answer_));
  send(Topic::kState, serialized(state));
}

}  // namespace tp100::ros2
