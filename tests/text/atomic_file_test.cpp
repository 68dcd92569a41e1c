// Files that are replaced at once: with their mode and owner, through links, and never one that is
// read.

#include "text/atomic_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <vector>

#include "../support/as_nobody.h"
#include "../support/temporary_folder.h"
#include "support/refusal.h"
#include "text/temporary.h"

namespace {
bool g_can_exchange = true;
}  // namespace

// In the place of the C library's.
extern "C" int renameat2(int from_folder, const char* from, int to_folder, const char* to,
                         unsigned flags) noexcept {
  if (g_can_exchange)
    return static_cast<int>(::syscall(SYS_renameat2, from_folder, from, to_folder, to, flags));
  errno = EINVAL;
  return -1;
}

namespace tp100::text {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class AtomicFile : public testing::Test {
 protected:
  static std::string read(const fs::path& path) { return test::read_bytes(path.string()); }
  static std::string error_of(const std::string& path, std::string_view content) {
    return test::refusal([&] { write_file(path, content); });
  }
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_.path()), {}); }

  test::TemporaryFolder folder_;
};

TEST_F(AtomicFile, WritesAndReplacesWithoutLeavingAnythingElseAndSaysWhen) {
  const std::string path = folder_.file("out.csv");
  EXPECT_EQ(written_unix_s(path), 0);
  for (const char* content : {"first", "2"}) {
    write_file(path, content);
    EXPECT_EQ(read(path), content);
  }
  EXPECT_EQ(files(), 1);
  const timespec times[2] = {{.tv_sec = 1, .tv_nsec = 0}, {.tv_sec = 1780236300, .tv_nsec = 0}};
  ASSERT_EQ(::utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
  EXPECT_EQ(written_unix_s(path), 1780236300);
  // It is as readable as any other new file.
  const std::string other = folder_.file("other");
  std::ofstream(other) << "x";
  EXPECT_EQ(fs::status(path).permissions(), fs::status(other).permissions());
}

TEST_F(AtomicFile, SaysWhyAPathCannotBeWritten) {
  EXPECT_THAT(error_of((folder_.path() / "none" / "out").string(), "x"),
              HasSubstr("none/out: cannot be written (No such file"));
  EXPECT_THAT(error_of(folder_.path().string(), "x"), HasSubstr("(Is a directory)"));
  EXPECT_THAT(error_of("/dev/full", "x"), HasSubstr("No space left on device"));
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(AtomicFile, AFolderForResultsIsMadeWithThoseAboveIt) {
  make_folder(folder_.file("new/and/newer"));
  make_folder(folder_.file("new/and/newer"));
  EXPECT_TRUE(fs::is_directory(folder_.file("new/and/newer")));
  write_file(folder_.file("file"), "in the way");
  EXPECT_THROW(make_folder(folder_.file("file/folder")), UserError);
}

// A configuration with a password, readable by its owner only, would be readable by all once a
// viewer has saved a parameter.
TEST_F(AtomicFile, AReplacedFileKeepsItsModeAndItsOwner) {
  const std::string path = folder_.file("config.toml");
  for (const mode_t mode : {0600U, 0640U, 0664U, 0444U}) {
    write_file(path, "old");
    ASSERT_EQ(::chmod(path.c_str(), mode), 0);
    if (::geteuid() == 0) {
      ASSERT_EQ(::chown(path.c_str(), test::AsNobody::kNobody, test::AsNobody::kNobody), 0);
    }
    struct stat before {
    }, after{};
    ASSERT_EQ(::stat(path.c_str(), &before), 0);
    for (const bool edits : {false, true}) {
      edits ? edit_file(path, "edited") : write_file(path, "new");
      for (const std::string& file : {path, edits ? kept_path(path) : path}) {
        ASSERT_EQ(::stat(file.c_str(), &after), 0);
        EXPECT_EQ(after.st_mode, before.st_mode) << file;
        EXPECT_EQ(after.st_uid, before.st_uid) << file;
        EXPECT_EQ(after.st_gid, before.st_gid) << file;
      }
    }
    fs::remove(path);
  }
}

TEST_F(AtomicFile, AFileOfAnotherAccountIsReplacedToo) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become another account; run it as root";
  const std::string path = folder_.file("out");
  write_file(path, "of root");
  ASSERT_EQ(::chmod(folder_.path().c_str(), 0777), 0);
  const test::AsNobody nobody;
  write_file(path, "mine");
  EXPECT_EQ(read(path), "mine");
}

TEST_F(AtomicFile, AnEditedFileIsKeptAndComesBackAlsoWhereTheDiskCannotExchangeFiles) {
  for (const bool can_exchange : {true, false}) {
    g_can_exchange = can_exchange;
    const std::string path = folder_.file(can_exchange ? "a" : "b"), kept = kept_path(path);
    EXPECT_EQ(kept, path + ".bak");
    edit_file(path, "1");
    EXPECT_FALSE(fs::exists(kept)) << "there was nothing to keep";
    for (const char* content : {"2", "3"}) edit_file(path, content);
    EXPECT_EQ(read(path) + read(kept), "32");
    for (const char* restored : {"23", "32"}) {
      restore_file(path);
      EXPECT_EQ(read(path) + read(kept), restored);
    }
  }
  g_can_exchange = true;
  EXPECT_EQ(files(), 4);
}

TEST_F(AtomicFile, AFileBehindALinkIsKeptBesideItself) {
  fs::create_directory(folder_.path() / "elsewhere");
  const std::string real = folder_.file("elsewhere/real"), link = folder_.file("link");
  write_file(real, "old");
  fs::create_symlink(real, link);
  edit_file(link, "new");
  EXPECT_EQ(kept_path(link), real + ".bak");
  EXPECT_EQ(read(real) + read(kept_path(link)), "newold");
  restore_file(link);
  EXPECT_EQ(read(real) + read(kept_path(link)), "oldnew");
  EXPECT_TRUE(fs::is_symlink(link));
}

// Whoever can place a link as FILE.bak would have another file overwritten.
TEST_F(AtomicFile, WhereTheKeptFileBelongsNothingElseIsOverwritten) {
  const std::string path = folder_.file("file"), other = folder_.file("other");
  write_file(path, "old");
  write_file(other, "precious");
  fs::create_symlink(other, kept_path(path));
  EXPECT_THROW(edit_file(path, "new"), UserError);
  EXPECT_THROW(restore_file(path), UserError);
  EXPECT_EQ(read(path) + read(other), "oldprecious");
  EXPECT_TRUE(fs::is_symlink(kept_path(path)));
}

// A recording, or the measurements of an afternoon, would be gone.
TEST_F(AtomicFile, AFileThatIsReadIsNotWrittenOver) {
  const std::string path = folder_.file("run.mcap"), link = folder_.file("link"),
                    hard = folder_.file("hard");
  std::ofstream(path) << "precious";
  fs::create_symlink("run.mcap", link);
  fs::create_hard_link(path, hard);
  note_read(path);
  const fs::path before = fs::current_path();
  for (const std::string& name :
       {path, link, hard, folder_.path().string() + "/./run.mcap", std::string("run.mcap")}) {
    fs::current_path(folder_.path());
    EXPECT_THAT(error_of(name, "x"), HasSubstr(name + ": this file is read")) << name;
    EXPECT_THROW(FileReplacement{name}, UserError) << name;
    fs::current_path(before);
  }
  EXPECT_EQ(read(path), "precious");
  EXPECT_EQ(files(), 3);
  EXPECT_EQ(error_of(folder_.file("other"), "x"), "");
  edit_file(path, "edited");
  EXPECT_EQ(read(path) + read(kept_path(path)), "editedprecious") << "nothing is lost by an edit";
  // A program may write its own file again.
  write_file(folder_.file("other"), "1");
  note_read(folder_.file("other"));
  EXPECT_EQ(error_of(folder_.file("other"), "2"), "");
}

// What killed programs leave would fill the disk, and a user's file must not be taken for it.
TEST_F(AtomicFile, WhatAKilledProgramLeftIsSweptAndNothingElse) {
  std::string file, folder;
  const int writes_file = make_temporary_file(folder_.path().string(), file);
  const int writes_folder = make_temporary_folder(folder_.path().string(), folder);
  std::ofstream(folder + "/page.html") << "x";
  const std::vector<std::string> kept = {".tp100-notes1.txt", ".tp100-abc",    "robot.backup",
                                         "tp100-abcdef",      ".tp100-ab.def", "run.toml.abcdef"};
  for (const std::string& name : kept) std::ofstream(folder_.file(name)) << "x";
  fs::create_symlink("robot.backup", folder_.path() / ".tp100-ablink");
  sweep_temporary(folder_.path().string());
  EXPECT_TRUE(fs::exists(file) && fs::exists(folder)) << "a program writes them";
  // As the kernel does for a program that is killed.
  ::close(writes_file);
  ::close(writes_folder);
  sweep_temporary(folder_.path().string());
  EXPECT_EQ(files(), static_cast<std::ptrdiff_t>(kept.size()) + 1);
  EXPECT_FALSE(fs::exists(file) || fs::exists(folder));
  sweep_temporary(folder_.file("none"));
}

}  // namespace
}  // namespace tp100::text
