#pragma once
// The daemon's data of a robot besides its model: measured sizes, wiring and drive.

namespace tp100::course {

/// Measured with ruler and balance; they determine the robot's attitude on ramps and steps.
/// `emulated.body` has its own values; a robot file may be wrong about its robot.
struct ShapeValues {
  double length_m = 0.185;
  double height_m = 0.060;
  double axle_spacing_m = 0.133;
  double wheel_radius_m = 0.026;  ///< outer radius of wheel and track
  double gauge_m = 0.155;         ///< distance between track centre lines
  double com_height_m = 0.022;    ///< above the tracks' underside
  double com_forward_m = 0.0;     ///< from the middle of the axles
};

/// How the robot is wired and driven; sent to the firmware at connect.
struct DriveValues {
  double counts_per_metre = 11140.0;  ///< encoder edges per metre of track
  double max_track_mps = 0.20;
  double max_track_mps2 = 0.6;
  double feed_forward = 4.0;  ///< duty per (m/s) above the dead band
  double dead_band = 0.15;    ///< duty at which a track just moves
  double speed_kp = 4.0;      ///< duty per (m/s)
  double speed_ki = 30.0;     ///< duty per m
  double yaw_kp = 4.0;        ///< (rad/s) per rad
  double max_yaw_radps = 1.2;
  double battery_cutoff_v = 6.0;
  double stall_duty = 0.6;
  double stall_s = 1.0;
  bool invert_left_motor = false, invert_right_motor = false;
  bool invert_left_encoder = false, invert_right_encoder = false;
  bool swap_tracks = false;
};

}  // namespace tp100::course
