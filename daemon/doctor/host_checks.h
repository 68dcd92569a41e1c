#pragma once
// Checks of what can keep this machine from driving a robot in time.

#include <cstdint>
#include <string>
#include <vector>

#include "doctor/finding.h"
#include "doctor/system.h"
#include "loop/real_time.h"

namespace tp100::doctor {

// How this machine affects the real-time loop, the page and recordings.

/// `privileges`: those that were requested. Name: real-time.
Findings real_time_findings(const std::vector<loop::Privilege>& privileges);

/// Name: clock-source.
Findings clock_source_findings(const System& system);

/// Checks all processors. Name: governor.
Findings governor_findings(const System& system);

/// Programs that want a processor, over the last minute, against the processors. Name: load.
Findings load_findings(const System& system);

/// Whether another program listens on the page's TCP port. Name: page-port.
Findings page_port_findings(const System& system, std::uint16_t port);

/// The folder for recordings, and the result of a trial write.
struct Disk {
  std::string folder;
  double written_mb_per_s = 0.0;  ///< of a file flushed to the disk
  double free_mb = 0.0;
  std::string error;  ///< why the write failed; empty: it did not
};

/// Name: disk.
Findings disk_findings(const Disk& disk);

// Measures the write speed of a folder's disk.

/// Writes a nameless file of 16 MB into the folder, or into its nearest existing parent, flushes it
/// to the disk and drops it. Throws nothing.
doctor::Disk try_disk(const std::string& folder);

}  // namespace tp100::doctor
