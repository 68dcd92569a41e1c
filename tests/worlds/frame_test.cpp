#include "worlds/frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/arithmetic.h"

namespace tp100::worlds {
namespace {

constexpr Frame kFrames[] = {Frame::kRos, Frame::kUnreal, Frame::kUnity};

Pose leaning(double roll_deg, double pitch_deg, double yaw_deg) {
  return {.roll_rad = roll_deg * kRadPerDeg,
          .pitch_rad = pitch_deg * kRadPerDeg,
          .yaw_rad = yaw_deg * kRadPerDeg};
}

void expect_near(const Vector& is, const Vector& wanted) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(is[i], wanted[i], 1e-9) << "element " << i;
}

// Calculated by hand: sine and cosine of 15 degrees for a nose-up pitch of 30 degrees, and of 45
// degrees for a left turn.
constexpr double kSin15 = 0.25881904510252074, kCos15 = 0.9659258262890683;
constexpr double kHalfRoot = 0.7071067811865476;

void expect_quaternion(Frame frame, const Pose& pose, const Quaternion& wanted) {
  const Quaternion q = to_quaternion(frame, pose);
  EXPECT_NEAR(q.x, wanted.x, 1e-12) << to_string(frame);
  EXPECT_NEAR(q.y, wanted.y, 1e-12) << to_string(frame);
  EXPECT_NEAR(q.z, wanted.z, 1e-12) << to_string(frame);
  EXPECT_NEAR(q.w, wanted.w, 1e-12) << to_string(frame);
}

TEST(Frame, PlacesAreTurnedAndScaledAsEachEngineHasThem) {
  const Vector place = {1.2, -0.8, 0.037};  // the paper's step, seen from above
  expect_near(to_place(Frame::kRos, place), {1.2, -0.8, 0.037});
  expect_near(to_place(Frame::kUnreal, place), {120.0, 80.0, 3.7});
  expect_near(to_place(Frame::kUnity, place), {0.8, 0.037, 1.2});
}

// Nose up is a negative pitch in ROS and Unity, a left turn a positive yaw in ROS alone, and the
// left side up a positive roll in ROS and Unreal.
TEST(Frame, TurnsHaveTheSignAndUnitOfEachEngine) {
  struct Case {
    Frame frame;
    Pose pose;
    Vector rpy;
    Quaternion quaternion;
  };
  const Pose nose_up = leaning(0, -30, 0), left = leaning(0, 0, 90), left_up = leaning(30, 0, 0);
  const double sixth = kPi / 6;
  const Case cases[] = {
      {Frame::kRos, nose_up, {0, -sixth, 0}, {0, -kSin15, 0, kCos15}},
      {Frame::kUnreal, nose_up, {0, 30, 0}, {0, -kSin15, 0, kCos15}},
      {Frame::kUnity, nose_up, {0, -30, 0}, {-kSin15, 0, 0, kCos15}},
      {Frame::kRos, left, {0, 0, kPi / 2}, {0, 0, kHalfRoot, kHalfRoot}},
      {Frame::kUnreal, left, {0, 0, -90}, {0, 0, -kHalfRoot, kHalfRoot}},
      {Frame::kUnity, left, {0, 0, -90}, {0, -kHalfRoot, 0, kHalfRoot}},
      {Frame::kRos, left_up, {sixth, 0, 0}, {kSin15, 0, 0, kCos15}},
      {Frame::kUnreal, left_up, {30, 0, 0}, {-kSin15, 0, 0, kCos15}},
      {Frame::kUnity, left_up, {-30, 0, 0}, {0, 0, -kSin15, kCos15}},
  };
  for (const Case& each : cases) {
    expect_near(to_rpy(each.frame, each.pose), each.rpy);
    expect_quaternion(each.frame, each.pose, each.quaternion);
  }
  expect_near(to_turn(Frame::kUnreal, {0, 0, kPi}), {0, 0, -180});
  expect_near(to_turn(Frame::kUnity, {0, 0, kPi}), {0, -180, 0});
}

// The formula is that of FRotator::Quaternion in Unreal's Core.
TEST(Frame, UnrealsRotatorGivesUnrealsQuaternion) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-80, 80);
  for (int i = 0; i < 1000; ++i) {
    const Pose pose = leaning(angle(random), angle(random), 2 * angle(random));
    const Vector rpy = to_rpy(Frame::kUnreal, pose);
    const double r = rpy[0] * kRadPerDeg / 2, p = rpy[1] * kRadPerDeg / 2,
                 y = rpy[2] * kRadPerDeg / 2;
    const double sp = std::sin(p), cp = std::cos(p), sy = std::sin(y), cy = std::cos(y),
                 sr = std::sin(r), cr = std::cos(r);
    expect_quaternion(Frame::kUnreal, pose,
                      {cr * sp * sy - sr * cp * cy, -cr * sp * cy - sr * cp * sy,
                       cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy});
  }
}

