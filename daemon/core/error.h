#pragma once
// The exception for mistakes of a user, a file or a viewer. The real-time loop never throws it and
// returns results instead.

#include <stdexcept>
#include <string>

namespace tp100 {

/// A bad file, option or port. what() is one line: what, where (file:line:column for files), what
/// to do. Programs print it and exit with status 2.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tp100
