#pragma once
// `tp100d recover`: a whole recording out of one that was cut off or damaged.

#include <cstdint>
#include <string>

namespace tp100::app {

struct RecoverOptions {
  std::string in;   ///< file, or the folder of a run
  std::string out;  ///< empty: beside it, with -recovered before .mcap
};

/// What was saved.
struct Recovered {
  std::string path;
  std::uint64_t messages = 0;
  std::uint64_t damaged = 0;  ///< chunks and attachments left out
  std::string problem;        ///< what was wrong; empty: nothing
};

/// Writes what is whole in `in` into `out`, with indexes and statistics; `in` stays as it is.
/// Throws SetupError.
Recovered recover(const std::string& in, const std::string& out);

/// The command. 0: written, or there was nothing to do. Throws SetupError.
int run_recover(const RecoverOptions& options);

}  // namespace tp100::app