// Unity's Quaternion.Euler(x, y, z) rotates about y, then x, then z, multiplied in this order.
TEST(Frame, UnitysEulerAnglesGiveUnitysQuaternion) {
  const auto times = [](const Quaternion& a, const Quaternion& b) {
    return Quaternion{a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                      a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
                      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
  };
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-80, 80);
  for (int i = 0; i < 1000; ++i) {
    const Pose pose = leaning(angle(random), angle(random), 2 * angle(random));
    const Vector rpy = to_rpy(Frame::kUnity, pose);
    const double z = rpy[0] * kRadPerDeg / 2, x = rpy[1] * kRadPerDeg / 2,
                 y = rpy[2] * kRadPerDeg / 2;
    const Quaternion turn =
        times(times({0, std::sin(y), 0, std::cos(y)}, {std::sin(x), 0, 0, std::cos(x)}),
              {0, 0, std::sin(z), std::cos(z)});
    expect_quaternion(Frame::kUnity, pose, turn);
  }
}

// Rotating a position in the frame's coordinates must give the same as rotating it in ours:
// quaternions and positions of a frame belong together. The formula is the same in left-handed
// frames.
TEST(Frame, QuaternionsTurnPlacesOfTheirFrame) {
  const auto rotate = [](const Quaternion& q, const Vector& v) {
    const Vector t = {2 * (q.y * v[2] - q.z * v[1]), 2 * (q.z * v[0] - q.x * v[2]),
                      2 * (q.x * v[1] - q.y * v[0])};
    return Vector{v[0] + q.w * t[0] + q.y * t[2] - q.z * t[1],
                  v[1] + q.w * t[1] + q.z * t[0] - q.x * t[2],
                  v[2] + q.w * t[2] + q.x * t[1] - q.y * t[0]};
  };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-80, 80), place(-2, 2);
  for (int i = 0; i < 1000; ++i) {
    const Pose pose = leaning(angle(random), angle(random), 2 * angle(random));
    const Vector at = {place(random), place(random), place(random)};
    const Vector turned = rotate(to_quaternion(Frame::kRos, pose), at);
    for (const Frame frame : kFrames)
      expect_near(rotate(to_quaternion(frame, pose), to_place(frame, at)), to_place(frame, turned));
  }
}

TEST(Frame, EverythingComesBackAsItWent) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> angle(-89, 89), place(-5, 5);
  for (int i = 0; i < 1000; ++i) {
    const Pose pose = leaning(angle(random), angle(random), 2 * angle(random));
    const Vector at = {place(random), place(random), place(random)};
    for (const Frame frame : kFrames) {
      expect_near(from_place(frame, to_place(frame, at)), at);
      EXPECT_NEAR(from_length(frame, to_length(frame, 0.037)), 0.037, 1e-12);
      Pose by_angles, by_quaternion;
      from_rpy(frame, to_rpy(frame, pose), by_angles);
      from_quaternion(frame, to_quaternion(frame, pose), by_quaternion);
      for (const Pose& back : {by_angles, by_quaternion}) {
        EXPECT_NEAR(back.roll_rad, pose.roll_rad, 1e-9);
        EXPECT_NEAR(back.pitch_rad, pose.pitch_rad, 1e-9);
        EXPECT_NEAR(back.yaw_rad, pose.yaw_rad, 1e-9);
      }
    }
  }
}

TEST(Frame, LookingStraightUpOrDownLosesNothing) {
  for (const double pitch_deg : {-90.0, 90.0}) {
    Pose back;
    from_quaternion(Frame::kRos, to_quaternion(Frame::kRos, leaning(0, pitch_deg, 40)), back);
    EXPECT_NEAR(back.pitch_rad, pitch_deg * kRadPerDeg, 1e-6);
    EXPECT_NEAR(back.yaw_rad, 40 * kRadPerDeg, 1e-6);
  }
}

}  // namespace
}  // namespace tp100::worlds
