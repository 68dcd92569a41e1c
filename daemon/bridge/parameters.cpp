#include "bridge/parameters.h"

namespace tp100::bridge {

model::TrackParameters track_parameters(const course::ModelValues& values) {
  return {.slip_left = values.slip_left,
          .slip_right = values.slip_right,
          .slip_angle_straight_rad = values.slip_angle_straight_rad,
          .slip_angle_turning_rad = values.slip_angle_turning_rad,
          .turning_threshold_radps = values.turning_threshold_radps,
          .wheelbase_m = values.wheelbase_m,
          .x_icr_m = values.x_icr_m};
}

model::TrackParameters paper_parameters(const course::ModelValues& values) {
  return {.turning_threshold_radps = values.turning_threshold_radps};
}

}  // namespace tp100::bridge
