#pragma once
// The result of a run as one JSON object.

#include <string>

#include "report/metrics.h"

namespace tp100::report {

/// One line without line break. Keys in fixed order; doubles are the shortest text that reads back
/// the same, so that equal runs print equal text. `cause` appears only in a run that was not
/// completed, `fused` only in one with an overhead camera; a shove that was never recovered from is
/// null.
std::string result_json(const RunResult& run, const RunFigures& figures);

}  // namespace tp100::report
