#include "worlds/frame.h"

#include <algorithm>
#include <cmath>

#include "core/arithmetic.h"

namespace tp100::worlds {
namespace {

constexpr double kCmPerM = 100.0;
// Beyond this sine of the pitch, roll and yaw cannot be distinguished.
constexpr double kVertical = 1.0 - 1e-9;

/// Converts a rotation axis from our frame to `frame`.
Vector to_axis(Frame frame, const Vector& axis) {
  switch (frame) {
    case Frame::kUnreal:
      return {-axis[0], axis[1], -axis[2]};
    case Frame::kUnity:
      return {axis[1], -axis[2], -axis[0]};
    case Frame::kRos:
      break;
  }
  return axis;
}

Vector from_axis(Frame frame, const Vector& axis) {
  switch (frame) {
    case Frame::kUnreal:
      return {-axis[0], axis[1], -axis[2]};
    case Frame::kUnity:
      return {-axis[2], axis[0], -axis[1]};
    case Frame::kRos:
      break;
  }
  return axis;
}

}  // namespace

double to_length(Frame frame, double m) { return frame == Frame::kUnreal ? m * kCmPerM : m; }
double from_length(Frame frame, double length) {
  return frame == Frame::kUnreal ? length / kCmPerM : length;
}
double to_angle(Frame frame, double rad) { return frame == Frame::kRos ? rad : rad * kDegPerRad; }
double from_angle(Frame frame, double angle) {
  return frame == Frame::kRos ? angle : angle * kRadPerDeg;
}

Vector to_place(Frame frame, const Vector& m) {
  switch (frame) {
    case Frame::kUnreal:
      return {m[0] * kCmPerM, -m[1] * kCmPerM, m[2] * kCmPerM};
    case Frame::kUnity:
      return {-m[1], m[2], m[0]};
    case Frame::kRos:
      break;
  }
  return m;
}

Vector from_place(Frame frame, const Vector& place) {
  switch (frame) {
    case Frame::kUnreal:
      return {place[0] / kCmPerM, -place[1] / kCmPerM, place[2] / kCmPerM};
    case Frame::kUnity:
      return {place[2], -place[0], place[1]};
    case Frame::kRos:
      break;
  }
  return place;
}

Vector to_turn(Frame frame, const Vector& rad) {
  Vector turn = to_axis(frame, rad);
  for (double& value : turn) value = to_angle(frame, value);
  return turn;
}

Vector to_rpy(Frame frame, const Pose& pose) {
  const double roll = to_angle(frame, pose.roll_rad);
  const double pitch = to_angle(frame, pose.pitch_rad);
  const double yaw = to_angle(frame, pose.yaw_rad);
  switch (frame) {
    case Frame::kUnreal:
      return {roll, -pitch, -yaw};
    case Frame::kUnity:
      return {-roll, pitch, -yaw};
    case Frame::kRos:
      break;
  }
  return {roll, pitch, yaw};
}

void from_rpy(Frame frame, const Vector& rpy, Pose& pose) {
  const double roll = from_angle(frame, rpy[0]);
  const double pitch = from_angle(frame, rpy[1]);
  const double yaw = from_angle(frame, rpy[2]);
  pose.roll_rad = frame == Frame::kUnity ? -roll : roll;
  pose.pitch_rad = frame == Frame::kUnreal ? -pitch : pitch;
  pose.yaw_rad = frame == Frame::kRos ? yaw : -yaw;
}

Quaternion to_quaternion(Frame frame, const Pose& pose) {
  const Quaternion q = quaternion(pose);
  const Vector axis = to_axis(frame, {q.x, q.y, q.z});
  return {axis[0], axis[1], axis[2], q.w};
}

void from_quaternion(Frame frame, const Quaternion& turned, Pose& pose) {
  const Vector axis = from_axis(frame, {turned.x, turned.y, turned.z});
  const Quaternion q{axis[0], axis[1], axis[2], turned.w};
  const double sine = std::clamp(2.0 * (q.w * q.y - q.z * q.x), -1.0, 1.0);
  pose.pitch_rad = std::asin(sine);
  if (std::abs(sine) > kVertical) {
    pose.roll_rad = 0.0;
    pose.yaw_rad = wrap_angle(-2.0 * std::copysign(1.0, sine) * std::atan2(q.x, q.w));
    return;
  }
  pose.roll_rad = std::atan2(2.0 * (q.w * q.x + q.y * q.z), 1.0 - 2.0 * (q.x * q.x + q.y * q.y));
  pose.yaw_rad = std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

}  // namespace tp100::worlds
