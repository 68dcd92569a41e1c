#pragma once
// A turn on the spot: yaw as a trapezoid in time.

#include "control/parameters.h"
#include "course/path.h"

namespace tp100::control {

/// The desired yaw of one turn. No allocation; safe in the real-time thread.
class Pivot {
 public:
  /// Never faster than `most_radps`.
  void begin(const course::Piece& piece, double most_radps);
  /// One step; never faster than what still stops at the end.
  void update(const Parameters& parameters, double dt_s);

  double yaw_rad() const { return yaw_rad_; }
  double rate_radps() const { return rate_radps_; }
  bool arrived() const { return arrived_; }

 private:
  double end_rad_ = 0.0;
  double most_radps_ = 0.0;
  double yaw_rad_ = 0.0;
  double rate_radps_ = 0.0;
  bool arrived_ = false;
};

}  // namespace tp100::control
