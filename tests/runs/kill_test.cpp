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
#include "core/error.h"
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
using ::testing::AnyOf;
using Files = std::map<std::string, std::string>;

constexpr const char* kCourse =
    "speed_mps = 0.1\n[[segment]]\ntype = \"line\"\nlength_m = 0.3\n"
    "[fence]\nmin_x_m = -1.0\nmax_x_m = 1.0\nmin_y_m = -1.0\nmax_y_m = 1.0\n";

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

  test::TemporaryFolder folder_;
};

TEST_F(Kill, AResultIsTheOldOneOrTheNewOne) {
  const std::string large(200'000, 'x');
  const int moments = test::at_each_kill(
      [&] {
        write({{"out", "old"}});
      },
      [&] { text::write_file(file("out"), large); },
      [&] {
        EXPECT_THAT(found(), AnyOf(Files{{"out", "old"}}, Files{{"out", large}}));
      });
  EXPECT_GT(moments, 8);
}

// Of the three texts, only the one that the edit is to drop may be gone.
TEST_F(Kill, AnEditLosesNeitherTheOldFileNorTheNewOne) {
  const Files before = {{"c", "old"}, {"c.bak", "older"}}, after = {{"c", "new"}, {"c.bak", "old"}};
  const Files between = {{"c", "old"}, {"c.bak", "new"}};
  test::at_each_kill([&] { write(before); }, [&] { text::edit_file(file("c"), "new"); },
                     [&] { EXPECT_THAT(found(), AnyOf(before, between, after)); });
  EXPECT_EQ(found(), after);
}

TEST_F(Kill, ARestoredFileIsExchangedAtOnce) {
  const Files before = {{"c", "1"}, {"c.bak", "2"}}, after = {{"c", "2"}, {"c.bak", "1"}};
  test::at_each_kill([&] { write(before); }, [&] { text::restore_file(file("c")); },
                     [&] { EXPECT_THAT(found(), AnyOf(before, after)); });
  EXPECT_EQ(found(), after);
}

#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
// A disk that fails or is full at any moment must neither end the daemon nor cost a file.
TEST_F(Kill, AnErrorOfTheDiskLosesNothing) {
  const std::string folder = folder_.path().string(), next = std::string(kCourse) + "# 2\n";
  const config::SetupFiles files(folder, {});
  const Files before = {{"c", "old"},        {"c.bak", "older"},
                        {"a/run.mcap", "0"}, {"a/run.toml", "name = \"old\"\n"},
                        {"b/run.mcap", "1"}, {"courses/a.toml", kCourse}};
  const auto with = [&](Files changed) {
    changed.insert(before.begin(), before.end());
    return changed;
  };
  struct Change {
    std::function<void()> make;
    std::vector<Files> results;
  };
  write(before);
  change_note(folder, "a", {.name = "new"});
  const std::string noted = found()["a/run.toml"];
  Files deleted = before;
  deleted.erase("b/run.mcap");
  const std::vector<Change> changes = {
      {[&] { text::write_file(file("c"), "new"); }, {with({{"c", "new"}})}},
      {[&] { text::edit_file(file("c"), "new"); },
       {with({{"c.bak", "new"}}), with({{"c", "new"}, {"c.bak", "old"}})}},
      {[&] { text::restore_file(file("c")); }, {with({{"c", "older"}, {"c.bak", "old"}})}},
      {[&] { files.save(course::Bundled::kCourses, "a", next, true); },
       {with({{"courses/a.toml.bak", next}}),
        with({{"courses/a.toml", next}, {"courses/a.toml.bak", kCourse}})}},
      {[&] { change_note(folder, "a", {.name = "new"}); }, {with({{"a/run.toml", noted}})}},
      {[&] { delete_run(folder, "b"); }, {deleted}},
      {[&] { list_runs(folder); }, {}},
      {[&] { free_space(folder, 1'000'000); }, {}},
      {[&] { RunZip(folder, "a").size(); }, {}},
      {[&] { sweep_runs(folder); }, {}}};
  for (const int error : {EIO, ENOSPC, EACCES, ENOMEM})
    for (const Change& change : changes) {
      std::vector<Files> allowed = change.results;
      allowed.push_back(before);
      test::at_each_error(
          error, [&] { write(before); }, change.make,
          [&] { EXPECT_THAT(allowed, ::testing::Contains(found())); });
      EXPECT_EQ(found(), change.results.empty() ? before : change.results.back());
    }
}
#endif

TEST_F(Kill, ASavedCourseIsTheOldOneOrTheNewOne) {
  const std::string old = kCourse, next = old + "# 2\n";
  const Files before = {{"courses/a.toml", old}};
  const Files after = {{"courses/a.toml", next}, {"courses/a.toml.bak", old}};
  const Files between = {{"courses/a.toml", old}, {"courses/a.toml.bak", next}};
  const config::SetupFiles files(folder_.path().string(), {});
  test::at_each_kill([&] { write(before); },
                     [&] { files.save(course::Bundled::kCourses, "a", next, true); },
                     [&] { EXPECT_THAT(found(), AnyOf(before, between, after)); });
  EXPECT_EQ(found(), after);
  test::at_each_kill([&] { write({}); },
                     [&] { files.save(course::Bundled::kCourses, "a", next, false); },
                     [&] {
                       EXPECT_THAT(found(), AnyOf(Files{}, Files{{"courses/a.toml", next}}));
                     });
}

TEST_F(Kill, ANoteIsTheOldOneOrTheNewOne) {
  const Files before = {{"a/run.mcap", "0"}, {"a/run.toml", "name = \"old\"\n"}};
  write(before);
  change_note(folder_.path().string(), "a", {.name = "new"});
  const Files after = found();
  ASSERT_NE(after, before);
  test::at_each_kill([&] { write(before); },
                     [&] { change_note(folder_.path().string(), "a", {.name = "new"}); },
                     [&] { EXPECT_THAT(found(), AnyOf(before, after)); });
  EXPECT_EQ(found(), after);
  const Files without = {{"a/run.mcap", "0"}};
  test::at_each_kill([&] { write(before); },
                     [&] { change_note(folder_.path().string(), "a", {.name = ""}); },
                     [&] { EXPECT_THAT(found(), AnyOf(before, without)); });
  EXPECT_EQ(found(), without);
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
    bool channel(const record::McapChannel&) override { return true; }
    bool message(const record::McapMessage&) override {
      ++messages;
      return true;
    }
    int messages = 0;
  };
  constexpr int kChunks = 4;
  const auto record_run = [&] {
    record::RecordingFile to(file("run.mcap"));
    record::McapWriter writer(to, "test", record::McapCompression::kZstd);
    const auto channel = writer.add_channel(0, "/a", "json");
    for (int i = 0; i < kChunks; ++i) {
      const std::array<std::uint8_t, 2> data = {'{', '}'};
      writer.message(channel, static_cast<std::uint64_t>(i), data);
      writer.end_chunk();
    }
    writer.finish();
  };
  int before = 0, whole = 0;
  test::at_each_kill(
      [&] {
        write({{"none", ""}});
      },
      record_run,
      [&] {
        if (found()["run.mcap"].size() < 8) return;  // nothing is recorded yet
        Counter counter;
        // A file that is read is not written again.
        fs::copy_file(file("run.mcap"), file("copy.mcap"));
        whole += record::McapReader(file("copy.mcap")).stream(counter).whole ? 1 : 0;
        EXPECT_GE(counter.messages, before) << "a later kill leaves more";
        before = counter.messages;
      });
  EXPECT_EQ(before, kChunks);
  EXPECT_GE(whole, 1);
}

}  // namespace
}  // namespace tp100::runs
