#pragma once
// Real serial ports through libserialport, which supports any baud rate. Set-up only.

#include <string>

namespace tp100::link {

/// Opens and configures `real_path` (8N1, no flow control). Returns a close-on-exec descriptor, or
/// -1 with `error` set to an errno value.
int open_serial_port(const std::string& real_path, int baud, int& error);

}  // namespace tp100::link
