#pragma once
// Detections by a camera program in images of a drive: the file of tp100-camera --tum as samples.

#include <string>
#include <vector>

#include "core/sample.h"

namespace tp100::sim {

/// Detections in the order of their times. `measured_ns` is on the clock of the file. Throws
/// UserError for a file that cannot be read, has no detection, or is not in order.
std::vector<CameraSample> read_detections(const std::string& path);

}  // namespace tp100::sim
