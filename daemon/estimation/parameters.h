#pragma once
// Settings of the estimators.

namespace tp100::estimation {

struct Parameters {
  double still_s = 0.5;  ///< both belts at rest for this long before the gyro bias is taken
  double still_gyro_sd_radps = 0.01;  ///< gyro noise above this is not rest
  double bias_time_s = 2.0;           ///< time constant of the bias while at rest
};

}  // namespace tp100::estimation
