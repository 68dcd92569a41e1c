#pragma once
// The keys of the configuration that fill bridge::Parameters, except those of [world]. The file has
// them in the sections where a user expects them: see for_each_section in configuration.cpp.

#include <span>

#include "bridge/parameters.h"
#include "text/key.h"

namespace tp100::config {

std::span<const text::Key<bridge::Parameters>> setup_keys();
std::span<const text::Key<bridge::Parameters>> model_keys();
std::span<const text::Key<model::TrackParameters>> track_keys();
std::span<const text::Key<bridge::Parameters>> steering_keys();
std::span<const text::Key<estimation::Parameters>> estimation_keys();
std::span<const text::Key<estimation::CameraParameters>> camera_keys();
std::span<const text::Key<control::Parameters>> control_keys();
std::span<const text::Key<bridge::Parameters>> bridge_keys();

}  // namespace tp100::config
