#include "worlds/frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/arithmetic.h"

namespace tp100::worlds {
namespace {

constexpr double kCmPerM = 100.0;
// Beyond this sine of the pitch, roll and yaw cannot be distinguished.
constexpr double kVertical = 1.0 - 1e-9;

/// A frame beside ours. All of it are signs but `from`.
struct Layout {
  std::array<std::size_t, 3> from;  ///< which of our axes each of its axes lies along
  Vector place, turn;               ///< along and about its axes
  Vector rpy;                       ///< roll, pitch, yaw
};

const Layout& layout(Frame frame) {
  static constexpr std::array<Layout, 3> kLayouts = {{
      {{0, 1, 2}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}},       // ros
      {{0, 1, 2}, {1, -1, 1}, {-1, 1, -1}, {1, -1, -1}},  // unreal
      {{1, 2, 0}, {-1, 1, 1}, {1, -1, -1}, {-1, 1, -1}},  // unity
  }};
  return kLayouts[static_cast<std::size_t>(frame)];
}

/// A vector in the axes of a frame, with these signs.
Vector to_axes(const Layout& layout, const Vector& signs, const Vector& ours) {
  Vector theirs{};
  for (std::size_t i = 0; i < 3; ++i) theirs[i] = signs[i] * ours[layout.from[i]];
  return theirs;
}

Vector from_axes(const Layout& layout, const Vector& signs, const Vector& theirs) {
  Vector ours{};
  for (std::size_t i = 0; i < 3; ++i) ours[layout.from[i]] = signs[i] * theirs[i];
  return ours;
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
  Vector place = to_axes(layout(frame), layout(frame).place, m);
  for (double& value : place) value = to_length(frame, value);
  return place;
}

Vector from_place(Frame frame, const Vector& place) {
  Vector m = from_axes(layout(frame), layout(frame).place, place);
  for (double& value : m) value = from_length(frame, value);
  return m;
}

Vector to_turn(Frame frame, const Vector& rad) {
  Vector turn = to_axes(layout(frame), layout(frame).turn, rad);
  for (double& value : turn) value = to_angle(frame, value);
  return turn;
}

Vector to_rpy(Frame frame, const Pose& pose) {
  const Vector& sign = layout(frame).rpy;
  return {sign[0] * to_angle(frame, pose.roll_rad), sign[1] * to_angle(frame, pose.pitch_rad),
          sign[2] * to_angle(frame, pose.yaw_rad)};
}

void from_rpy(Frame frame, const Vector& rpy, Pose& pose) {
  const Vector& sign = layout(frame).rpy;
  pose.roll_rad = sign[0] * from_angle(frame, rpy[0]);
  pose.pitch_rad = sign[1] * from_angle(frame, rpy[1]);
  pose.yaw_rad = sign[2] * from_angle(frame, rpy[2]);
}

Quaternion to_quaternion(Frame frame, const Pose& pose) {
  const Quaternion q = quaternion(pose);
  const Vector axis = to_axes(layout(frame), layout(frame).turn, {q.x, q.y, q.z});
  return {axis[0], axis[1], axis[2], q.w};
}

void from_quaternion(Frame frame, const Quaternion& turned, Pose& pose) {
  const Vector axis = from_axes(layout(frame), layout(frame).turn, {turned.x, turned.y, turned.z});
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
