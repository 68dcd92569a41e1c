#pragma once
// A camera file (config/cameras) as data: one emulated overhead camera.

#include <string>

#include "sim/sensors/overhead_camera.h"

namespace tp100::sim {

/// Parses a camera file. `file` is only used in messages. Throws SetupError (file:line:column).
/// Pure: reads no file itself.
OverheadCameraValues parse_camera(const std::string& text, const std::string& file);

/// A commented file that parse_camera reads back.
std::string write_camera(const OverheadCameraValues& values);

}  // namespace tp100::sim
