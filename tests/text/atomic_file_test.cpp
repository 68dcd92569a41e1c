#include "text/atomic_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "../support/temporary_folder.h"

namespace tp100::text {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class AtomicFile : public testing::Test {
 protected:
  static std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  static std::string error_of(const std::string& path, std::string_view content) {
    try {
      write_file(path, content);
    } catch (const SetupError& error) {
      return error.what();
    }
    return {};
  }
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_.path()), {}); }

  test::TemporaryFolder folder_;
};

TEST_F(AtomicFile, WritesAndReplacesWithoutLeavingAnythingElse) {
  const fs::path path = folder_.path() / "out.csv";
  write_file(path.string(), "first");
  EXPECT_EQ(read(path), "first");
  write_file(path.string(), "2");
  EXPECT_EQ(read(path), "2");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, TellsWhenAFileWasWritten) {
  const std::string path = folder_.file("out.csv");
  EXPECT_EQ(written_unix_s(path), 0);
  write_file(path, "x");
  const timespec times[2] = {{.tv_sec = 1, .tv_nsec = 0}, {.tv_sec = 1780236300, .tv_nsec = 0}};
  ASSERT_EQ(::utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
  EXPECT_EQ(written_unix_s(path), 1780236300);
}

TEST_F(AtomicFile, IsAsReadableAsAnyOtherNewFile) {
  const fs::path ours = folder_.path() / "ours", other = folder_.path() / "other";
  write_file(ours.string(), "x");
  std::ofstream(other) << "x";
  EXPECT_EQ(fs::status(ours).permissions(), fs::status(other).permissions());
}

TEST_F(AtomicFile, ALinkStaysALink) {
  std::ofstream(folder_.path() / "real") << "old";
  fs::create_symlink("real", folder_.path() / "link");
  write_file(folder_.file("link"), "new");
  EXPECT_TRUE(fs::is_symlink(folder_.path() / "link"));
  EXPECT_EQ(read(folder_.path() / "real"), "new");
}

TEST_F(AtomicFile, SaysWhyAPathCannotBeWritten) {
  EXPECT_THAT(error_of((folder_.path() / "none" / "out").string(), "x"),
              HasSubstr("none/out: cannot be written (No such file"));
  EXPECT_THAT(error_of(folder_.path().string(), "x"), HasSubstr("(Is a directory)"));
  EXPECT_THAT(error_of("", "x"), HasSubstr("cannot be written"));
}

TEST_F(AtomicFile, AFullDeviceIsReportedAndStaysADevice) {
  EXPECT_THAT(error_of("/dev/full", "x"), HasSubstr("No space left on device"));
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(AtomicFile, AFileThatCannotGrowIsReportedAndTheOldOneStays) {
  const fs::path path = folder_.path() / "out";
  write_file(path.string(), "old");
  // The limit applies to a process, so a child process runs into it.
  const auto write_beyond_a_limit = [&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit = {1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    const std::string line = error_of(path.string(), std::string(100000, 'x'));
    std::_Exit(line.find("File too large") != std::string::npos ? 0 : 1);
  };
  EXPECT_EXIT(write_beyond_a_limit(), testing::ExitedWithCode(0), "");
  EXPECT_EQ(read(path), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, AFolderForResultsIsMadeWithThoseAboveIt) {
  make_folder(folder_.file("new/and/newer"));
  make_folder(folder_.file("new/and/newer"));
  EXPECT_TRUE(fs::is_directory(folder_.file("new/and/newer")));
  write_file(folder_.file("file"), "in the way");
  EXPECT_THROW(make_folder(folder_.file("file/folder")), SetupError);
}

}  // namespace
}  // namespace tp100::text
