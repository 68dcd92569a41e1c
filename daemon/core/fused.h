#pragma once
// The fused pose and how far it may be trusted, as every step publishes it.

#include <cstdint>

#include "core/pose.h"

namespace tp100 {

struct Fused {
  Pose pose{};  ///< encoders + gyro + overhead camera; without a camera, of the same filter
  Twist twist{};
  double variance_x_m2 = 0.0;  ///< diagonal of the covariance, and what all pictures share
  double variance_y_m2 = 0.0;
  double variance_yaw_rad2 = 0.0;
  double slip_left = 0.0;  ///< estimated
  double slip_right = 0.0;
  double gyro_bias_radps = 0.0;
  double nis = 0.0;       ///< normalized innovation squared of the last camera sample, 3 degrees
  double nis_mean = 0.0;  ///< over the samples since the run began that are no outliers; 3 if noise
                          ///< is as assumed
  std::uint32_t nis_count = 0;        ///< of those samples
  std::int64_t camera_age_us = -1;    ///< now - when the last used sample was taken; -1: none yet
  std::uint32_t camera_used = 0;      ///< since the run began
  std::uint32_t camera_rejected = 0;  ///< outside the gate, too old or out of order
  std::uint32_t recoveries = 0;       ///< the camera contradicted the estimate and was believed
};

}  // namespace tp100
