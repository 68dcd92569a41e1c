#pragma once
// The keys of the configuration's [world].

#include <span>

#include "bridge/parameters.h"
#include "config/world_settings.h"
#include "text/key.h"

namespace tp100::config {

std::span<const text::Key<bridge::WorldParameters>> world_keys();
std::span<const text::Key<WorldSettings>> world_stream_keys();

}  // namespace tp100::config
