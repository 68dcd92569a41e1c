#pragma once
// `tp100d ports --hello DEV`: which firmware a board runs.

#include <cstddef>
#include <cstdint>
#include <string>

namespace tp100::doctor {

struct HelloOptions {
  std::string port;
  double timeout_s = 10.0;  ///< a bootloader takes one or two of them
};

/// What a hello says.
struct Greeting {
  bool ours = false;  ///< protocol and schema are this program's
  std::string text;   ///< one line: board, firmware, protocol and, if not ours, what to do
};
/// Reads the payload of a hello of any version; an empty text if it is too short for one. Pure.
Greeting read_greeting(const std::uint8_t* payload, std::size_t size);

/// Opens the port, which resets a Mega, sends nothing and prints the first hello. 0: a firmware for
/// this program; 1: another one, or none. Throws SetupError.
int run_hello(const HelloOptions& options);

}  // namespace tp100::doctor
