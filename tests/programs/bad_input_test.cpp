// Every user error gives one line and exit status 2, and leaves no incomplete files behind.

#include <gtest/gtest.h>

#include <fstream>

#include "process.h"

namespace tp100::test {
namespace {

class BadInput : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.file(name), std::ios::binary) << text;
    return folder_.file(name);
  }
  /// Expects status 2 and one line that contains `what`.
  static void expect_refused(std::vector<std::string> arguments, const std::string& what) {
    const Finished finished = run(std::move(arguments));
    EXPECT_EQ(finished.status, 2) << finished.output;
    EXPECT_EQ(lines(finished.output), 1u) << finished.output;
    EXPECT_NE(finished.output.find(what), std::string::npos) << finished.output;
  }
  TemporaryFolder folder_;
};

TEST_F(BadInput, UsageErrors) {
  expect_refused({"tp100d"}, "--help");
  expect_refused({"tp100d", "fly"}, "--help");
  expect_refused({"tp100d", "run", "--no-such-option"}, "--help");
  expect_refused({"tp100d", "run", "--cours", "3"},
                 "did you mean '--course'?; see tp100d run --help");
  expect_refused({"tp100d", "run", "--setup", "moon"}, "moon");
  expect_refused({"tp100-sim", "course"}, "--help");
  expect_refused({"tp100-sim", "course", "1-curve", "--runs", "0"}, "--runs");
  expect_refused({"tp100-sim", "course", "1-curve", "--setup", "moon"}, "moon");
  expect_refused({"tp100-sim", "course", "1-curve", "--board", "uno"}, "uno");
  expect_refused({"tp100-sim", "course", "1-curve", "--seed", "x"}, "seed");
  expect_refused({"tp100-sim", "course", "1-curve", "--seed", "-1"}, "seed");
  expect_refused({"tp100-sim", "corse", "1-curve"}, "did you mean 'course'");
  expect_refused({"tp100-sim", "course", "1-curve", "--board", "two\nlines"}, "two");
  expect_refused({"tp100-sim", "faults", "--board", "uno"}, "uno");
}

// What is wrong, and what is allowed.
TEST_F(BadInput, NumbersThatAreNoneOrOutOfRange) {
  struct Option {
    std::vector<std::string> command;
    std::string name, range;
  };
  const std::vector<Option> options = {
      {{"tp100d", "run"}, "--duration", "0.001 to 1000000000"},
      {{"tp100d", "ports"}, "--timeout", "0.1 to 3600"},
      {{"tp100d", "doctor"}, "--link-test", "0 to 3600"},
      {{"tp100d", "identify", "--out", "x"}, "--repeats", "1 to 100"},
      {{"tp100-sim", "course", "3"}, "--seed", "0 to 18446744073709551615"},
      {{"tp100-sim", "course", "3"}, "--runs", "1 to 1000000"},
      {{"tp100-sim", "robot"}, "--seed", "0 to 18446744073709551615"},
      {{"tp100-sim", "reproduce"}, "--seed", "0 to 18446744073709551615"},
      {{"tp100-sim", "reproduce"}, "--runs", "1 to 10000"},
      {{"tp100-sim", "reproduce"}, "--sampled", "0 to 10000"},
      {{"tp100-sim", "calibrate"}, "--repeats", "1 to 100"},
      {{"tp100-sim", "calibrate"}, "--runs", "1 to 10000"},
      {{"tp100-sim", "campaign", "x"}, "--todo", "1 to 1000000"},
  };
  for (const Option& option : options) {
    for (const auto& [value, what] : {std::pair{"abc", "not a number"}, {"-7", "out of range"}}) {
      std::vector<std::string> command = option.command;
      command.insert(command.end(), {option.name, value});
      expect_refused(command,
                     option.name + " " + value + ": " + what + "; give " + option.range + "; see ");
    }
  }
}

TEST_F(BadInput, NamesTheNearestName) {
  expect_refused({"tp100d", "run", "--course", "33"}, "33: no such course; did you mean '3'?");
  expect_refused({"tp100d", "run", "--robot", "wom"}, "wom: no such robot; did you mean 'worn'?");
  expect_refused({"tp100-sim", "robot", "--fault", "dorp"}, "did you mean 'drop'?");
  expect_refused({"tp100-sim", "reproduce", "--part", "papr"}, "did you mean 'paper'?");
}

TEST_F(BadInput, MissingFiles) {
  expect_refused({"tp100d", "check", folder_.file("none.toml")}, "none.toml");
  expect_refused({"tp100d", "run", "--config", folder_.file("none.toml")}, "none.toml");
  expect_refused({"tp100d", "replay", folder_.file("none.csv"), "--out", folder_.file("o.csv")},
                 "none.csv");
  expect_refused({"tp100-sim", "course", "9-moon"}, "9-moon");
  expect_refused({"tp100-sim", "course", "1-curve", "--robot", "r2d2"}, "r2d2");
  expect_refused({"tp100d", "report", folder_.path().string()}, "name a recording or its folder");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  // A corrupted recording is not accepted as a table of speeds.
  expect_refused({"tp100d", "replay", write("junk.mcap", "junk"), "--out", folder_.file("o.csv")},
                 "recording");
  expect_refused({"tp100-sim", "course", "3", "--out", "/proc/x"}, "/proc/x");
}

TEST_F(BadInput, MissingPort) {
  expect_refused({"tp100d", "run", "--port", folder_.file("no-port")}, "no-port");
  expect_refused({"tp100d", "run", "--port", "/dev/ttyNO0"}, "/dev/ttyNO0");
}

TEST_F(BadInput, SomethingThatIsNoPort) {
  expect_refused({"tp100d", "run", "--port", write("file", "text")}, "file");
  expect_refused({"tp100d", "run", "--port", folder_.path().string()}, "serial port");
}

TEST_F(BadInput, ABusyPort) {
  Process robot({"tp100-sim", "robot", "--link", folder_.file("tp100")});
  ASSERT_TRUE(robot.wait_for("linked from"));
  Process holder({"tp100d", "run", "--port", folder_.file("tp100")});
  ASSERT_TRUE(holder.wait_for("-> ready")) << holder.output();
  expect_refused({"tp100d", "run", "--port", folder_.file("tp100")}, "busy");
}

TEST_F(BadInput, GarbageToml) {
  expect_refused({"tp100d", "check", write("a.toml", "speed = = 3\n")}, "a.toml:1:");
  expect_refused({"tp100d", "run", "--config", write("b.toml", "[loop]\nrate_hzz = 200\n")},
                 "b.toml:2:");
  expect_refused({"tp100-sim", "course", write("c.toml", std::string(100000, '['))}, "c.toml:");
  expect_refused({"tp100-sim", "course", "1-curve", "--robot", write("d.toml", "\x01\xff\n")},
                 "d.toml:");
}

TEST_F(BadInput, UnfinishedCsvLeavesNoOutput) {
  const std::string in = write("in.csv", "t_s,left_mps,right_mps\n0,0.1,0.1\n1,0.1");
  expect_refused({"tp100d", "replay", in, "--out", folder_.file("out.csv")}, "in.csv:3");
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& file : std::filesystem::directory_iterator(folder_.path()))
    ++files;
  EXPECT_EQ(files, 1u);
}

TEST_F(BadInput, AnOutputFolderThatIsNotThere) {
  const std::string in = write("in.csv", "t_s,left_mps,right_mps\n0,0.1,0.1\n");
  expect_refused({"tp100d", "replay", in, "--out", folder_.file("no/out.csv")}, "out.csv");
}

}  // namespace
}  // namespace tp100::test
