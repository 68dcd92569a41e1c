// Every file that is changed is there whole, old or new, whenever the program is killed or the disk
// fails.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "../support/each_kill.h"
#include "../support/temporary_folder.h"
#include "config/setup_files.h"
#include "record/mcap_reader.h"
#include "record/mcap_writer.h"
#include "record/recording_file.h"
#include "runs/run_folder.h"
#include "runs/run_zip.h"
#include "text/atomic_file.h"
#include "text/temporary.h"

namespace tp100::runs {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

constexpr const char* kCourse =
    "speed_mps = 0.1\n[[segment]]\ntype = \"line\"\nlength_m = 0.3\n"
    "[fence]\nmin_x_m = -1.0\nmax_x_m = 1.0\nmin_y_m = -1.0\nmax_y_m = 1.0\n";

const Files kBefore = {{"c", "old"},        {"c.bak", "older"},
                       {"a/run.mcap", "0"}, {"a/run.toml", "name = \"old\"\n"},
                       {"b/run.mcap", "1"}, {"courses/a.toml", kCourse}};

/// A change of kBefore, and what may be there after an interruption besides kBefore; the last of
/// these is what is there after none. Of the texts of an edit, only the one that it is to drop may
/// be gone in between.
struct Change {
  const char* name;
  std::function<void()> make;
  std::vector<Files> results;
};

/// kBefore with these files, or without them if `gone`.
Files with(Files changed, bool gone = false) {
  Files files = kBefore;
  for (const auto& [name, text] : changed) {
    files.erase(name);
    if (!gone) files[name] = text;
  }
  return files;
}

/// A kill at any moment must leave each file whole, the old one or the new one, and nothing else
/// after the next start.
class Kill : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return folder_.file(name); }
  void write(const Files& files) const {
    fs::remove_all(folder_.path());
    fs::create_directory(folder_.path());
    for (const auto& [name, content] : files) {
      fs::create_directories(fs::path(file(name)).parent_path());
      test::write_bytes(file(name), content);
    }
  }
  /// What the next start of the program finds.
  Files found() const {
    sweep_runs(folder_.path().string());
    Files files;
    for (const auto& each : fs::recursive_directory_iterator(folder_.path()))
      if (each.is_regular_file())
        files[fs::relative(each.path(), folder_.path()).string()] =
            test::read_bytes(each.path().string());
    return files;
  }
  void expect_old_or_new(const Change& change) const {
    std::vector<Files> allowed = change.results;
    allowed.push_back(kBefore);
    EXPECT_THAT(allowed, ::testing::Contains(found()));
  }
  std::vector<Change> changes() const {
    const std::string folder = folder_.path().string();
    const std::string next = std::string(kCourse) + "# 2\n";
    const auto save = [=, files = config::SetupFiles(folder, {})](const char* name, bool replace) {
      files.save(course::Bundled::kCourses, name, next, replace);
    };
    write(kBefore);
    change_note(folder, "a", {.name = "new"});
    const std::string noted = found()["a/run.toml"];
    EXPECT_NE(noted, kBefore.at("a/run.toml"));
    const std::string c = file("c");
    return {
        {"a file is written", [=] { text::write_file(c, "new"); }, {with({{"c", "new"}})}},
        {"a file is edited",
         [=] { text::edit_file(c, "new"); },
         {with({{"c.bak", "new"}}), with({{"c", "new"}, {"c.bak", "old"}})}},
        {"a file is restored",
         [=] { text::restore_file(c); },
         {with({{"c", "older"}, {"c.bak", "old"}})}},
        {"a course is saved",
         [=] { save("a", true); },
         {with({{"courses/a.toml.bak", next}}),
          with({{"courses/a.toml", next}, {"courses/a.toml.bak", kCourse}})}},
        {"a course is added", [=] { save("b", false); }, {with({{"courses/b.toml", next}})}},
        {"a note is changed",
         [=] { change_note(folder, "a", {.name = "new"}); },
         {with({{"a/run.toml", noted}})}},
        {"a note is removed",
         [=] { change_note(folder, "a", {.name = ""}); },
         {with({{"a/run.toml", ""}}, true)}},
        {"a run is deleted", [=] { delete_run(folder, "b"); }, {with({{"b/run.mcap", ""}}, true)}}};
  }

  test::TemporaryFolder folder_;
};

