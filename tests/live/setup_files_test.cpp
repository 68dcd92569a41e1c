#include "config/setup_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../support/temporary_folder.h"
#include "live/services.h"
#include "support/refusal.h"

namespace tp100::live {
namespace {

namespace fs = std::filesystem;
using config::SetupFiles;
using course::Bundled;
using Json = nlohmann::json;
using ::testing::HasSubstr;

constexpr const char* kLine =
    "description = \"a line\"\nspeed_mps = 0.1\n[[segment]]\ntype = \"line\"\nlength_m = 0.3\n"
    "[fence]\nmin_x_m = -1.0\nmax_x_m = 1.0\nmin_y_m = -1.0\nmax_y_m = 1.0\n";

class SetupFilesTest : public ::testing::Test {
 protected:
  std::string save(const std::string& name, const std::string& text, bool replace = false) {
    return test::refusal([&] { files_.save(Bundled::kCourses, name, text, replace); });
  }
  std::string remove(const std::string& name) {
    return test::refusal([&] { files_.remove(Bundled::kCourses, name); });
  }
  bool listed(const std::string& name, SetupFiles::From from) const {
    for (const SetupFiles::Entry& entry : files_.list(Bundled::kCourses))
      if (entry.name == name) return entry.from == from;
    return false;
  }
  void write(const std::string& file, const std::string& text) const {
    fs::create_directories(folder_.path() / "courses");
    std::ofstream(folder_.path() / "courses" / file) << text;
  }
  std::size_t own_files() const {
    const fs::path courses = folder_.path() / "courses";
    if (!fs::exists(courses)) return 0;
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(courses), fs::directory_iterator{}));
  }

  test::TemporaryFolder folder_;
  SetupFiles files_{folder_.path().string(), {}};
};

TEST_F(SetupFilesTest, ATextWithAnErrorIsRefusedWithItsLineAndColumn) {
  EXPECT_EQ(save("mine", "speed_mps = 0.1\nspeed = 3\n").find("mine.toml:"), 0u);
  EXPECT_THAT(save("mine", std::string(kLine) + "[[ramp]]\nx = 1\n"), HasSubstr("mine.toml:"));
  std::string leaves = kLine;
  leaves.replace(leaves.find("0.3"), 3, "3.0");
  EXPECT_THAT(save("mine", leaves), HasSubstr("the path leaves the fence"));
  EXPECT_EQ(own_files(), 0u);
}

TEST_F(SetupFilesTest, BundledFilesAndOneThatWasGivenAreNeitherReplacedNorDeleted) {
  EXPECT_THAT(save("3", kLine, true), HasSubstr("not one of your own"));
  EXPECT_THAT(remove("3"), HasSubstr("cannot be deleted"));
  config::RunFiles given;
  given.course = {"/somewhere/3.toml", kLine};
  const SetupFiles files(folder_.path().string(), given);
  EXPECT_EQ(files.read(Bundled::kCourses, "3").text, kLine) << "it hides others of its name";
  EXPECT_THAT(test::refusal([&] { files.save(Bundled::kCourses, "3", kLine, true); }),
              HasSubstr("not one of your own"));
}

TEST_F(SetupFilesTest, AnOwnFileWithTheNameOfABundledOneIsUsedAndThatIsSaid) {
  write("1-straight.toml", kLine);
  EXPECT_TRUE(listed("1-straight", SetupFiles::From::kOwn));
  EXPECT_EQ(files_.read(Bundled::kCourses, "1-straight").text, kLine);
  const std::string own = folder_.file("courses/1-straight.toml");
  config::RunFiles files;
  files.course = config::read_setup_file(Bundled::kCourses, "1-straight", folder_.path().string());
  EXPECT_EQ(files.course.path, own);
  EXPECT_THAT(config::hidden_files(files),
              testing::ElementsAre(own + ": used, and not the bundled course of that name"));
  EXPECT_EQ(remove("1-straight"), "");
  EXPECT_TRUE(listed("1-straight", SetupFiles::From::kBundled));
}

