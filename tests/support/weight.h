#pragma once
// Resources that a process holds.

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace tp100::test {

struct Weight {
  long resident_kib = 0;
  std::size_t descriptors = 0, threads = 0;
};

inline std::size_t entries(const std::string& folder) {
  const std::filesystem::directory_iterator all(folder);
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

/// Resources of the process with this number, or of "self".
inline Weight weigh(const std::string& pid) {
  const std::string proc = "/proc/" + pid;
  long size = 0, resident = 0;
  std::ifstream(proc + "/statm") >> size >> resident;
  return {resident * 4, entries(proc + "/fd"), entries(proc + "/task")};
}

}  // namespace tp100::test
