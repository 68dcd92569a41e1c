#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/commands.h"

namespace tp100::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Ports, GivesTheLineToCopyForALikelyRobot) {
  link::PortInfo mega{"/dev/ttyACM0", 0x2341, 0x0042, "7583", "Arduino", "Mega"};
  const std::string text = ports_text({mega}, {"/dev/serial/by-id/usb-Arduino-7583"}, {});
  EXPECT_THAT(text, HasSubstr("/dev/ttyACM0  2341:0042  Arduino Mega 2560, serial 7583\n"));
  EXPECT_THAT(text, HasSubstr("port = \"/dev/serial/by-id/usb-Arduino-7583\"\n"));
}

TEST(Ports, FallsBackToThePathAndDoesNotAdviseOtherPorts) {
  link::PortInfo bridge{"/dev/ttyUSB0", 0x1a86, 0x7523, "", "", ""};
  link::PortInfo other{"/dev/ttyS0", -1, -1, "", "", ""};
  const std::string text = ports_text({bridge, other}, {"", ""}, {});
  EXPECT_THAT(text, HasSubstr("port = \"/dev/ttyUSB0\""));
  EXPECT_THAT(text, HasSubstr("/dev/ttyS0  -  serial port\n"));
  EXPECT_THAT(text, Not(HasSubstr("port = \"/dev/ttyS0\"")));
}

TEST(Ports, SaysWhyAutoPassesAPortOverAndWhatToDo) {
  link::PortInfo bridge{"/dev/ttyUSB0", 0x1a86, 0x7523, "", "", ""};
  const std::string text = ports_text({bridge}, {""}, {{bridge, "held open by octoprint (pid 7)"}});
  EXPECT_THAT(text, HasSubstr("port = \"/dev/ttyUSB0\"\n    auto skips it: held open by "
                              "octoprint (pid 7); if it is the robot, name it with --port or "
                              "link.port\n"));
}

TEST(Ports, SaysSoIfThereAreNone) {
  EXPECT_THAT(ports_text({}, {}, {}), HasSubstr("no serial ports; plug the robot in"));
}

}  // namespace
}  // namespace tp100::app
