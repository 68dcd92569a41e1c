#pragma once
// Silence for libraries that print on standard error whatever one asks of them (libpng, libjpeg):
// the program says what is wrong in one line of its own.

namespace tp100::camera {

/// Standard error goes nowhere while one lives. For one thread.
class Quiet {
 public:
  Quiet();
  ~Quiet();
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  int kept_ = -1;
};

}  // namespace tp100::camera
