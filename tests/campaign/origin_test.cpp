#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "../support/temporary_folder.h"
#include "sim/campaign/campaign_folder.h"

namespace tp100::sim {
namespace {

using test::TemporaryFolder;
using testing::Contains;
using testing::HasSubstr;
using testing::Key;
using testing::Not;
using testing::Pair;

Origin origin(const std::string& spec) {
  return origin_of(parse_campaign("runs = 2\n" + spec, "spec.toml"));
}

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

TEST(Origin, HasEveryFileOfEveryList) {
  const Origin of = origin(
      "course = { list = [\"2\", \"3\"] }\nrobot = { list = [\"uniform\", \"\"] }\n"
      "camera = { list = [\"\", \"overhead\"] }\n");
  for (const char* name :
       {"course 2", "course 3", "robot uniform", "robot end-loaded", "camera overhead"})
    EXPECT_THAT(of, Contains(Pair(name, testing::MatchesRegex("[0-9a-f]{16}"))));
  EXPECT_NE(of.at("course 2"), of.at("course 3"));
  EXPECT_THAT(of, Not(Contains(Key("camera "))));
}

TEST(Origin, HasTheRobotsThatTheConfigurationNames) {
  const TemporaryFolder folder;
  write(folder.file("tp100.toml"), "robot = \"uniform\"\n");
  const std::string spec = "course = \"3\"\nconfig = \"" + folder.file("tp100.toml") + "\"\n";
  const Origin of = origin(spec);
  EXPECT_THAT(of, Contains(Key("robot uniform")));
  EXPECT_THAT(of, Contains(Key("configuration " + folder.file("tp100.toml"))));
  EXPECT_THAT(of, Not(Contains(Key("robot end-loaded"))));
  const Origin listed =
      origin(spec + "[configuration]\nrobot = { list = [\"uniform\", \"end-loaded\"] }\n");
  EXPECT_THAT(listed, Contains(Key("robot end-loaded")));
}

TEST(Origin, HasTheFirmwareIfTheImageRuns) {
  EXPECT_THAT(origin("course = \"3\"\nboard = { list = [\"native\", \"avr\"] }\n"),
              Contains(Key("firmware")));
  EXPECT_THAT(origin("course = \"3\"\n"), Not(Contains(Key("firmware"))));
}

TEST(Origin, HasTheLibrariesThatDoItsSums) {
  EXPECT_THAT(origin_text(origin("course = \"3\"\n")), HasSubstr("library libm.so"));
}

TEST(Origin, ChangesWithAFileAndSaysWhich) {
  const TemporaryFolder folder;
  const std::string course = folder.file("course.toml"), spec = "course = \"" + course + "\"\n";
  const Origin none = origin(spec);
  EXPECT_EQ(none.at("course " + course), "not there");
  write(course, "a");
  const Origin first = origin(spec);
  // This is the published FNV-1a hash of "a".
  EXPECT_EQ(first.at("course " + course), "af63dc4c8601ec8c");
  EXPECT_EQ(difference(none, first), "course " + course + " was not there, is af63dc4c8601ec8c");
  EXPECT_EQ(difference(first, origin(spec)), "");
  write(course, "b");
  EXPECT_THAT(difference(first, origin(spec)), HasSubstr("course " + course + " was af63dc4c"));
}

TEST(Origin, IsReadBackAsItWasWritten) {
  const Origin of = {{"course a: b.toml", "1"}, {"program", "tp100-sim 1.0, build 2"}};
  EXPECT_EQ(read_origin(origin_text(of)), of);
  EXPECT_EQ(read_origin("nothing\n\n"), Origin());
  EXPECT_EQ(difference(of, {{"program", "tp100-sim 1.0, build 2"}}),
            "course a: b.toml was 1, is not there");
  EXPECT_EQ(difference({}, {{"x", "1"}}), "x was not there, is 1");
}

}  // namespace
}  // namespace tp100::sim
