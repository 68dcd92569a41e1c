// No result of any program is written over a file that it reads.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

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
    write_bytes(at("short.toml"),
                "speed_mps = 0.1\n[[segment]]\ntype = \"line\"\nlength_m = 0.1\n[fence]\n"
                "min_x_m = -1\nmax_x_m = 1\nmin_y_m = -1\nmax_y_m = 1\n");
    fs::copy_file(source_path("config/robots/uniform.toml"), at("mine.toml"));
    write_bytes(at("c.toml"), "robot = \"" + at("mine.toml") + "\"\n");
    const Finished drive =
        test::run({"tp100-sim", "course", at("short.toml"), "--robot", at("mine.toml"), "--seed",
                   "1", "--out", at("csv"), "--record", at("runs")});
    EXPECT_EQ(drive.status, 0) << drive.output;
    run_ = fs::directory_iterator(at("runs"))->path().string();
    recording_ = run_ + "/run.mcap";
    samples_ = at("csv/short-mine-1-samples.csv");
    write_bytes(at("steady.csv"), "t_s,left_mps,right_mps\n0,0.1,0.1\n1,0.1,0.1\n");
    write_bytes(at("measured.csv"), "run,distance_m,turned_deg\n1,0.1,0\n");
  }
  std::string at(const std::string& name) const { return folder_.file(name); }
  /// Runs the program with the result at `input`, and at other names of that file.
  void expect_kept(const std::string& input,
                   const std::function<std::vector<std::string>(const std::string&)>& arguments) {
    ASSERT_TRUE(fs::exists(input)) << input;
    const std::string before = read_bytes(input);
    const std::string link = at("link"), hard = fs::path(input).parent_path() / "hard";
    fs::create_symlink(input, link);
    fs::create_hard_link(input, hard);
    for (const std::string& out : {input,
                                   fs::path(input).parent_path().string() + "/../" +
                                       fs::path(input).parent_path().filename().string() + "/" +
                                       fs::path(input).filename().string(),
                                   link, hard}) {
      const Finished finished = test::run(arguments(out));
      EXPECT_EQ(finished.status, 2) << out << ": " << finished.output;
      EXPECT_THAT(finished.output, HasSubstr("this file is read")) << out;
      EXPECT_EQ(read_bytes(input), before) << out;
    }
    fs::remove(link);
    fs::remove(hard);
  }
  /// The program writes a file of that name into a folder of its choice, where its input has it.
  void expect_kept_in_folder(const std::string& name,
                             const std::function<std::vector<std::string>(
                                 const std::string& input, const std::string& folder)>& arguments) {
    const fs::path folder = at("results");
    fs::create_directory(folder);
    fs::copy_file(recording_, folder / name);
    const std::string before = read_bytes((folder / name).string());
    const Finished finished = test::run(arguments((folder / name).string(), folder.string()));
    EXPECT_EQ(finished.status, 2) << name << ": " << finished.output;
    EXPECT_THAT(finished.output, HasSubstr("this file is read")) << name;
    EXPECT_EQ(read_bytes((folder / name).string()), before) << name;
    fs::remove_all(folder);
  }

  TemporaryFolder folder_;
  std::string run_, recording_, samples_;
};

// The drives of an afternoon, or their measurements, would be replaced by what was made of them.
TEST_F(OutOverIn, NoInputIsLost) {
  expect_kept(recording_, [&](const std::string& out) {
    return std::vector<std::string>{"tp100d", "replay", recording_, "--out", out};
  });
  expect_kept(recording_, [&](const std::string& out) {
    return std::vector<std::string>{"tp100d", "replay", run_, "--out", out};
  });
  expect_kept(at("steady.csv"), [&](const std::string& out) {
    return std::vector<std::string>{"tp100d", "replay", at("steady.csv"), "--out", out};
  });
  for (const char* read : {"c.toml", "mine.toml"})
    expect_kept(at(read), [&](const std::string& out) {
      return std::vector<std::string>{
          "tp100d", "replay", at("steady.csv"), "--config", at("c.toml"), "--out", out};
    });
  for (const std::string& read : {samples_, at("measured.csv"), at("c.toml"), at("mine.toml")})
    expect_kept(read, [&](const std::string& out) {
      return std::vector<std::string>{
          "tp100d",   "identify",   samples_, "--measured", at("measured.csv"),
          "--config", at("c.toml"), "--out",  out};
    });
  expect_kept(at("mine.toml"), [&](const std::string& out) {
    return std::vector<std::string>{"tp100d", "identify", "--drive", "--robot", at("mine.toml"),
                                    "--port", at("none"), "--out",   out};
  });
  const std::string cut = at("cut.mcap");
  write_bytes(cut, read_bytes(recording_).substr(0, fs::file_size(recording_) / 2));
  expect_kept(cut, [&](const std::string& out) {
    return std::vector<std::string>{"tp100d", "recover", cut, "--out", out};
  });
}

TEST_F(OutOverIn, NoInputIsLostInAFolderOfResults) {
  for (const char* name : {"samples.csv", "poses.csv", "odometry.tum", "fused.tum"})
    expect_kept_in_folder(name, [](const std::string& in, const std::string& folder) {
      return std::vector<std::string>{"tp100d", "export", in, "--out", folder};
    });
  expect_kept_in_folder("results_0.mcap", [](const std::string& in, const std::string& folder) {
    return std::vector<std::string>{"tp100d", "export", in, "--ros2", folder};
  });
  for (const char* name : {"report.html", "metrics.json"})
    expect_kept_in_folder(name, [](const std::string& in, const std::string& folder) {
      return std::vector<std::string>{"tp100d", "report", in, "--out", folder};
    });
  for (const char* name : {"compare.html", "compare.json"})
    expect_kept_in_folder(name, [&](const std::string& in, const std::string& folder) {
      return std::vector<std::string>{"tp100d", "compare", in, recording_, "--out", folder};
    });
}

// A result may be made again, and an input whose name is like that of a result does no harm.
TEST_F(OutOverIn, AResultIsReplaced) {
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(test::run({"tp100d", "replay", recording_, "--out", at("poses.csv")}).status, 0);
    EXPECT_EQ(test::run({"tp100d", "report", run_}).status, 0);
    EXPECT_EQ(test::run({"tp100d", "export", run_}).status, 0);
  }
}

}  // namespace
}  // namespace tp100::test
