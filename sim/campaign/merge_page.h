#pragma once
// The merged campaign as one offline page.

#include <string>

#include "sim/campaign/merge.h"

namespace tp100::sim {

/// `spec_text` is shown as it is. Pure.
std::string merge_page(const Merged& merged, const std::string& spec_text);

}  // namespace tp100::sim