TEST_F(SetupFilesTest, AnyNameThatAFileSystemTakesIsReadByTheProgram) {
  for (const std::string name : {"slalom (copy)", "Prüf strecke", "a:b #2 100%?"}) {
    write(name + ".toml", kLine);
    const auto read = [&](const std::string& as) {
      return config::read_setup_file(Bundled::kCourses, as, folder_.path().string()).text;
    };
    EXPECT_EQ(read(name), kLine);
    EXPECT_EQ(read(name + ".toml"), kLine);
  }
}

TEST_F(SetupFilesTest, NamesStayInTheFolderAndOneThatIsNoneComesWithTheNearest) {
  for (const char* name : {"", ".", "..", "../a", "a/b", "/tmp/a", ".hidden", "a b", "a\nb"}) {
    EXPECT_THAT(save(name, kLine), HasSubstr("name must be")) << name;
    EXPECT_NE(test::refusal([&] { files_.read(Bundled::kCourses, name); }), "") << name;
  }
  EXPECT_NE(save(std::string(65, 'a'), kLine), "");
  EXPECT_EQ(own_files(), 0u);
  write("my-room.toml", kLine);
  EXPECT_EQ(test::refusal([&] { files_.read(Bundled::kCourses, "my-romo"); }),
            "my-romo: no such course; did you mean 'my-room'?; GET /api/setup lists them");
  EXPECT_THAT(remove("nothing"), HasSubstr("no such course"));
}

// A link in the folder would have any file of this account overwritten.
TEST_F(SetupFilesTest, WhatIsNoPlainFileIsNeitherListedNorSavedOver) {
  write("precious.txt", "precious");
  EXPECT_FALSE(listed("precious", SetupFiles::From::kOwn));
  fs::create_symlink("precious.txt", folder_.path() / "courses" / "link.toml");
  fs::create_symlink("nowhere", folder_.path() / "courses" / "dangling.toml");
  fs::create_directory(folder_.path() / "courses" / "folder.toml");
  for (const char* name : {"link", "dangling", "folder"}) {
    EXPECT_FALSE(listed(name, SetupFiles::From::kOwn)) << name;
    for (const bool replace : {false, true})
      EXPECT_THAT(save(name, kLine, replace), HasSubstr("no plain file")) << name;
  }
  write("mine.toml", kLine);
  fs::create_symlink("precious.txt", folder_.path() / "courses" / "mine.toml.bak");
  EXPECT_THAT(save("mine", std::string(kLine) + "# 2\n", true), HasSubstr("no plain file"));
  EXPECT_EQ(test::read_bytes(folder_.file("courses/precious.txt")), "precious");
  EXPECT_EQ(test::read_bytes(folder_.file("courses/mine.toml")), kLine);
  EXPECT_EQ(own_files(), 6u);
}

class SetupListTest : public SetupFilesTest {
 protected:
  SetupListTest() {
    run_.files.robot = course::read_bundled(Bundled::kRobots, "end-loaded");
    run_.files.course = course::read_bundled(Bundled::kCourses, "3");
    run_.setup = config::parse_run(run_.files);
  }
  Json list() const { return Json::parse(setup_list(files_, run_)); }
  static Json entry(const Json& all, const std::string& name) {
    for (const Json& each : all)
      if (each["name"] == name) return each;
    ADD_FAILURE() << name << " is not listed";
    return {};
  }
  config::LoadedRun run_;
};

