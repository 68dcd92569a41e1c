#pragma once
// `tp100d ports --hello DEV`: which firmware a board runs.

#include <string>

#include "wire/messages.h"

namespace tp100::doctor {

struct HelloOptions {
  std::string port;
  double timeout_s = 10.0;  ///< includes one or two seconds of the bootloader
};

/// Content of a hello.
struct HelloReply {
  bool ours = false;  ///< protocol and schema are this program's
  std::string text;   ///< one line: board, firmware, protocol and, if not ours, what to do
};
/// `hello`: of any version, as link::read_hello() returns it. Pure.
HelloReply reply_of(const wire::Hello& hello);

/// Opens the port, which resets a Mega, sends nothing and prints the first hello. Returns 0 if its
/// firmware is for this program, 1 for another one or without a hello. Throws UserError.
int run_hello(const HelloOptions& options);

// Whether a silent board has nothing but the Mega's bootloader in its flash.

/// Opens the port at the bootloader's speed and requests its sign-on (STK500v2) for up to
/// `limit_s`. Writes to the port: only for a port that sent nothing by itself. Throws UserError.
bool bootloader_answers(const std::string& port, double limit_s);

}  // namespace tp100::doctor
