#pragma once
// `tp100d doctor`: what keeps the robot from driving, and the one line that mends it.

#include <string>

namespace tp100::app {

struct DoctorOptions {
  std::string config;
  std::string robot;         ///< empty: as configured
  std::string port;          ///< empty: as configured
  double link_test_s = 1.0;  ///< 0: no link test
  bool wheels_up = false;    ///< then the guided test of the tracks
  bool json = false;
};

/// The command. 0: nothing keeps the robot from driving; 1: something does. Throws SetupError.
int run_doctor(const DoctorOptions& options);

}  // namespace tp100::app
