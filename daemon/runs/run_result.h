#pragma once
// How a recorded run went, for lists of runs: kept as result.toml beside the recording.

#include <optional>
#include <string>

#include "core/run_summary.h"

namespace tp100::runs {

inline constexpr const char* kRunResultFile = "result.toml";

struct RunResult {
  std::string outcome{};  ///< "completed", "stopped", "aborted", "ended"; empty: nothing was driven
  std::string cause{};    ///< of an abort, one line
  std::string course{}, robot{};
  double duration_s = 0.0;
  double distance_m = 0.0;  ///< along the path
  double largest_m = 0.0;   ///< largest distance from the path
  bool by_hand = false;
};

RunResult result_of(const RunSummary& summary, std::string course, std::string robot);
/// Nothing: it is no such file.
std::optional<RunResult> parse_run_result(const std::string& text);
/// A file that parse_run_result() reads back.
std::string write_run_result(const RunResult& result);

}  // namespace tp100::runs
