#pragma once
// The paper's Orientation.txt: what a world says about the robot's place and attitude. Input is
// hostile.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/pose.h"
#include "worlds/frame.h"

namespace tp100::worlds {

/// A longer file is refused.
inline constexpr std::size_t kMaxOrientationText = 4096;

/// What a text says, ours, finite and in range.
struct Orientation {
  Pose pose{};
  bool has_turn = false;   ///< roll, pitch and yaw are said; else pitch alone
  bool has_place = false;  ///< x, y and z are said
};

/// Throws SetupError if `pattern` is too long, holds a {name} that orientation_of does not know or
/// no {pitch}. `where` opens the message.
void require_orientation_template(std::string_view pattern, const std::string& where);

/// Reads `text`. With an empty `pattern`: Unreal's own texts, "P=-28.0 Y=0.0 R=0.0" of a rotator
/// and "X=10.0 Y=0.0 Z=4.0" of a vector in any order, or plain numbers: one is the pitch, three are
/// pitch, yaw and roll in a rotator's order, six are x, y, z and these. With a pattern: its text
/// must be there, {x} {y} {z} {roll} {pitch} {yaw} are numbers, {} is a number that is skipped, and
/// white space matches any white space. Nothing if it is not so, incomplete, or out of range.
std::optional<Orientation> orientation_of(std::string_view text, std::string_view pattern,
                                          Frame frame);

}  // namespace tp100::worlds
