#pragma once
// The paper's Encoder.txt: one short text per step, made from a template.

#include <cstdint>
#include <string>
#include <string_view>

#include "core/step_record.h"
#include "worlds/frame.h"

namespace tp100::worlds {

/// Throws SetupError if `pattern` is too long or holds a {name} that encoder_text does not know.
/// `where` opens the message.
void require_encoder_template(std::string_view pattern, const std::string& where);

/// `pattern` with each {name} replaced; lengths and angles in `frame`'s units and signs. Names:
/// seq, t_s, left_count, right_count, left and right (belt speeds), x, y, z, roll, pitch, yaw (pose
/// in the course's world), mode. `\n` and `\t` stand for a line's end and a tab. Always ends with a
/// line's end: the mark that it is complete.
std::string encoder_text(std::string_view pattern, const StepRecord& record, Frame frame);

}  // namespace tp100::worlds
