#pragma once
// The terrain tables of a course file.

#include "course/terrain.h"
#include "text/toml_document.h"

namespace tp100::course {

/// Reads [[ramp]], [[block]] and [[surface]] of a course file. Throws SetupError.
Terrain terrain_of(text::TomlTable& root);

}  // namespace tp100::course
