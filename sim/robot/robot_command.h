#pragma once
// tp100-sim robot: the emulated robot on a pseudo-terminal, in real time.

#include <string>
#include <vector>

#include "sim/robot/options.h"

namespace tp100::sim {

struct RobotCommand {
  Options options{};
  std::string link;    ///< symbolic link to the port; empty: print the device only
  bool blank = false;  ///< no firmware on the avr board yet, only its bootloader
  std::string camera;  ///< overhead camera, bundled name or file; empty: none, or `overhead` with
                       ///< camera_to
  std::string camera_to;              ///< "udp:[HOST:]PORT"; empty: kCameraPort of this machine
  std::vector<std::string> faults{};  ///< NAME[:NUMBER][:WORD][@T[+D]]
  std::string stats;   ///< file for figures of the run, written at its end; empty: none
  std::string course;  ///< start pose and shoves come from it; empty: origin
};

/// Runs until SIGINT or SIGTERM. Returns the exit status. Throws SetupError.
int run_robot(const RobotCommand& command);

}  // namespace tp100::sim
