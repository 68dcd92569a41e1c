#pragma once
// What this machine does to a loop that must not be late, to the page and to recordings.

#include <cstdint>
#include <string>
#include <vector>

#include "doctor/finding.h"
#include "doctor/system.h"
#include "loop/real_time.h"

namespace tp100::doctor {

/// The privileges that were asked for. Name: real-time.
Findings real_time_findings(const std::vector<loop::Grant>& grants);

/// Name: clock-source.
Findings clock_source_findings(const System& system);

/// Of all processors. Name: governor.
Findings governor_findings(const System& system);

/// Does another program listen on the page's TCP port? Name: page-port.
Findings page_port_findings(const System& system, std::uint16_t port);

/// The folder that recordings go to, as it was tried.
struct Disk {
  std::string folder;
  double written_mb_per_s = 0.0;  ///< a file written and forced to the disk
  double free_mb = 0.0;
  std::string error;  ///< why it could not be written; empty: it could
};

/// Name: disk.
Findings disk_findings(const Disk& disk);

}  // namespace tp100::doctor
