#pragma once
// Settings of the estimators.

#include "core/arithmetic.h"

namespace tp100::estimation {

/// Noise that the pose filter assumes. Densities are per root of the quantity with which they grow:
/// time, distance or turned angle.
struct FilterParameters {
  double start_sd_m = 0.005;  ///< how accurately a robot is placed on the start
  double start_sd_rad = 1.0 * kRadPerDeg;
  double gyro_sd_rad_rts = 4e-4;  ///< gyro noise, discretization included
  double gyro_scale_sd = 0.004;   ///< scale error left after calibration
  double gyro_scale_s = 1.0;      ///< ... which counts as constant for this long
  double bias_sd_radps = 0.05;    ///< turn-on bias
  double bias_walk_radps_rts = 1e-5;
  double bias_per_degc_sd = 0.001;  ///< change of the bias with temperature: a third of 20 deg/s
                                    ///< from -40 to 85 degC (MPU6050 data sheet rev 3.4, 6.1)
  // The next five are scaled by the innovations of a camera.
  double along_sd_m_rtm = 0.0015;  ///< distance, per root metre
  double across_sd_m_rtm = 0.0015;
  double obstacle_sd_m_rtm = 0.03;    ///< distance while climbing a block, where tracks slip at one
                                      ///< end
  double turn_sd_m_rtrad = 0.0007;    ///< shift of the reference point by turning, per root radian
  double slip_sd = 0.01;              ///< common slip beside what is expected
  double slip_s = 2.0;                ///< time constant of its return to 0
  double wheelbase_sd = 0.007;        ///< relative error of an identified wheelbase that nothing
                                      ///< corrects
  double residual_window_s = 2.0;     ///< tracks and gyro are compared over this long
  double residual_sd_radps = 1.5e-4;  ///< of yaw rate by tracks against gyro, driving straight
  double edge_m = 0.0;  ///< an encoder's edge; the tracks' distances are multiples of it
  double track_error_radps = 0.03;     ///< error of the yaw rate by tracks without a gyro
  double track_error_share = 0.15;     ///< ... and per yaw rate
  double disturbance_radps = 0.5;      ///< tracks against gyro above this: the robot is turned from
                                       ///< outside
  double disturbance_window_s = 0.05;  ///< ... over this long
  double disturbance_sd_m = 0.015;     ///< added to the place by each such window
  /// ... and to the yaw: a push usually also rotates the robot.
  double disturbance_sd_rad = 0.25 * kRadPerDeg;
  double disturbed_sd_m = 0.05;  ///< added to the pose where samples were missing, and after a
                                 ///< camera contradicted it
  double disturbed_sd_rad = 15.0 * kRadPerDeg;
};

/// What the filter assumes of the overhead camera. It looks straight down.
struct CameraParameters {
  double position_sd_m = 0.0015;  ///< from image to image
  double constant_sd_m = 0.0015;  ///< common to all images of a run: averaging does not remove it
  double yaw_sd_rad = 0.4 * kRadPerDeg;
  double time_sd_s = 0.001;  ///< of the time stamps
  double height_m = 2.5;     ///< of the lens above the floor
  double offset_x_m = 0.0;   ///< of the lens from the middle of the course's fence
  double offset_y_m = 0.0;
  double marker_height_m = 0.06;  ///< above the reference point of the upright robot
};

struct Parameters {
  double still_s = 0.5;  ///< both tracks at standstill for this long before the gyro bias is taken
  double still_gyro_sd_radps = 0.01;  ///< with more gyro noise the robot does not stand still
  double bias_time_s = 2.0;           ///< time constant of the bias at standstill
  FilterParameters filter{};
  CameraParameters camera{};
};

}  // namespace tp100::estimation
