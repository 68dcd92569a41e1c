// No result of any program is written over a file that it reads: the drives of an afternoon, or
// their measurements, would be replaced by what was made of them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "process.h"
#include "support/paths.h"

namespace tp100::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class OutOverIn : public ::testing::Test {
 protected:
  /// A recorded drive of 10 cm, its samples as CSV, and a robot and a configuration of one's own.
  OutOverIn() {
    fs::copy_file(source_path("config/robots/uniform.toml"), at("mine.toml"));
    write_bytes(at("c.toml"), "robot = \"" + at("mine.toml") + "\"\n");
    const Finished drive =
        run({"tp100-sim", "course", short_course(folder_, 0.1), "--robot", at("mine.toml"),
             "--seed", "1", "--out", at("csv"), "--record", at("runs")});
    EXPECT_EQ(drive.status, 0) << drive.output;
    run_ = fs::directory_iterator(at("runs"))->path().string();
    recording_ = run_ + "/run.mcap";
    samples_ = at("csv/short-mine-1-samples.csv");
    write_bytes(at("measured.csv"), "run,distance_m,turned_deg\n1,0.1,0\n");
    write_bytes(at("cut.mcap"), read_bytes(recording_).substr(0, fs::file_size(recording_) / 2));
  }
  std::string at(const std::string& name) const { return folder_.file(name); }
  /// Runs a command that reads `input` and would write to a file of it.
  static void expect_refused(const Words& command, const std::string& input) {
    SCOPED_TRACE(::testing::PrintToString(command));
    const std::string before = read_bytes(input);
    const Finished finished = run(command);
    EXPECT_EQ(finished.status, 2) << finished.output;
    EXPECT_THAT(finished.output, HasSubstr("this file is read"));
    EXPECT_EQ(read_bytes(input), before);
  }
  /// Runs the command with the result at another name of `input`. More of its names: tests/text.
  void expect_kept(const std::string& input, const Words& command) {
    ASSERT_TRUE(fs::exists(input)) << input;
    const fs::path link = at("link");
    fs::create_symlink(input, link);
    expect_refused(joined(command, {"--out", link.string()}), input);
    fs::remove(link);
  }
  /// The command reads the recording `name` in a folder of results, and would write a file of that
  /// name into it.
  void expect_kept_in_folder(const std::string& name, const std::string& command,
                             const std::string& option, const Words& more = {}) {
    const std::string folder = at("results"), input = folder + "/" + name;
    fs::create_directory(folder);
    fs::copy_file(recording_, input);
    expect_refused(joined(joined({"tp100d", command, input}, more), {option, folder}), input);
    fs::remove_all(folder);
  }

  TemporaryFolder folder_;
  std::string run_, recording_, samples_;
};

TEST_F(OutOverIn, NoInputIsLost) {
  expect_kept(recording_, {"tp100d", "replay", recording_});
  expect_kept(recording_, {"tp100d", "replay", run_});
  expect_kept(at("c.toml"), {"tp100d", "replay", recording_, "--config", at("c.toml")});
  for (const std::string& read : {samples_, at("measured.csv"), at("c.toml"), at("mine.toml")})
    expect_kept(read, {"tp100d", "identify", samples_, "--measured", at("measured.csv"), "--config",
                       at("c.toml")});
  expect_kept(at("mine.toml"),
              {"tp100d", "identify", "--drive", "--robot", at("mine.toml"), "--port", at("none")});
  expect_kept(at("cut.mcap"), {"tp100d", "recover", at("cut.mcap")});
}

TEST_F(OutOverIn, NoInputIsLostInAFolderOfResults) {
  for (const char* name : {"samples.csv", "poses.csv", "odometry.tum", "fused.tum"})
    expect_kept_in_folder(name, "export", "--out");
  expect_kept_in_folder("results_0.mcap", "export", "--ros2");
  for (const char* name : {"report.html", "metrics.json"})
    expect_kept_in_folder(name, "report", "--out");
  for (const char* name : {"compare.html", "compare.json"})
    expect_kept_in_folder(name, "compare", "--out", {recording_});
}

TEST_F(OutOverIn, AResultIsReplaced) {
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(run({"tp100d", "replay", recording_, "--out", at("poses.csv")}).status, 0);
}

}  // namespace
}  // namespace tp100::test
