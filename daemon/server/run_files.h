#pragma once
// The folder of runs: what lies there, and which of its files may be read from outside.

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace tp100::server {

/// Runs listed at most; older ones are left out.
inline constexpr std::size_t kMaxListedRuns = 500;

/// The answer to GET /api/runs, read from the disk at most once a second for the same question. One
/// thread, which may wait for the disk.
class RunList {
 public:
  /// `active`: the run that is being recorded; empty: none. An absent folder is an empty one. No
  /// path is told, only the folder's own name.
  const std::string& json(const std::string& folder, const std::string& active);

 private:
  std::string folder_, active_, json_;
  std::chrono::steady_clock::time_point read_{};
};

/// A regular file of a run, open for reading; -1: there is none that may be read. Names hold
/// letters, digits, '-', '_' and '.', no '.' first, and no link is followed. The caller closes it.
int open_run_file(const std::string& folder, std::string_view run, std::string_view file,
                  std::uint64_t& size);

/// Content type by the end of a file's name.
std::string_view content_type(std::string_view file);

}  // namespace tp100::server
