#pragma once
// A program that runs beside this one.

#include <sys/types.h>

#include <string>
#include <vector>

namespace tp100::sim {

/// Terminated and waited for when it goes out of scope.
class Child {
 public:
  /// Starts arguments[0]. `quiet`: its standard output goes nowhere. Throws SetupError.
  Child(const std::vector<std::string>& arguments, bool quiet);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Waits for the end; returns the exit status, 128 + signal if it was killed.
  int wait();
  /// Asks it to end (SIGTERM), and waits.
  void stop();
  /// True while it runs.
  bool running();

 private:
  pid_t pid_ = -1;
  int status_ = 0;
};

}  // namespace tp100::sim
