// Every user error gives one line and exit status 2, and leaves no incomplete files behind.

#include <gtest/gtest.h>

#include <filesystem>

#include "process.h"

namespace tp100::test {
namespace {

class BadInput : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    write_bytes(folder_.file(name), text);
    return folder_.file(name);
  }
  /// Expects status 2 and one line that contains `what`.
  static void expect_refused(const Words& words, const std::string& what) {
    const Finished finished = run(words);
    EXPECT_EQ(finished.status, 2) << finished.output;
    EXPECT_EQ(lines(finished.output), 1u) << finished.output;
    EXPECT_NE(finished.output.find(what), std::string::npos) << finished.output;
  }
  TemporaryFolder folder_;
};

TEST_F(BadInput, UsageErrors) {
  expect_refused({"tp100d"}, "--help");
  expect_refused({"tp100d", "docter"}, "did you mean 'doctor'?");
  expect_refused({"tp100d", "run", "--cours", "3"},
                 "did you mean '--course'?; see tp100d run --help");
  expect_refused({"tp100d", "run", "--setup", "moon"}, "moon");
  expect_refused({"tp100-sim", "course"}, "--help");
  expect_refused({"tp100-sim", "course", "1-curve", "--setup", "moon"}, "moon");
  expect_refused({"tp100-sim", "course", "1-curve", "--board", "two\nlines"}, "two");
  expect_refused({"tp100-sim", "robot", "--blank", "--link", folder_.file("a")}, "--board avr");
  expect_refused({"tp100-sim", "course", "3", "--world", "udp:127.0.0.1:1"}, "no welcome");
}

// What is wrong, and what is allowed.
TEST_F(BadInput, NumbersThatAreNoneOrOutOfRange) {
  const struct {
    Words command;
    std::string name, range;
  } options[] = {
      {{"tp100d", "run"}, "--duration", "0.001 to 1000000000"},
      {{"tp100d", "ports"}, "--timeout", "0.1 to 3600"},
      {{"tp100-sim", "course", "3"}, "--seed", "0 to 18446744073709551615"},
      {{"tp100-sim", "course", "3"}, "--runs", "1 to 1000000"},
      {{"tp100-sim", "calibrate"}, "--repeats", "1 to 100"},
      {{"tp100-sim", "campaign", "x"}, "--todo", "1 to 1000000"},
  };
  for (const auto& option : options)
    for (const auto& [value, what] : {std::pair{"abc", "not a number"}, {"-7", "out of range"}})
      expect_refused(joined(option.command, {option.name, value}),
                     option.name + " " + value + ": " + what + "; give " + option.range + "; see ");
}

TEST_F(BadInput, NamesTheNearestName) {
  expect_refused({"tp100d", "run", "--course", "33"}, "33: no such course; did you mean '3'?");
  expect_refused({"tp100d", "run", "--robot", "wom"}, "wom: no such robot; did you mean 'worn'?");
  expect_refused({"tp100-sim", "robot", "--fault", "dorp"}, "did you mean 'drop'?");
}

TEST_F(BadInput, FilesThatAreMissingOrNotWhatTheyShouldBe) {
  const Words out = {"--out", folder_.file("o.csv")};
  const std::string none = folder_.file("none.toml");
  expect_refused({"tp100d", "check", none}, "none.toml");
  expect_refused({"tp100d", "run", "--config", none}, "none.toml");
  expect_refused(joined({"tp100d", "replay", folder_.file("none")}, out), "none");
  expect_refused({"tp100d", "export", folder_.file("none")}, "none");
  expect_refused({"tp100d", "export", folder_.path().string()}, "");
  expect_refused({"tp100d", "recover", folder_.file("none")}, "none");
  expect_refused({"tp100d", "report", folder_.path().string()}, "name a recording or its folder");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  const std::string junk = write("junk.mcap", "\x89MCAP0\r\n and then nonsense");
  expect_refused(joined({"tp100d", "replay", junk}, out), "junk.mcap");
  expect_refused({"tp100d", "report", junk}, "junk.mcap");
  expect_refused({"tp100d", "compare", junk}, "");
  expect_refused({"tp100d", "check", write("a.toml", "speed = = 3\n")}, "a.toml:1:");
  expect_refused({"tp100d", "run", "--config", write("b.toml", "[loop]\nrate_hzz = 200\n")},
                 "b.toml:2:");
  expect_refused({"tp100-sim", "course", write("c.toml", std::string(100000, '['))}, "c.toml:");
}

TEST_F(BadInput, SomethingThatIsNoPort) {
  expect_refused({"tp100d", "run", "--port", folder_.file("no-port")}, "no-port");
  expect_refused({"tp100d", "run", "--port", write("file", "text")}, "file");
  expect_refused({"tp100d", "run", "--port", folder_.path().string()}, "serial port");
}

TEST_F(BadInput, NoResultIsWrittenOfAnUnfinishedInputOrIntoAFolderThatIsNotThere) {
  const std::string cut = write("cut.csv", "t_s,left_count,right_count,gyro_z_radps\n0,0,0,0\n1,0");
  expect_refused({"tp100d", "identify", cut, "--out", folder_.file("out.toml")}, "cut.csv:3");
  expect_refused({"tp100-sim", "course", "3", "--out", "/proc/x"}, "/proc/x");
  expect_refused({"tp100-sim", "course", "1-straight", "--record", "/proc/none"}, "/proc/none");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
}

}  // namespace
}  // namespace tp100::test
