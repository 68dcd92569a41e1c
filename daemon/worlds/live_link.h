#pragma once
// Poses for Unreal's Live Link, as JSON over UDP. Centimetres and Unreal's quaternion, always.

#include <cstdint>
#include <string>
#include <string_view>

#include "core/pose.h"

namespace tp100::worlds {

enum class LiveLinkDialect {
  kBones,      ///< {SUBJECT: [{Name: "root", Parent: -1, Location, Rotation, Scale}]}
  kTransform,  ///< {SUBJECT: {Location, Rotation, Scale}}
};

/// One datagram. `subject` is the name that Live Link shows.
std::string encode_live_link(std::string_view subject, const Pose& pose, LiveLinkDialect dialect);

}  // namespace tp100::worlds
