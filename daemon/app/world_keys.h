#pragma once
// The keys of the configuration's [world].

#include <span>

#include "app/world_settings.h"
#include "bridge/parameters.h"
#include "course/key.h"

namespace tp100::app {

std::span<const course::Key<bridge::WorldParameters>> world_keys();
std::span<const course::Key<WorldSettings>> world_stream_keys();

}  // namespace tp100::app
