// Places and turns in the coordinates of ROS, Unreal and Unity. Together these tests leave no
// freedom: places are as documented, quaternions turn places, and angles give quaternions by the
// engines' own formulas.

#include "worlds/frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
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

void expect_quaternion(Frame frame, const Pose& pose, const Quaternion& wanted) {
  const Quaternion q = to_quaternion(frame, pose);
  EXPECT_NEAR(q.x, wanted.x, 1e-12) << to_string(frame);
  EXPECT_NEAR(q.y, wanted.y, 1e-12) << to_string(frame);
  EXPECT_NEAR(q.z, wanted.z, 1e-12) << to_string(frame);
  EXPECT_NEAR(q.w, wanted.w, 1e-12) << to_string(frame);
}

/// Calls `check` with a thousand poses and places.
void for_any_pose(const std::function<void(const Pose&, const Vector&)>& check) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-89, 89), place(-5, 5);
  for (int i = 0; i < 1000; ++i)
    check(leaning(angle(random), angle(random), 2 * angle(random)),
          {place(random), place(random), place(random)});
}

TEST(Frame, PlacesAreTurnedAndScaledAsEachEngineHasThem) {
  const Vector place = {1.2, -0.8, 0.037};  // the paper's step, seen from above
  expect_near(to_place(Frame::kRos, place), {1.2, -0.8, 0.037});
  expect_near(to_place(Frame::kUnreal, place), {120.0, 80.0, 3.7});
  expect_near(to_place(Frame::kUnity, place), {0.8, 0.037, 1.2});
}

TEST(Frame, TurnsHaveTheSignAndUnitOfEachEngine) {
  expect_near(to_rpy(Frame::kRos, leaning(10, 20, 30)),
              {10 * kRadPerDeg, 20 * kRadPerDeg, 30 * kRadPerDeg});
  expect_near(to_turn(Frame::kUnreal, {0, 0, kPi}), {0, 0, -180});
  expect_near(to_turn(Frame::kUnity, {0, 0, kPi}), {0, -180, 0});
}

// The formulas are that of FRotator::Quaternion in Unreal's Core, and that of Unity's
// Quaternion.Euler(x, y, z): about y, then x, then z, multiplied in this order.
TEST(Frame, AnglesOfAnEngineGiveItsQuaternion) {
  const auto times = [](const Quaternion& a, const Quaternion& b) {
    return Quaternion{a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                      a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
                      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
  };
  for_any_pose([&](const Pose& pose, const Vector&) {
    const Vector unreal = to_rpy(Frame::kUnreal, pose), unity = to_rpy(Frame::kUnity, pose);
    const auto half_sine = [](double deg) { return std::sin(deg * kRadPerDeg / 2); };
    const auto half_cosine = [](double deg) { return std::cos(deg * kRadPerDeg / 2); };
    const double sr = half_sine(unreal[0]), cr = half_cosine(unreal[0]), sp = half_sine(unreal[1]),
                 cp = half_cosine(unreal[1]), sy = half_sine(unreal[2]),
                 cy = half_cosine(unreal[2]);
    expect_quaternion(Frame::kUnreal, pose,
                      {cr * sp * sy - sr * cp * cy, -cr * sp * cy - sr * cp * sy,
                       cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy});
    const Quaternion about_y = {0, half_sine(unity[2]), 0, half_cosine(unity[2])};
    const Quaternion about_x = {half_sine(unity[1]), 0, 0, half_cosine(unity[1])};
    const Quaternion about_z = {0, 0, half_sine(unity[0]), half_cosine(unity[0])};
    expect_quaternion(Frame::kUnity, pose, times(times(about_y, about_x), about_z));
  });
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
  for_any_pose([&](const Pose& pose, const Vector& at) {
    const Vector turned = rotate(to_quaternion(Frame::kRos, pose), at);
    for (const Frame frame : kFrames)
      expect_near(rotate(to_quaternion(frame, pose), to_place(frame, at)), to_place(frame, turned));
  });
}

TEST(Frame, EverythingComesBackAsItWent) {
  for_any_pose([](const Pose& pose, const Vector& at) {
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
  });
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
