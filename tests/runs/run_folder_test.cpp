#include "runs/run_folder.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>

#include "../support/temporary_folder.h"
#include "record/recording_file.h"
#include "runs/run_zip.h"
#include "support/refusal.h"

namespace tp100::runs {
namespace {

namespace fs = std::filesystem;
using test::refusal;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class RunFolder : public ::testing::Test {
 protected:
  RunFolder() { fs::create_directory(runs_); }

  void write(const std::string& path, const std::string& text) const {
    fs::create_directories(fs::path(file(path)).parent_path());
    test::write_bytes(file(path), text);
  }
  /// A run of that many bytes, recorded at that time.
  void run(const std::string& name, std::uint64_t bytes, int at_s) const {
    write(name + "/run.mcap", "");
    fs::resize_file(file(name + "/run.mcap"), bytes);
    const timeval time{.tv_sec = 1'700'000'000 + at_s, .tv_usec = 0};
    const timeval times[2] = {time, time};
    ::utimes(file(name + "/run.mcap").c_str(), times);
  }
  std::string file(const std::string& path) const { return runs_ + "/" + path; }
  bool there(const std::string& name) const { return fs::exists(file(name)); }

  test::TemporaryFolder folder_;
  const std::string runs_ = folder_.file("runs");
};

// Runs that were recorded under the name of their course, before names were made harmless, would
// be neither listed nor counted by the quota, and fill the disk.
TEST_F(RunFolder, ARunOfAnyNameIsManagedAsOthersAre) {
  const std::vector<std::string> names = {"20260101-000000-slalom (copy)", "Prüf strecke",
                                          "a'b\"c <i>", std::string(245, 'x')};
  for (const std::string& name : names) run(name, 100, 1);
  ASSERT_EQ(list_runs(runs_).size(), names.size());
  for (const std::string& name : names) {
    EXPECT_EQ(change_note(runs_, name, {.name = "n"}).name, "n");
    EXPECT_EQ(change_note(runs_, name, {.name = ""}).name, "");
    EXPECT_EQ(files_of(runs_, name), std::vector<std::string>{"run.mcap"});
    std::uint64_t bytes = 0;
    EXPECT_TRUE(open_run_file(runs_, name, "run.mcap", bytes));
    EXPECT_EQ(bytes, 100U);
    EXPECT_GT(RunZip(runs_, name).size(), 100U);
  }
  delete_run(runs_, names.front());
  EXPECT_EQ(free_space(runs_, 150).deleted.size(), names.size() - 2);
  EXPECT_EQ(list_runs(runs_).size(), 1U);
}

TEST_F(RunFolder, AFolderForARunIsOneThatIsFound) {
  for (const std::string& course :
       {std::string("1-straight"), std::string("slalom (copy)"), std::string("Prüf strecke"),
        std::string("道路"), std::string(245, 'x'), std::string("../../x"), std::string("..."),
        std::string("a\nb"), std::string("\xff")}) {
    const std::size_t before = list_runs(runs_).size();
    for (int i = 0; i < 3; ++i)
      write(fs::path(make_run_folder(runs_, course, 0)).filename().string() + "/run.mcap", "0");
    EXPECT_EQ(list_runs(runs_).size(), before + 3) << course;
  }
  EXPECT_TRUE(there(fs::path(make_run_folder(runs_, "Prüf strecke", 0)).filename().string()));
  EXPECT_THAT(make_run_folder(runs_, "Öl", 1), ::testing::EndsWith("-Oel"));
}

TEST_F(RunFolder, ListsRunsByTheTimeOfTheirRecordingAndNoLinksNoHiddenAndNoLooseFiles) {
  run("a", 10, 1);
  run("b", 20, 3);
  run("c", 30, 2);
  write("a/report.html", "made later");
  write("../secret/run.mcap", "secret");
  fs::create_symlink(folder_.path() / "secret/run.mcap", file("c/link.csv"));
  fs::create_directory_symlink(folder_.path() / "secret", file("linked"));
  write(".hidden/run.mcap", "");
  write("loose", "");
  ASSERT_EQ(::mkfifo(file("c/pipe.csv").c_str(), 0600), 0);
  const auto runs = list_runs(runs_);
  std::vector<std::string> names;
  for (const auto& each : runs) names.push_back(each.folder);
  ASSERT_THAT(names, ElementsAre("b", "c", "a"));
  EXPECT_EQ(runs[1].files.size(), 1U);
  EXPECT_EQ(runs[1].bytes, 30U);
  EXPECT_TRUE(list_runs("").empty());
  EXPECT_TRUE(list_runs(folder_.file("none")).empty());
}

TEST_F(RunFolder, ANoteIsKeptBesideTheRunUntilItIsEmpty) {
  run("a", 10, 1);
  change_note(runs_, "a", {.name = "Wet floor", .tags = "wet"});
  EXPECT_EQ(change_note(runs_, "a", {.note = "slipped"}).name, "Wet floor");
  const auto noted = list_runs(runs_).at(0);
  EXPECT_EQ(noted.note.name, "Wet floor");
  EXPECT_EQ(noted.note.note, "slipped");
  EXPECT_TRUE(noted.has_note);
  change_note(runs_, "a", {.name = "", .note = "", .tags = ""});
  EXPECT_FALSE(list_runs(runs_).at(0).has_note);
  EXPECT_FALSE(there("a/run.toml"));
}

TEST_F(RunFolder, ANoteThatCannotBeReadIsSaidAndCanBeReplacedUnlessItIsALink) {
  run("a", 10, 1);
  for (const std::string& text :
       {std::string("nmae = 1"), std::string(100'000, '#'), std::string("\0\xff", 2)}) {
    write("a/run.toml", text);
    const auto found = list_runs(runs_).at(0);
    EXPECT_TRUE(found.has_note);
    EXPECT_THAT(found.note_error, HasSubstr("run.toml"));
  }
  change_note(runs_, "a", {.name = "good"});
  EXPECT_EQ(list_runs(runs_).at(0).note_error, "");
  fs::remove(file("a/run.toml"));
  write("../secret", "name = \"secret\"\n");
  fs::create_symlink(folder_.path() / "secret", file("a/run.toml"));
  EXPECT_EQ(list_runs(runs_).at(0).note.name, "");
  EXPECT_THAT(refusal([&] { change_note(runs_, "a", {.name = "mine"}); }), HasSubstr("not a file"));
  EXPECT_EQ(test::read_bytes(folder_.file("secret")), "name = \"secret\"\n");
}

TEST_F(RunFolder, HostileNamesOfRunsAreRefused) {
  using namespace std::string_literals;
  run("a", 10, 1);
  write("../outside/run.mcap", "x");
  fs::create_directory_symlink(folder_.path() / "outside", file("linked"));
  for (const std::string& name :
       {""s, "."s, ".."s, "../outside"s, "a/../../outside"s, "/etc"s, "a\0b"s, "a/"s, "a\n"s,
        "linked"s, "gr\xC3\xBCn"s, "\xff"s, "a b"s, std::string(5000, 'x'), "none"s}) {
    EXPECT_THAT(refusal([&] { delete_run(runs_, name); }), HasSubstr("no such run")) << name;
    EXPECT_THAT(refusal([&] { change_note(runs_, name, {.name = "x"}); }), HasSubstr("no such run"))
        << name;
  }
  EXPECT_TRUE(fs::exists(folder_.path() / "outside/run.mcap"));
  EXPECT_FALSE(fs::exists(folder_.path() / "outside/run.toml"));
  EXPECT_TRUE(there("a/run.mcap"));
}

TEST_F(RunFolder, ARunIsDeletedWithItsFilesAndNotWhatALinkInItNames) {
  run("a", 10, 1);
  write("a/report.html", "x");
  write("a/run.toml", "keep = true\n");
  write("../secret", "x");
  fs::create_symlink(folder_.path() / "secret", file("a/link.csv"));
  delete_run(runs_, "a");
  EXPECT_FALSE(there("a"));
  EXPECT_TRUE(fs::exists(folder_.path() / "secret"));
  // A deletion that was interrupted leaves an empty folder, which can be deleted.
  fs::create_directory(file("empty"));
  delete_run(runs_, "empty");
  EXPECT_FALSE(there("empty"));
}

TEST_F(RunFolder, NothingOfARunIsDeletedThatIsOpen) {
  run("a", 10, 1);
  {
    const record::UsedFile used(file("a/run.mcap"));
    EXPECT_THAT(refusal([&] { delete_run(runs_, "a"); }), HasSubstr("is open"));
  }
  {
    const record::RecordingFile recorded(file("b.mcap"));
    fs::create_directory(file("b"));
    fs::rename(file("b.mcap"), file("b/run.mcap"));
    EXPECT_THAT(refusal([&] { delete_run(runs_, "b"); }), HasSubstr("is open"));
  }
  EXPECT_TRUE(there("a/run.mcap") && there("b/run.mcap"));
  delete_run(runs_, "a");
  delete_run(runs_, "b");
  EXPECT_TRUE(list_runs(runs_).empty());
}

TEST_F(RunFolder, WhatMayBeSomethingElseIsNotDeleted) {
  write("photos/cat.svg", "x");
  EXPECT_THAT(refusal([&] { delete_run(runs_, "photos"); }), HasSubstr("has no run.mcap"));
  run("a", 10, 1);
  write("a/bag/data.mcap", "x");
  EXPECT_THAT(refusal([&] { delete_run(runs_, "a"); }), HasSubstr("folder in it, bag"));
  write("pipe/x", "");
  ASSERT_EQ(::mkfifo(file("pipe/run.mcap").c_str(), 0600), 0);
  EXPECT_THAT(refusal([&] { delete_run(runs_, "pipe"); }), HasSubstr("has no run.mcap"));
  EXPECT_TRUE(there("photos/cat.svg") && there("a/run.mcap") && there("a/bag/data.mcap"));
}

// With any content of the folder: no kept run is lost, and the rest fits or the reason is reported.
TEST_F(RunFolder, RoomIsMadeAmongRandomRuns) {
  std::mt19937 random(7);
  const auto up_to = [&](unsigned most) { return static_cast<unsigned>(random() % (most + 1U)); };
  for (int round = 0; round < 60; ++round) {
    fs::remove_all(runs_);
    fs::create_directory(runs_);
    std::map<std::string, std::unique_ptr<record::UsedFile>> open;
    std::set<std::string> kept;
    std::map<std::string, std::uint64_t> deletable;
    const unsigned count = up_to(12);
    for (unsigned i = 0; i < count; ++i) {
      const std::string name = "run-" + std::to_string(i);
      const std::uint64_t bytes = up_to(1000);
      run(name, bytes, static_cast<int>(up_to(5)));
      switch (up_to(6)) {
        case 0:
          open[name] = std::make_unique<record::UsedFile>(file(name + "/run.mcap"));
          break;
        case 1:
          change_note(runs_, name, {.keep = true});
          kept.insert(name);
          break;
        case 2:
          write(name + "/run.toml", "corrupted");
          kept.insert(name);
          break;
        case 3:
          fs::remove(file(name + "/run.mcap"));
          write(name + "/other", std::string(bytes, 'x'));
          kept.insert(name);
          break;
        default:
          deletable[name] = bytes;
      }
    }
    const auto before = list_runs(runs_);
    const std::uint64_t quota = up_to(4000);
    const FreedSpace freed = free_space(runs_, quota);
    for (const auto& [name, used] : open) EXPECT_TRUE(there(name)) << name;
    for (const std::string& name : kept) EXPECT_TRUE(there(name)) << name;
    std::uint64_t left = 0;
    for (const auto& each : list_runs(runs_)) left += each.bytes;
    EXPECT_EQ(left, freed.bytes);
    EXPECT_EQ(freed.why_not.empty(), left <= quota);
    // Only the oldest deletable runs are deleted, and no more than necessary.
    std::vector<std::string> oldest;
    for (const auto& each : before)
      if (deletable.contains(each.folder)) oldest.insert(oldest.begin(), each.folder);
    ASSERT_LE(freed.deleted.size(), oldest.size());
    oldest.resize(freed.deleted.size());
    EXPECT_EQ(freed.deleted, oldest);
    if (!freed.deleted.empty()) {
      EXPECT_GT(left + deletable[freed.deleted.back()], quota);
    }
    if (left > quota) {
      EXPECT_EQ(freed.deleted.size(), deletable.size());
    }
  }
}

}  // namespace
}  // namespace tp100::runs
