#pragma once
// `tp100d report` and `tp100d compare`: recordings as pages, figures and numbers.

#include <string>
#include <vector>

namespace tp100::app {

struct ReportOptions {
  std::vector<std::string> runs;  ///< recordings or their folders
  std::string out;                ///< folder; empty: beside the recording. Only for one run
};

/// Writes report.html, metrics.json and a .svg for each figure. Throws SetupError.
int run_report(const ReportOptions& options);

struct CompareOptions {
  std::vector<std::string> runs;  ///< two to twenty
  std::string out = ".";          ///< folder, made if need be
};

/// Writes compare.html, compare.json (the metrics of each run) and a .svg for each figure. Throws
/// SetupError.
int run_compare(const CompareOptions& options);

}  // namespace tp100::app
