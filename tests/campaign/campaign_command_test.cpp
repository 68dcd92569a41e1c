// Runs the real program in real folders.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <thread>

#include "../programs/process.h"
#include "support/paths.h"

namespace tp100::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// The course is short, so that the runs end soon.
constexpr const char* kCourse =
    "[[segment]]\ntype = \"arc\"\nradius_m = 0.3\nangle_deg = 30.0\n"
    "[fence]\nmin_x_m = -0.5\nmax_x_m = 0.8\nmin_y_m = -0.5\nmax_y_m = 0.5\n";
constexpr const char* kSpec =
    "runs = 6\n"
    "robot = { list = [\"end-loaded\", \"uniform\"] }\n"
    "[robot_values]\nemulated.body.friction = { uniform = [0.6, 0.9] }\n";

class Campaign : public testing::Test {
 protected:
  Campaign() {
    write("short.toml", kCourse);
    write("spec.toml", spec(folder_.file("short.toml")));
  }
  static std::string spec(const std::string& course) {
    return "course = \"" + course + "\"\n" + kSpec;
  }
  void write(const std::string& name, const std::string& text) const {
    write_bytes(folder_.file(name), text);
  }
  std::string read(const std::string& name) const { return read_bytes(folder_.file(name)); }
  Words command(const std::string& out, const Words& more = {}) const {
    return joined({"tp100-sim", "campaign", folder_.file("spec.toml"), "--out", folder_.file(out)},
                  more);
  }
  Finished drive(const std::string& out, const Words& more = {}) const {
    return run(command(out, more));
  }
  std::string merged(const std::string& out) const {
    const Finished merge = run({"tp100-sim", "merge", folder_.file(out)});
    EXPECT_EQ(merge.status, 0) << merge.output;
    return read(out + "/merged.json");
  }
  static void expect_refused(const Words& words, const std::string& what) {
    const Finished wrong = run(words);
    EXPECT_EQ(wrong.status, 2) << wrong.output;
    EXPECT_EQ(lines(wrong.output), 1u) << wrong.output;
    EXPECT_THAT(wrong.output, HasSubstr(what));
  }
  std::size_t done(const std::string& out) const {
    std::size_t count = 0;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder_.file(out) + "/runs", none))
      count += std::size_t{entry.path().extension() == ".json"};
    return count;
  }

  TemporaryFolder folder_;
};

TEST_F(Campaign, InAnyOrderAndBySeveralProgramsAtOnceComesOutTheSame) {
  EXPECT_EQ(drive("a").status, 0);
  {
    Process one(command("b", {"--index", "3-5"})), other(command("b", {"--index", "2"}));
    EXPECT_EQ(drive("b", {"--index", "4"}).status, 0);
    EXPECT_EQ(one.wait(), 0);
    EXPECT_EQ(other.wait(), 0);
  }
  const Finished rest = drive("b");
  EXPECT_THAT(rest.output, HasSubstr("2 runs driven, 4 done before, 0 refused"));
  const std::string merged_a = merged("a");
  EXPECT_THAT(merged_a, HasSubstr("\"completed\": 6"));
  EXPECT_EQ(merged_a, merged("b"));
  EXPECT_EQ(read("a/runs.csv"), read("b/runs.csv"));
  EXPECT_THAT(read("a/index.html"), HasSubstr("6 of 6 driven runs completed"));
}

TEST_F(Campaign, KilledInTheMiddleIsTakenUpWhereItWas) {
  write("spec.toml", spec("1-curve"));
  Process killed(command("a"));
  while (done("a") < 2) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  killed.signal(SIGKILL);
  killed.wait();
  // This simulates a kill between writing and renaming.
  write("a/runs/.000005.json.XXXX", "{\"index\":5,");
  const std::size_t before = done("a");
  ASSERT_LT(before, 6u);
  const Finished merge = run({"tp100-sim", "merge", folder_.file("a")});
  EXPECT_EQ(merge.status, 1);
  EXPECT_THAT(merge.output, HasSubstr(" missing ("));
  EXPECT_THAT(drive("a").output, HasSubstr(" driven, " + std::to_string(before) + " done before"));
  EXPECT_EQ(drive("b").status, 0);
  EXPECT_EQ(merged("a"), merged("b"));
}

TEST_F(Campaign, DrivesTheRunsOfAListAndSaysWhatIsLeftToDo) {
  EXPECT_EQ(drive("a", {"--todo", "4"}).output, "0-3\n4-5\n");
  EXPECT_EQ(drive("a", {"--index", "2"}).status, 0);
  EXPECT_EQ(drive("a", {"--todo", "4"}).output, "0-1,3-4\n5\n");
  EXPECT_EQ(drive("a", {"--todo", "1", "--index", "2-3"}).output, "3\n");
  EXPECT_THAT(drive("a", {"--index", "0,2-3,5"}).output, HasSubstr("3 runs driven, 1 done"));
  EXPECT_EQ(drive("a", {"--todo", "9"}).output, "1,4\n");
}

