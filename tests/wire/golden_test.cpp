#include "golden.h"

#include <gtest/gtest.h>

#include <set>

#include "all_messages.h"
#include "support/paths.h"

namespace tp100::golden {
namespace {

std::vector<Line> golden_lines() { return read_lines(source_path("tests/wire/golden_frames.txt")); }

TEST(GoldenFrames, CodeAndDecodeAsCommitted) {
  for (const Line& line : golden_lines()) EXPECT_EQ(check(line), "");
}

TEST(GoldenFrames, CoverEveryMessageOnce) {
  std::multiset<std::string> names;
  for (const Line& line : golden_lines()) names.insert(line.name);
  std::size_t messages = 0;
  wire::for_each_message([&](const char* name, auto) {
    EXPECT_EQ(names.count(name), 1u) << name;
    ++messages;
  });
  EXPECT_EQ(names.size(), messages);
}

}  // namespace
}  // namespace tp100::golden
