// A run as a ZIP archive that other programs unpack, whatever happens to its files meanwhile.

#include "runs/run_zip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <string>

#include "../support/temporary_folder.h"
#include "core/bytes.h"
#include "record/mcap_reader.h"
#include "record/mcap_writer.h"
#include "record/recording.h"
#include "support/refusal.h"

namespace tp100::runs {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Checks an archive with another reader, Python's, and unpacks it into a folder; if there is a
// third argument, it checks the local times of the files, too, to 2 s.
constexpr const char* kUnpack =
    "import os,sys,time,zipfile; z=zipfile.ZipFile(sys.argv[1]); bad=z.testzip(); "
    "assert bad is None, bad; z.extractall(sys.argv[2]); "
    "late=[os.stat(runs + one.filename).st_mtime - time.mktime(one.date_time + (0, 0, -1)) "
    "for runs in sys.argv[3:] for one in z.infolist()]; "
    "assert all(0 <= one < 2.01 for one in late), late";

class RunZipTest : public ::testing::Test {
 protected:
  RunZipTest() { fs::create_directories(runs_ + "/a"); }

  void write(const std::string& name, const std::string& bytes) {
    test::write_bytes(runs_ + "/a/" + name, bytes);
    written_["a/" + name] = bytes;
  }
  void write_random(const std::string& name, std::size_t bytes) {
    std::string text(bytes, '\0');
    for (char& each : text) each = static_cast<char>(random_());
    write(name, text);
  }
  /// Reads the whole archive, in parts of at most `part` bytes.
  static std::string all_of(RunZip& zip, std::size_t part = 65'536) {
    std::string all, into(part, '\0');
    while (all.size() < zip.size()) {
      const auto got = zip.read(into);
      if (!got) return "cut off";
      all.append(into, 0, *got);
    }
    EXPECT_EQ(zip.read(into), 0U) << "nothing follows";
    return all;
  }
  /// Files by their name in the archive, as Python reads it. `times` has a third argument for it.
  std::map<std::string, std::string> unpacked(const std::string& zip,
                                              const std::string& times = "") const {
    const std::string file = folder_.file("run.zip"), into = folder_.file("unpacked");
    test::write_bytes(file, zip);
    fs::remove_all(into);
    const std::string command =
        std::string("python3 -I -c '") + kUnpack + "' " + file + " " + into + " " + times;
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::map<std::string, std::string> found;
    if (!fs::exists(into)) return found;
    for (const auto& each : fs::recursive_directory_iterator(into))
      if (each.is_regular_file())
        found[fs::relative(each.path(), into)] = test::read_bytes(each.path());
    return found;
  }

