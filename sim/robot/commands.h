#pragma once
// Subcommands of tp100-sim that run the emulated robot, each in the source file of its name.

#include <string>
#include <vector>

#include "sim/robot/options.h"

namespace tp100::sim {

// tp100-sim robot: the emulated robot on a pseudo-terminal, in real time.

struct RobotCommand {
  Options options{};
  std::string link;    ///< symbolic link to the port; empty: print the device only
  bool blank = false;  ///< no firmware on the avr board yet, only its bootloader
  std::string camera;  ///< overhead camera: bundled name or file; empty: `overhead` if camera_to is
                       ///< set, else none
  std::string camera_to;              ///< "udp:[HOST:]PORT"; empty: kCameraPort of this machine
  std::vector<std::string> faults{};  ///< NAME[:NUMBER][:WORD][@T[+D]]
  std::string course;                 ///< start pose and disturbances come from it; empty: origin
  std::string ros2{};  ///< network interface for the true pose on ROS 2's topic; empty: none
};

/// Runs until SIGINT or SIGTERM. Returns the exit status. Throws UserError.
int run_robot(const RobotCommand& command);

// tp100-sim course: a course in lockstep, in virtual time.

struct CourseCommand {
  Options options{};
  std::string course;
  std::string camera;  ///< overhead camera: bundled name or file, or a file of detections of this
                       ///< drive (.tum); empty: none
  std::string world;   ///< external world: udp:[HOST:]PORT; empty: as configured
  std::vector<std::string> faults{};  ///< NAME[:NUMBER][:WORD][@T[+D]]
  int runs = 1;
  std::string record;  ///< folder for recordings; empty: none
  std::string out;     ///< folder for results; empty: none
  std::string ros2{};  ///< network interface for ROS 2's topics; empty: none
  bool json = false;
};

/// Runs, prints tables or JSON lines. Returns 0 if every run was completed, else 1. Throws
/// UserError.
int run_course(const CourseCommand& command);

// tp100-sim demo: the two real programs, one at each end of a pseudo-terminal.

struct DemoCommand {
  Options options{};
  std::string course = "1-curve";
  bool headless = false;
};

/// Drives the course in virtual time and prints the scored table. Then drives it live with
/// `tp100-sim robot` and `tp100d run`, opens the page if there is a screen, and waits until the
/// daemon ends. Headless: drives it live first. Returns 0 if the live and the scored run were
/// completed, else 1. Throws UserError.
int run_demo(const DemoCommand& command);

}  // namespace tp100::sim
