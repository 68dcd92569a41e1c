#include "course/bundled_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <tuple>

#include "../support/temporary_folder.h"

namespace tp100::course {
namespace {

class BundledFiles : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

TEST_F(BundledFiles, ReadsAFileWholeWithEveryByte) {
  const std::string text("a\r\n\0b\xff", 6);
  std::ofstream(folder_.path() / "x.toml", std::ios::binary) << text;
  const TextFile file = read_text_file(folder_.file("x.toml"));
  EXPECT_EQ(file.text, text);
  EXPECT_EQ(file_stem(file.path), "x");
}

TEST_F(BundledFiles, WhatIsNoFileIsNamedInOneLine) {
  for (const auto& [folder, name, error] :
       {std::tuple(Bundled::kCourses, folder_.file("none.toml"),
                   "none.toml: cannot be opened (No such file"),
        {Bundled::kRobots, folder_.path().string() + "/", "is a directory"},
        {Bundled::kCourses, "no-such-course",
         "no-such-course: no such course; give a file or one of"},
        {Bundled::kRobots, "wron", "wron: no such robot; did you mean 'worn'?; give a file or"}}) {
    try {
      read_bundled(folder, name);
      ADD_FAILURE() << name;
    } catch (const SetupError& refused) {
      EXPECT_THAT(refused.what(), ::testing::HasSubstr(error));
      EXPECT_THAT(refused.what(), ::testing::Not(::testing::HasSubstr("\n")));
    }
  }
}

TEST_F(BundledFiles, FindsTheDataOfRealRobots) {
  for (const char* name : {"/maxxii-indoor.csv", "/husky-windows.csv", "/README.md"})
    EXPECT_FALSE(read_text_file(real_data_directory() + name).text.empty()) << name;
}

}  // namespace
}  // namespace tp100::course
