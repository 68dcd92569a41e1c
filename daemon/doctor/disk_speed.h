#pragma once
// How fast a folder's disk takes a recording.

#include <string>

#include "doctor/host.h"

namespace tp100::doctor {

/// Writes a nameless file of 16 MB into the folder, or the nearest one above it that exists, forces
/// it to the disk and drops it. Throws nothing.
doctor::Disk try_disk(const std::string& folder);

}  // namespace tp100::doctor
