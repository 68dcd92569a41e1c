// The folder of the recorded runs: what is listed, deleted for room, and never touched; and the
// notes of a person in it.

#include "runs/run_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "../support/temporary_folder.h"
#include "record/recording_file.h"
#include "runs/run_note.h"
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
       {std::string("1-straight"), std::string("Prüf strecke"), std::string(245, 'x'),
        std::string("../../x"), std::string("\xff")}) {
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

TEST_F(RunFolder, ANoteIsKeptUntilItIsEmptyAndReplacedIfItCannotBeReadUnlessItIsALink) {
  run("a", 10, 1);
  for (const std::string& text :
       {std::string("nmae = 1"), std::string(100'000, '#'), std::string("\0\xff", 2)}) {
    write("a/run.toml", text);
    const auto found = list_runs(runs_).at(0);
    EXPECT_TRUE(found.has_note);
    EXPECT_THAT(found.note_error, HasSubstr("run.toml"));
  }
  change_note(runs_, "a", {.name = "good", .tags = "wet"});
  EXPECT_EQ(change_note(runs_, "a", {.note = "slipped"}).name, "good");
  EXPECT_EQ(list_runs(runs_).at(0).note_error, "");
  EXPECT_EQ(list_runs(runs_).at(0).note.note, "slipped");
  change_note(runs_, "a", {.name = "", .note = "", .tags = ""});
  EXPECT_FALSE(list_runs(runs_).at(0).has_note);
  EXPECT_FALSE(there("a/run.toml"));
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
    std::vector<std::unique_ptr<record::UsedFile>> open;
    std::set<std::string> kept;
    for (unsigned i = up_to(12); i > 0; --i) {
      const std::string name = "run-" + std::to_string(i), recording = file(name + "/run.mcap");
      run(name, up_to(1000), static_cast<int>(up_to(5)));
      const unsigned kind = up_to(6);
      if (kind == 0) open.push_back(std::make_unique<record::UsedFile>(recording));
      if (kind == 1) change_note(runs_, name, {.keep = true});
      if (kind == 2) write(name + "/run.toml", "corrupted");
      if (kind == 3) fs::rename(recording, file(name + "/other"));
      if (kind <= 3) kept.insert(name);
    }
    // From the oldest on.
    std::vector<std::string> deletable;
    std::map<std::string, std::uint64_t> bytes;
    for (const auto& each : list_runs(runs_)) {
      if (!kept.contains(each.folder)) deletable.insert(deletable.begin(), each.folder);
      bytes[each.folder] = each.bytes;
    }
    const std::uint64_t quota = up_to(4000);
    const FreedSpace freed = free_space(runs_, quota);
    for (const std::string& name : kept) EXPECT_TRUE(there(name)) << name;
    std::uint64_t left = 0;
    for (const auto& each : list_runs(runs_)) left += each.bytes;
    EXPECT_EQ(left, freed.bytes);
    EXPECT_EQ(freed.why_not.empty(), left <= quota);
    // No more is deleted than necessary.
    ASSERT_LE(freed.deleted.size(), deletable.size());
    EXPECT_TRUE(freed.deleted.size() == deletable.size() || left <= quota);
    EXPECT_TRUE(freed.deleted.empty() || left + bytes[freed.deleted.back()] > quota);
    deletable.resize(freed.deleted.size());
    EXPECT_EQ(freed.deleted, deletable);
  }
}

TEST(RunNote, IsReadAsItWasWrittenAndKeepsWhatAChangeDoesNotName) {
  const RunNote note{.name = "Wet \"floor\" \\ \xE2\x9C\x93",
                     .note = "first line\nsecond = \"line\"\t# no comment",
                     .tags = "wet lab",
                     .keep = true};
  const RunNote again = parse_run_note(write_run_note(note), "run.toml");
  EXPECT_EQ(again.note, note.note);
  EXPECT_TRUE(again.keep);
  const RunNote now = changed(again, {.note = "", .keep = false});
  EXPECT_EQ(now.name, note.name);
  EXPECT_EQ(now.note, "");
  EXPECT_EQ(now.tags, "wet lab");
  EXPECT_FALSE(now.keep);
  EXPECT_TRUE(changed(now, {.name = "", .tags = ""}).empty());
}

// A mark that is lost is a moment that nobody finds again.
TEST(RunNote, MarksAreAddedAndReadInTheirOrder) {
  RunNote note = changed({}, {.mark = Mark{.t_s = 12.3456, .text = "slips  here"}});
  note = changed(note, {.name = "n", .mark = Mark{.t_s = -1.0, .text = "7"}});
  EXPECT_EQ(why_not(note), "");
  const std::vector<Mark> marks = marks_of(parse_run_note(write_run_note(note), "run.toml"));
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[0].t_s, 12.346);
  EXPECT_EQ(marks[0].text, "slips  here");
  EXPECT_EQ(marks[1].t_s, -1.0);
  EXPECT_EQ(marks[1].text, "7");
  EXPECT_TRUE(marks_of({.marks = "later\n\n12\n"}).empty());
}

TEST(RunNote, TakesNoControlCharactersNoForeignBytesAndNoEndlessText) {
  using namespace std::string_literals;
  for (const std::string& bad : {"a\0b"s, "a\nb"s, "\x1b[31m"s, "\x7f"s, "\xff"s, "\xc0\x80"s,
                                 "\xed\xa0\x80"s, std::string(kMaxRunName + 1, 'x')}) {
    EXPECT_THAT(why_not({.name = bad}), HasSubstr("name takes"));
    EXPECT_THAT(why_not({.tags = bad.size() > kMaxRunName ? std::string(kMaxTags + 1, 'x') : bad}),
                HasSubstr("tags takes"));
  }
  EXPECT_EQ(why_not({.note = "two\nlines\tand a tab"}), "");
  EXPECT_THAT(why_not({.note = "a\0b"s}), HasSubstr("note takes"));
  EXPECT_THAT(why_not({.note = std::string(kMaxNote + 1, 'x')}), HasSubstr("note takes"));
  EXPECT_EQ(why_not({.name = std::string(kMaxRunName, 'x')}), "");
}

}  // namespace
}  // namespace tp100::runs
