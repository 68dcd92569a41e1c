#pragma once
// Patterns to print.

#include <string>

#include "camera/view.h"

namespace tp100::camera {

/// The robot's marker as an SVG drawing of true size, with its white rim and an arrow to the front.
/// Throws SetupError if the dictionary has no such marker.
std::string marker_svg(const View& view, int id);

}  // namespace tp100::camera
