#pragma once
// The exception for mistakes of a user, a file or a viewer. The real-time loop never throws it and
// returns results instead.

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tp100 {

/// A bad file, option or port. what() is one line: what, where (file:line:column for files), what
/// to do. Programs print it and exit with status 2.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `text` on one line, for a message: control characters and bytes outside ASCII replaced by '?',
/// cut at `most` characters.
std::string one_line(std::string_view text, std::size_t most = 80);

}  // namespace tp100
