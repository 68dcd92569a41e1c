#pragma once
// The paper's text files between a world and the bridge: Encoder.txt out, Orientation.txt in.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/pose.h"
#include "core/step_record.h"
#include "worlds/frame.h"

namespace tp100::worlds {

/// Throws UserError if `pattern` is too long or contains an unknown {name}. `where` begins the
/// message.
void require_encoder_template(std::string_view pattern, const std::string& where);

/// `pattern` with each {name} replaced; lengths and angles in `frame`'s units and signs. Names:
/// seq, t_s, left_count, right_count, left and right (track speeds), x, y, z, roll, pitch, yaw
/// (pose in the course's world), mode. Always ends with a line break, which marks it as complete.
std::string encoder_text(std::string_view pattern, const StepRecord& record, Frame frame);

/// The paper's Orientation.txt: the robot's position and attitude from a world. Input is hostile.
/// Size limit; a longer file is rejected.
inline constexpr std::size_t kMaxOrientationText = 4096;

/// Decoded text in our units, finite and in range.
struct Orientation {
  Pose pose{};
  bool has_turn = false;   ///< has roll, pitch and yaw; else pitch alone
  bool has_place = false;  ///< has x, y and z
};

/// Decodes `text`: Unreal's own texts, "P=-28.0 Y=0.0 R=0.0" of a rotator and "X=10.0 Y=0.0 Z=4.0"
/// of a vector in any order, or plain numbers: one is the pitch, three are pitch, yaw and roll in a
/// rotator's order, six are x, y, z and these. Nothing if it is incomplete or out of range.
std::optional<Orientation> orientation_of(std::string_view text, Frame frame);

}  // namespace tp100::worlds
