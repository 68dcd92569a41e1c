#pragma once
// `tp100d ports --hello DEV`: which firmware a board runs.

#include <cstddef>
#include <cstdint>
#include <string>

namespace tp100::doctor {

struct HelloOptions {
  std::string port;
  double timeout_s = 10.0;  ///< a bootloader takes one or two seconds of it
};

/// Content of a hello.
struct HelloReply {
  bool ours = false;  ///< protocol and schema are this program's
  std::string text;   ///< one line: board, firmware, protocol and, if not ours, what to do
};
/// Decodes the payload of a hello of any version; an empty text if it is too short. Pure.
HelloReply read_hello(const std::uint8_t* payload, std::size_t size);

/// Opens the port, which resets a Mega, sends nothing and prints the first hello. 0: firmware for
/// this program; 1: another one, or no hello. Throws SetupError.
int run_hello(const HelloOptions& options);

// Whether a silent board has nothing but the Mega's bootloader in its flash.

/// Opens the port at the bootloader's speed and requests its sign-on (STK500v2) for up to
/// `limit_s`. Writes to the port: only for a port that sent nothing by itself. Throws SetupError.
bool bootloader_answers(const std::string& port, double limit_s);

}  // namespace tp100::doctor
