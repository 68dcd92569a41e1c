#pragma once
// A visit to the robot on a port: who it is, how it is, how good its link is. Nothing moves.

#include <atomic>
#include <string>

#include "doctor/robot.h"
#include "link/session.h"
#include "link/transport.h"

namespace tp100::doctor {

struct VisitOptions {
  std::string port;
  link::PortOptions serial{};
  link::SessionSettings session{};
  double battery_cutoff_v = 0.0;
  double link_test_s = 1.0;  ///< 0: no link test
};

/// Opening the port resets a Mega; a silent one is heard for 5 s. Throws nothing: what goes wrong
/// is in the visit.
doctor::Visit visit_robot(const VisitOptions& options, const std::atomic<bool>& stop);

}  // namespace tp100::doctor