TEST_F(Campaign, RunsThatCannotBeDrivenAreToldAndNotTriedAgain) {
  const std::string course = "course = \"" + folder_.file("short.toml") + "\"\n[robot_values]\n";
  write("spec.toml", "runs = 2\n" + course + "emulated.body.friction = { list = [0.8, 77.0] }\n");
  const Finished first = drive("a");
  EXPECT_EQ(first.status, 1);
  EXPECT_THAT(first.output, HasSubstr("run 1 refused"));
  EXPECT_THAT(first.output, HasSubstr("'emulated.body.friction' is 77"));
  EXPECT_EQ(drive("a").status, 0);
  const Finished merge = run({"tp100-sim", "merge", folder_.file("a")});
  EXPECT_EQ(merge.status, 1);
  EXPECT_THAT(merge.output, HasSubstr("1 of 1 driven runs completed"));
  EXPECT_THAT(merge.output, HasSubstr("1 run refused"));
}

TEST_F(Campaign, ARecordedRunIsReplayedBitForBit) {
  const Finished one = drive("a", {"--index", "1", "--record", folder_.file("recordings")});
  ASSERT_EQ(one.status, 0) << one.output;
  std::string recording;
  for (const auto& entry : fs::recursive_directory_iterator(folder_.file("recordings")))
    if (entry.path().extension() == ".mcap") recording = entry.path();
  const Finished replay = run({"tp100d", "replay", recording, "--out", folder_.file("poses.csv")});
  EXPECT_EQ(replay.status, 0) << replay.output;
}

TEST_F(Campaign, IsTakenUpOnlyWithTheProgramAndTheFilesThatItWasBegunWith) {
  const std::string robot = read_bytes(source_path("config/robots/uniform.toml"));
  write("mine.toml", robot);
  write("spec.toml", "runs = 2\ncourse = \"" + folder_.file("short.toml") + "\"\nrobot = \"" +
                         folder_.file("mine.toml") + "\"\n");
  ASSERT_EQ(drive("a", {"--index", "0"}).status, 0);
  const std::string origin = read("a/origin.txt");

  write("mine.toml", robot + "# edited\n");
  for (const char* action : {"--index", "--todo"})
    expect_refused(command("a", {action, "1"}), "robot " + folder_.file("mine.toml") + " was ");
  EXPECT_EQ(done("a"), 1u);

  write("mine.toml", robot);
  std::string rebuilt = origin;
  rebuilt.replace(rebuilt.find(", build ") + 8, 4, "beef");
  write("a/origin.txt", rebuilt);
  expect_refused(command("a"), "program was tp100-sim");
  fs::remove(folder_.file("a/origin.txt"));
  expect_refused(command("a"), "does not say which program drove its runs");

  write("a/origin.txt", origin);
  EXPECT_THAT(drive("a").output, HasSubstr("1 run driven, 1 done before"));
}

TEST_F(Campaign, AFileThatIsEditedWhileItRunsEndsIt) {
  const std::string course = read_bytes(source_path("config/courses/1-curve.toml"));
  write("course.toml", course);
  write("spec.toml", "runs = 1000\ncourse = \"" + folder_.file("course.toml") + "\"\n");
  Process driving(command("a"));
  while (done("a") < 1) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  write("course.toml", course + "# edited\n");
  EXPECT_EQ(driving.wait(), 2);
  EXPECT_THAT(driving.output(), HasSubstr("were made with different inputs (course "));
  EXPECT_LT(done("a"), 1000u);
}

// An empty --index, as of a task that starts late, must not drive all runs.
TEST_F(Campaign, MistakesAreOneLineAndStatus2) {
  expect_refused(command("a", {"--index", ""}), "--index is empty; give runs as");
  expect_refused(command("a", {"--index="}), "--index");
  EXPECT_EQ(done("a"), 0u);
  ASSERT_EQ(drive("a", {"--index", "0"}).status, 0);
  for (const char* index : {"6", "3-1", "0-6", "x", "-1", "1-", "1,", ",1", "1,,2", "1 2"})
    expect_refused(command("a", {"--index", index}), "--index");
  write("spec.toml", spec(folder_.file("short.toml")) + "# another\n");
  expect_refused(command("a"), "holds the runs of another campaign");
  expect_refused({"tp100-sim", "merge", folder_.file("nowhere")}, "holds no campaign");
}

}  // namespace
}  // namespace tp100::test
