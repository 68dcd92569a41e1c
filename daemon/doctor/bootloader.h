#pragma once
// Is a silent board one whose flash is empty but for the Mega's bootloader?

#include <string>

namespace tp100::doctor {

/// Opens the port at the bootloader's speed and asks for its sign-on (STK500v2) for up to
/// `limit_s`. Writes to the port: only for one that said nothing of its own. Throws SetupError.
bool bootloader_answers(const std::string& port, double limit_s);

}  // namespace tp100::doctor
