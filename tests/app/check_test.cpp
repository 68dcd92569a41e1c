#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "../support/temporary_folder.h"
#include "app/commands.h"
#include "core/error.h"
#include "support/paths.h"
#include "support/refusal.h"

namespace tp100::app {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(FileKind, IsToldByTheKeysEvenIfSomeAreMistyped) {
  EXPECT_EQ(file_kind("", "f"), FileKind::kConfiguration);
  EXPECT_EQ(file_kind("[loop]\nrate_hz = 100\n", "f"), FileKind::kConfiguration);
  EXPECT_EQ(file_kind("[model]\nmode = 'paper'\n", "f"), FileKind::kConfiguration);
  EXPECT_EQ(file_kind("[model]\nwheelbase_m = 1\n", "f"), FileKind::kRobot);
  EXPECT_EQ(file_kind("[drve]\n", "f"), FileKind::kRobot);
  EXPECT_EQ(file_kind("speeed_mps = 1\n", "f"), FileKind::kCourse);
  EXPECT_EQ(file_kind("delay_sm = 1\n", "f"), FileKind::kCamera);
  EXPECT_EQ(file_kind("[camera]\nheight_m = 3\n", "f"), FileKind::kConfiguration);
  EXPECT_EQ(file_kind("[[segments]]\n[fence]\n", "f"), FileKind::kCourse);
}

TEST(Check, EveryBundledFileIsRight) {
  const std::filesystem::path config = source_path("config");
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(config)) {
    const std::string folder = entry.path().parent_path().filename().string();
    // Other programs check the view file and the campaigns.
    if (entry.path().extension() != ".toml" || entry.path().filename() == "view.toml" ||
        folder == "campaigns")
      continue;
    ++files;
    const std::string kind = folder == "courses"   ? "course " + entry.path().stem().string()
                             : folder == "robots"  ? "robot " + entry.path().stem().string()
                             : folder == "cameras" ? "camera " + entry.path().stem().string()
                                                   : "configuration";
    EXPECT_THAT(check_file(entry.path().string()), StartsWith(kind));
  }
  EXPECT_GE(files, 7);
}

TEST(Check, AFileOfAnotherProgramIsSentThere) {
  const test::TemporaryFolder folder;
  const std::string view = source_path("config/view.toml"),
                    campaign = source_path("config/campaigns/course-3.toml"),
                    least = folder.file("least.toml");
  test::write_bytes(least, "runs = 3\ncourse = '2'\nrobot = 'worn'\nsetup = 'flat'\ncamera = ''\n");
  for (const auto& [path, command] : {std::pair(view, std::string("tp100-camera SOURCE --view")),
                                      {campaign, "run tp100-sim campaign " + campaign},
                                      {least, "run tp100-sim campaign " + least}})
    EXPECT_THAT([file = path] { check_file(file); },
                testing::ThrowsMessage<UserError>(HasSubstr(command)));
}

TEST(Check, AConfigurationMustNameARobotAndACourseThatExist) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("c.toml");
  const auto error_of = [&](const std::string& text) {
    test::write_bytes(path, text);
    return test::refusal([&] { check_file(path); });
  };
  EXPECT_THAT(error_of("robot = 'nobody'\n"), HasSubstr("nobody: no such robot"));
  EXPECT_THAT(error_of("course = 'nowhere'\n"), HasSubstr("nowhere: no such course"));
  EXPECT_EQ(error_of("course = '2'\n"), "");
  EXPECT_THAT(error_of("speed_mps = 3.5\n"), HasSubstr("c.toml:1:13: 'speed_mps' is 3.5, allowed"));
}

TEST(Check, TheExitStatusIs2IfAnyFileIsWrong) {
  const std::string good = source_path("config/courses/2.toml");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_check({good}), 0);
  EXPECT_EQ(run_check({"/nowhere/x.toml", good}), 2);
  const std::string out = testing::internal::GetCapturedStdout();
  const std::string err = testing::internal::GetCapturedStderr();
  EXPECT_THAT(out, HasSubstr("2.toml: OK, course 2: 3.0712"));
  EXPECT_THAT(err, StartsWith("/nowhere/x.toml: cannot be opened"));
  EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1);
}

TEST(Check, AsJsonTellsWhereACourseLies) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(run_check({source_path("config/courses/3.toml")}, true), 0);
  const auto json = nlohmann::json::parse(testing::internal::GetCapturedStdout());
  EXPECT_EQ(json["error"], "");
  EXPECT_NEAR(json["duration_s"], 41.5, 0.1);
  EXPECT_NEAR(json["course"]["path"].back()["y_m"], -0.8, 1e-9);
  EXPECT_EQ(json["course"]["obstacles"].size(), 2U);
  EXPECT_EQ(run_check({source_path("config/robots/worn.toml")}, true), 2);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("worn.toml:"));
}

TEST(Ports, GivesTheLineToCopyForALikelyRobot) {
  link::PortInfo mega{"/dev/ttyACM0", 0x2341, 0x0042, "7583", "Mega"};
  const std::string text = ports_text({mega}, {"/dev/serial/by-id/usb-Arduino-7583"}, {});
  EXPECT_THAT(text, HasSubstr("/dev/ttyACM0  2341:0042  Arduino Mega 2560, serial 7583\n"));
  EXPECT_THAT(text, HasSubstr("port = \"/dev/serial/by-id/usb-Arduino-7583\"\n"));
}

TEST(Ports, FallsBackToThePathAndDoesNotAdviseOtherPorts) {
  link::PortInfo bridge{"/dev/ttyUSB0", 0x1a86, 0x7523, "", ""};
  link::PortInfo other{"/dev/ttyS0", -1, -1, "", ""};
  const std::string text = ports_text({bridge, other}, {"", ""}, {});
  EXPECT_THAT(text, HasSubstr("port = \"/dev/ttyUSB0\""));
  EXPECT_THAT(text, HasSubstr("/dev/ttyS0  -  serial port\n"));
  EXPECT_THAT(text, testing::Not(HasSubstr("port = \"/dev/ttyS0\"")));
  EXPECT_THAT(ports_text({}, {}, {}), HasSubstr("no serial ports; plug the robot in"));
}

TEST(Ports, SaysWhyAutoPassesAPortOverAndWhatToDo) {
  link::PortInfo bridge{"/dev/ttyUSB0", 0x1a86, 0x7523, "", ""};
  const std::string text = ports_text({bridge}, {""}, {{bridge, "held open by octoprint (pid 7)"}});
  EXPECT_THAT(text, HasSubstr("port = \"/dev/ttyUSB0\"\n    auto skips it: held open by "
                              "octoprint (pid 7); if it is the robot, name it with --port or "
                              "link.port\n"));
}

}  // namespace
}  // namespace tp100::app
