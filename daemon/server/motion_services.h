#pragma once
// The services of motion: runs, driving by hand, and where the robot is. All but STOP.

#include <vector>

#include "server/controls.h"
#include "server/publisher.h"
#include "server/service.h"

namespace tp100::server {

/// Both must outlive the rows; who does what is told as an event.
std::vector<ServiceRow> motion_services(Controls& controls, Publisher& publisher);

}  // namespace tp100::server