TEST_F(SetupListTest, SaysOfACourseWhatIsToBeShown) {
  const Json all = list();
  EXPECT_EQ(all["course"], "3");
  EXPECT_EQ(all["robot"], "end-loaded");
  const Json course = entry(all["courses"], "3");
  EXPECT_EQ(course["from"], "bundled");
  EXPECT_EQ(course["in_force"], true);
  EXPECT_EQ(course["why_not"], "");
  EXPECT_NEAR(course["length_m"], 4.0566, 1e-4);
  EXPECT_NEAR(course["duration_s"], 41.5, 0.1);
  EXPECT_EQ(course["obstacles"].size(), 2u);
  EXPECT_EQ(course["obstacles"][0]["kind"], "ramp");
  EXPECT_LE(course["outline"].size(), kMaxOutline);
  EXPECT_EQ(entry(all["robots"], "worn")["in_force"], false);
  EXPECT_EQ(entry(all["courses"], "calibrate-spin-left")["length_m"], 0.0);
  EXPECT_EQ(all["calibration"].size(), 9u);
  for (const Json& name : all["calibration"])
    EXPECT_EQ(entry(all["courses"], name)["identifies"], true) << name;
}

TEST_F(SetupListTest, SaysWhyACourseDoesNotFitTheRobot) {
  write("wall.toml", std::string(kLine) +
                         "[[block]]\nx_m = 0.2\ny_m = 0.0\nheight_m = 0.3\ndepth_m = 0.1\n"
                         "width_m = 0.4\n");
  write("torn.toml", "speed_mps = \n");
  std::string fast = kLine;
  fast.replace(fast.find("0.1"), 3, "0.3");
  write("fast.toml", fast);
  const Json all = list();
  EXPECT_THAT(std::string(entry(all["courses"], "wall")["why_not"]), HasSubstr("block"));
  EXPECT_THAT(std::string(entry(all["courses"], "torn")["why_not"]), HasSubstr("torn.toml:1:"));
  EXPECT_THAT(std::string(entry(all["courses"], "fast")["why_not"]), HasSubstr("max_track_mps"));
  EXPECT_EQ(all.dump().find(folder_.path().string()), std::string::npos)
      << "viewers get no path of this machine";
}

TEST(CheckedFile, NamesTheFirstErrorWithItsPlaceOrTheLengthAndTime) {
  const config::LoadedRun run;
  const auto check = [&](const std::string& text) {
    return Json::parse(checked_file(run, Bundled::kCourses, {"mine.toml", text}).json);
  };
  std::string text = kLine;
  text.replace(text.find("0.3"), 3, "300");
  const Json bad = check(text);
  EXPECT_EQ(bad["line"], 5);
  EXPECT_GT(bad["column"], 0);
  EXPECT_THAT(std::string(bad["error"]), ::testing::StartsWith("'segment.length_m' is 300"));
  const Json right = check(kLine);
  EXPECT_EQ(right["error"], "");
  EXPECT_NEAR(right["length_m"], 0.3, 1e-9);
  EXPECT_EQ(right["course"]["segments"][0]["end"]["x_m"], right["length_m"]);
  EXPECT_NE(check("a = [")["error"], "");
}

// Whoever draws a course sees it also while its path leaves the fence.
TEST(CheckedFile, DrawsACourseWhosePiecesDoNotFitTogether) {
  const config::LoadedRun run;
  const auto check = [&](const std::string& text) {
    return Json::parse(checked_file(run, Bundled::kCourses, {"mine.toml", text}).json);
  };
  std::string far = kLine;
  far.replace(far.find("0.3"), 3, "9.5");
  for (const auto& [text, error] :
       {std::pair<std::string, const char*>{far, "leaves the fence"},
        {std::string(kLine) + "[[disturbance]]\nat_m = 5.0\n", "only 0.3 m long"},
        {std::string(kLine) + "speed = 1\n", "unknown key"}}) {
    const Json drawn = check(text);
    EXPECT_THAT(std::string(drawn["error"]), HasSubstr(error));
    EXPECT_EQ(drawn["course"]["segments"].size(), 1u) << error;
    EXPECT_GT(drawn["course"]["path"].size(), 10u) << error;
  }
  far.replace(far.find("9.5"), 3, "999");
  EXPECT_FALSE(check(far).contains("course"));
}

}  // namespace
}  // namespace tp100::live
