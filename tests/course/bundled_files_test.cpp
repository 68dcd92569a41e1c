#include "course/bundled_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "../support/temporary_folder.h"

namespace tp100::course {
namespace {

class BundledFiles : public ::testing::Test {
 protected:
  static std::string failure(Bundled folder, const std::string& name) {
    try {
      read_bundled(folder, name);
    } catch (const SetupError& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
};

TEST_F(BundledFiles, ReadsAFileWholeWithEveryByte) {
  const std::string text("a\r\n\0b\xff", 6);
  std::ofstream(folder_.path() / "x.toml", std::ios::binary) << text;
  const TextFile file = read_text_file(folder_.file("x.toml"));
  EXPECT_EQ(file.text, text);
  EXPECT_EQ(file_stem(file.path), "x");
}

TEST_F(BundledFiles, NamesAMissingFileInOneLine) {
  const std::string message = failure(Bundled::kCourses, folder_.file("none.toml"));
  EXPECT_THAT(message, ::testing::HasSubstr("none.toml: cannot be opened (No such file"));
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST_F(BundledFiles, RefusesADirectory) {
  EXPECT_THAT(failure(Bundled::kRobots, folder_.path().string() + "/"),
              ::testing::HasSubstr("is a directory"));
}

TEST_F(BundledFiles, AnUnknownNameListsWhatThereIs) {
  EXPECT_THAT(failure(Bundled::kCourses, "no-such-course"),
              ::testing::HasSubstr("no-such-course: no such course; give a file or one of"));
  EXPECT_THAT(failure(Bundled::kRobots, "wron"),
              ::testing::HasSubstr("wron: no such robot; did you mean 'worn'?; give a file or"));
}

TEST_F(BundledFiles, FindsTheDataOfRealRobots) {
  for (const char* name : {"/maxxii-indoor.csv", "/husky-windows.csv", "/README.md"})
    EXPECT_FALSE(read_text_file(real_data_directory() + name).text.empty()) << name;
}

}  // namespace
}  // namespace tp100::course
