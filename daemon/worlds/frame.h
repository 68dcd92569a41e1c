#pragma once
// Converts between the frames of external worlds and ours. Ours ("ros", REP-103): metres, radians,
// right-handed, x forward, y left, z up; so nose-up is a negative pitch and a turn to the left a
// positive yaw.
//
//   unreal  centimetres, degrees, left-handed: x forward, y right, z up
//   unity   metres, degrees, left-handed: x right, y up, z forward
//
// Pure.

#include <array>
#include <optional>
#include <string_view>

#include "core/enum_names.h"
#include "core/pose.h"

namespace tp100::worlds {

enum class Frame { kRos, kUnreal, kUnity };
/// Names as in files and messages.
inline constexpr std::array<EnumName<Frame>, 3> kFrameNames = {{
    {Frame::kRos, "ros"},
    {Frame::kUnreal, "unreal"},
    {Frame::kUnity, "unity"},
}};
constexpr std::string_view to_string(Frame frame) { return name_in(kFrameNames, frame); }

/// Three numbers of a frame, in its order of axes.
using Vector = std::array<double, 3>;

/// Metres to lengths of the frame, and back.
double to_length(Frame frame, double m);
double from_length(Frame frame, double length);
/// Radians to angles of the frame, and back; the sign is unchanged.
double to_angle(Frame frame, double rad);
double from_angle(Frame frame, double angle);

/// Positions, displacements and velocities: metres to the frame's lengths.
Vector to_place(Frame frame, const Vector& m);
Vector from_place(Frame frame, const Vector& place);

/// Angular rates about the three axes: radians to the frame's angles.
Vector to_turn(Frame frame, const Vector& rad);

/// Roll, pitch, yaw with the frame's signs. Unreal (FRotator): nose-up and clockwise yaw are
/// positive. Unity (eulerAngles z, x, y): nose-down and clockwise yaw are positive, roll is
/// positive with the right side up. In all three: first roll, then pitch, then yaw.
Vector to_rpy(Frame frame, const Pose& pose);
/// Sets the angles of `pose`; its position is unchanged.
void from_rpy(Frame frame, const Vector& rpy, Pose& pose);

Quaternion to_quaternion(Frame frame, const Pose& pose);
/// Sets roll, pitch and yaw of `pose` from a unit quaternion, yaw in [-pi, pi]. Looking straight up
/// or down, roll and yaw are the same rotation, which is assigned to yaw.
void from_quaternion(Frame frame, const Quaternion& turned, Pose& pose);

}  // namespace tp100::worlds
