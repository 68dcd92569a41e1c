#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tp100::test {

/// The value below which `share` (0..1) of them lie; -1 if there is none. Sorts them.
inline double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return -1.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace tp100::test
