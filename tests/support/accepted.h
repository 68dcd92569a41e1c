#pragma once
// Files of the sources that this build writes and a person reviews.

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "support/paths.h"
#include "support/temporary_folder.h"

namespace tp100::test {

/// Expects that the file at `path` in the sources holds `text`; under `scripts/test --accept`,
/// writes it first.
inline void expect_accepted(const std::string& path, const std::string& text) {
  const std::string whole = source_path(path);
  if (std::getenv("TP100_ACCEPT") != nullptr) write_bytes(whole, text);
  EXPECT_EQ(read_bytes(whole), text)
      << path
      << " is not what the program writes; run scripts/test --accept and review the difference";
}

}  // namespace tp100::test
