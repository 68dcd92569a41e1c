#pragma once
// A result file that is there completely or not at all.

#include <string>
#include <string_view>

#include "core/error.h"

namespace tp100::analysis {

/// Replaces `path` with `content`: written under a temporary name beside it, then renamed. On
/// failure (no such folder, no permission, disk full) the old file stays and nothing else is left
/// behind. What is no ordinary file (a pipe, /dev/stdout) is written directly. Throws SetupError.
void write_file(const std::string& path, std::string_view content);

}  // namespace tp100::analysis
