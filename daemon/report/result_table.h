#pragma once
// The result of a run for people, beside what the paper printed.

#include <string>

#include "report/metrics.h"

namespace tp100::report {

/// Several lines, at most 100 columns, with notes on what is the paper's and what is ours.
std::string result_table(const RunResult& run, const RunFigures& figures);

}  // namespace tp100::report
