#pragma once
// What viewers may do with recorded runs.

#include <vector>

#include "runs/run_archive.h"
#include "server/service.h"

namespace tp100::live {

/// run_note, run_delete, run_report, run_compare and run_identify. `runs` must outlive the rows.
std::vector<server::ServiceRow> run_services(runs::RunArchive& runs);

}  // namespace tp100::live
