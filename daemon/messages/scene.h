#pragma once
// The course and the robot as a scene for 3-D viewers.

#include <string>

#include "messages/messages.h"

namespace tp100::messages {

/// The whole scene (foxglove.SceneUpdate), which replaces the one before.
std::string scene_text(const Messages& messages, HostNs at);

}  // namespace tp100::messages