#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
// A disk that fails or is full at any moment must neither end the daemon nor cost a file.
TEST_F(Kill, AnErrorOfTheDiskLosesNothing) {
  const std::string folder = folder_.path().string();
  std::vector<Change> all = changes();
  all.push_back({"runs are listed", [&] { list_runs(folder); }, {}});
  all.push_back({"space is made", [&] { free_space(folder, 1'000'000); }, {}});
  all.push_back({"a run is packed", [&] { RunZip(folder, "a").size(); }, {}});
  all.push_back({"remains are swept", [&] { sweep_runs(folder); }, {}});
  for (const int error : {EIO, ENOSPC, EACCES, ENOMEM})
    for (Change& change : all) {
      SCOPED_TRACE(change.name);
      if (change.results.empty()) change.results = {kBefore};
      test::at_each_error(
          error, [&] { write(kBefore); }, change.make, [&] { expect_old_or_new(change); });
      EXPECT_EQ(found(), change.results.back());
    }
}
#endif

TEST_F(Kill, AtAnyMomentEachFileIsTheOldOneOrTheNewOne) {
  for (const Change& change : changes()) {
    SCOPED_TRACE(change.name);
    const int moments = test::at_each_kill([&] { write(kBefore); }, change.make,
                                           [&] { expect_old_or_new(change); });
    EXPECT_GT(moments, 1);
    EXPECT_EQ(found(), change.results.back());
  }
}

// What a person wanted to delete would stay, and nothing but a shell could delete it.
TEST_F(Kill, ADeletionCanBeRepeated) {
  const Files before = {
      {"a/report.html", "1"}, {"a/run.mcap", "0"}, {"a/run.toml", "keep = true\n"}};
  const std::string folder = folder_.path().string();
  test::at_each_kill([&] { write(before); }, [&] { delete_run(folder, "a"); },
                     [&] {
                       found();
                       if (!fs::exists(file("a"))) return;
                       delete_run(folder, "a");
                       EXPECT_FALSE(fs::exists(file("a")));
                     });
}

// Chunks that were written are read again, whatever was being written: also the index at the end.
TEST_F(Kill, ARecordingIsReadUpToItsLastChunk) {
  struct Counter : record::McapHandler {
    bool message(const record::McapMessage&) override { return ++messages; }
    int messages = 0;
  };
  constexpr int kChunks = 4;
  const auto record_run = [&] {
    record::RecordingFile to(file("run.mcap"));
    record::McapWriter writer(to, "test", record::McapCompression::kZstd);
    const auto channel = writer.add_channel(0, "/a", "json");
    for (std::uint64_t i = 0; i < kChunks; ++i) {
      writer.message(channel, i, std::array<std::uint8_t, 2>{'{', '}'});
      writer.end_chunk();
    }
    writer.finish();
  };
  int before = 0;
  bool whole = false;
  test::at_each_kill([&] { write({}); }, record_run,
                     [&] {
                       const Files files = found();
                       // Otherwise nothing is recorded yet.
                       if (!files.contains("run.mcap") || files.at("run.mcap").size() < 8) return;
                       Counter counter;
                       // A file that is read is not written again.
                       fs::copy_file(file("run.mcap"), file("copy.mcap"));
                       whole = record::McapReader(file("copy.mcap")).stream(counter).whole;
                       EXPECT_GE(counter.messages, before) << "a later kill leaves more";
                       before = counter.messages;
                     });
  EXPECT_EQ(before, kChunks);
  EXPECT_TRUE(whole);
}

}  // namespace
}  // namespace tp100::runs
