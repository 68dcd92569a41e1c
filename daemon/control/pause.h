#pragma once
// A pause of a run on its course: the robot stands still on the path, armed.

#include <algorithm>

namespace tp100::control {

/// No allocation; safe in the real-time thread.
class Pause {
 public:
  /// A longer pause ends the run. [s]
  static constexpr double kLongestS = 120.0;

  /// A run begins.
  void restart() { *this = Pause{}; }
  void begin() {
    if (!active()) left_s_ = kLongestS;
  }
  void end() { left_s_ = 0.0; }
  /// One step. True: the pause has lasted too long and is over, as the run must be.
  bool update(double dt_s) {
    if (!active()) return false;
    left_s_ = std::max(0.0, left_s_ - dt_s);
    total_s_ += dt_s;
    return !active();
  }

  bool active() const { return left_s_ > 0.0; }
  /// Until it is too long; 0 without a pause.
  double left_s() const { return left_s_; }
  /// Of all pauses of the run.
  double total_s() const { return total_s_; }

 private:
  double left_s_ = 0.0;
  double total_s_ = 0.0;
};

}  // namespace tp100::control
