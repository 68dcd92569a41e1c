#include "record/anonymous_file.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <filesystem>
#include <numeric>
#include <vector>

#include "core/error.h"
#include "support/temporary_folder.h"

namespace tp100::record {
namespace {

TEST(AnonymousFile, GivesBackWhatWasAppendedAndLeavesNothingInItsFolder) {
  const test::TemporaryFolder folder;
  AnonymousFile file(folder.path().string());
  std::vector<std::uint8_t> first(70'000), second(3);
  std::iota(first.begin(), first.end(), std::uint8_t{0});
  second = {9, 8, 7};
  ASSERT_EQ(file.append(first), 0);
  ASSERT_EQ(file.append(second), 0);
  EXPECT_EQ(file.size(), 70'003u);

  std::vector<std::uint8_t> all(70'000), end(4);
  EXPECT_EQ(file.read(0, all), 0);
  EXPECT_EQ(all, first);
  EXPECT_EQ(file.read(69'999, end), 0);
  EXPECT_EQ(end, (std::vector<std::uint8_t>{first.back(), 9, 8, 7}));
  EXPECT_EQ(file.read(70'000, end), EIO) << "one byte more than there is";
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(AnonymousFile, ThatCannotBeMadeIsAnErrorOfOneLine) {
  EXPECT_THROW(AnonymousFile("/proc/none"), SetupError);
}

}  // namespace
}  // namespace tp100::record