  test::TemporaryFolder folder_;
  const std::string runs_ = folder_.file("runs");
  std::map<std::string, std::string> written_;
  std::mt19937 random_{5};
};

TEST_F(RunZipTest, TheRecordingInItIsReadAsItIs) {
  {
    record::RecordingFile file(runs_ + "/a/run.mcap");
    record::McapWriter writer(file, "test", record::McapCompression::kZstd);
    writer.add_metadata("tp100", {{"seed", "7"}});
    writer.message(writer.add_channel(0, "/a", "json"), 1, bytes_of("{}"));
    writer.finish();
  }
  write_random("clip.bin", 70'000);
  const std::string archive = folder_.file("a (1).zip");
  RunZip zip(runs_, "a");
  test::write_bytes(archive, all_of(zip));
  record::McapHandler nobody;
  EXPECT_TRUE(record::McapReader(archive).stream(nobody, record::McapCheck::kIndexes).whole);
  EXPECT_EQ(record::Recording(archive).fact("seed"), "7");
  EXPECT_TRUE(record::is_recording(archive));
  const auto python = [&](const std::string& code) {
    return std::system(("cd " + folder_.file("") + " && python3 -I -c '" + code + "'").c_str());
  };
  ASSERT_EQ(python("import zipfile; z = zipfile.ZipFile(\"b.zip\", \"w\", zipfile.ZIP_DEFLATED); "
                   "z.write(\"runs/a/run.mcap\")"),
            0);
  EXPECT_THAT(
      test::refusal([&] { record::McapReader{folder_.file("b.zip")}; }),
      HasSubstr("b.zip: an archive without a recording, or one that is compressed; unpack"));
}

TEST_F(RunZipTest, AnotherProgramUnpacksEveryFileAsItWas) {
  for (const std::size_t bytes : {0U, 1U, 1023U, 1024U, 65'535U, 65'536U, 65'537U, 300'000U})
    write_random(std::to_string(bytes) + ".csv", bytes);
  write_random("run.mcap", 1'000'000);
  write("zz.txt", "");
  for (const std::size_t part : {1024U, 65'536U}) {
    RunZip zip(runs_, "a");
    const std::string all = all_of(zip, part);
    EXPECT_EQ(all.size(), zip.size());
    EXPECT_TRUE(unpacked(all, runs_ + "/") == written_) << part;
  }
}

TEST_F(RunZipTest, MoreThanAnArchiveHoldsIsRefused) {
  write("run.mcap", "x");
  const std::uint64_t one = RunZip(runs_, "a").size();
  fs::resize_file(runs_ + "/a/run.mcap", 0xFFFF'FFFF - one);
  EXPECT_EQ(RunZip(runs_, "a").size(), 0xFFFF'FFFEU);
  fs::resize_file(runs_ + "/a/run.mcap", 0xFFFF'FFFF - one + 1);
  EXPECT_THAT(test::refusal([&] { RunZip(runs_, "a"); }), HasSubstr("more than 4 GB"));
}

TEST_F(RunZipTest, AFileThatChangedMeanwhileCutsTheArchiveOff) {
  const auto ends = [&](const auto& change) {
    write_random("run.mcap", 200'000);
    write_random("table.csv", 200'000);
    RunZip zip(runs_, "a");
    std::string into(65'536, '\0');
    EXPECT_EQ(zip.read(into), 0U);
    change();
    return all_of(zip);
  };
  EXPECT_EQ(ends([&] { fs::resize_file(runs_ + "/a/table.csv", 199'999); }), "cut off");
  EXPECT_EQ(ends([&] { fs::remove(runs_ + "/a/table.csv"); }), "cut off");
  EXPECT_EQ(ends([&] {
              test::write_bytes(runs_ + "/new", std::string(200'000, 'x'));
              fs::rename(runs_ + "/new", runs_ + "/a/table.csv");
            }),
            "cut off");
  EXPECT_EQ(ends([&] { fs::resize_file(runs_ + "/a/run.mcap", 100'000); }), "cut off");
}

TEST_F(RunZipTest, ARecordingThatGrowsIsTakenAsItWas) {
  write_random("run.mcap", 200'000);
  RunZip zip(runs_, "a");
  EXPECT_THROW(delete_run(runs_, "a"), UserError) << "while it is read";
  test::write_bytes(runs_ + "/grown", written_["a/run.mcap"] + "more");
  fs::copy_file(runs_ + "/grown", runs_ + "/a/run.mcap", fs::copy_options::overwrite_existing);
  EXPECT_TRUE(unpacked(all_of(zip)) == written_);
}

TEST_F(RunZipTest, NothingOutsideOfTheRunIsTaken) {
  write("run.mcap", "x");
  test::write_bytes(folder_.file("secret"), "secret");
  fs::create_symlink(folder_.file("secret"), runs_ + "/a/link.csv");
  test::write_bytes(runs_ + "/a/.hidden", "hidden");
  fs::create_directory(runs_ + "/a/images");
  fs::create_directory_symlink(runs_ + "/a", runs_ + "/linked");
  RunZip zip(runs_, "a");
  EXPECT_TRUE(unpacked(all_of(zip)) == written_);
  for (const char* run : {"linked", "b", "..", ".", "", "a/../a"})
    EXPECT_THROW(RunZip(runs_, run), UserError) << run;
}

TEST_F(RunZipTest, TooManyFilesAreRefused) {
  for (std::size_t i = 0; i < kMaxZipFiles; ++i) write(std::to_string(i), "x");
  RunZip zip(runs_, "a");
  EXPECT_TRUE(unpacked(all_of(zip)) == written_);
  write("one-more", "x");
  EXPECT_THAT(test::refusal([&] { RunZip(runs_, "a"); }), HasSubstr("more than 1000 files"));
}

}  // namespace
}  // namespace tp100::runs
