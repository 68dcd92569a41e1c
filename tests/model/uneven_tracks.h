#pragma once
// A robot that shows the effect of every parameter of the model: none is 0, and left and right
// differ.

#include "model/track_parameters.h"

namespace tp100::model {

inline TrackParameters uneven_tracks() {
  TrackParameters tracks;
  tracks.slip_left = 0.16;
  tracks.slip_right = 0.12;
  tracks.slip_angle_straight_rad = 0.03;
  tracks.slip_angle_turning_rad = -0.05;
  tracks.wheelbase_medium_m = 0.285;
  tracks.wheelbase_tight_m = 0.295;
  tracks.wheelbase_spin_m = 0.31;
  tracks.x_icr_m = 0.02;
  tracks.x_icr_spin_shift_m = -0.03;
  tracks.turn_slip = 0.04;
  tracks.turn_loss = 0.05;
  tracks.turning_threshold_radps = 0.07;
  return tracks;
}

}  // namespace tp100::model
