#pragma once
// Whose commands the server takes; STOP is taken from everybody.

namespace tp100::config {

enum class CommandsFrom { kLocal, kAll, kNone };

}  // namespace tp100::config
