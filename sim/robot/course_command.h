#pragma once
// tp100-sim course: a course in lockstep, in virtual time.

#include <string>
#include <vector>

#include "sim/robot/options.h"

namespace tp100::sim {

struct CourseCommand {
  Options options{};
  std::string course;
  std::string camera;                 ///< overhead camera: bundled name or file; empty: none
  std::string world;                  ///< external: udp:[HOST:]PORT; empty: as configured
  std::vector<std::string> faults{};  ///< NAME[:NUMBER][:WORD][@T[+D]]
  int runs = 1;
  std::string record;  ///< folder for recordings; empty: none
  std::string out;     ///< folder for results; empty: none
  bool json = false;
};

/// Runs, prints tables or JSON lines. Returns 0 if every run was completed, else 1. Throws
/// SetupError.
int run_course(const CourseCommand& command);

}  // namespace tp100::sim
