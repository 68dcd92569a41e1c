// `tp100d doctor` on emulated robots with defects: the real programs, connected by a
// pseudo-terminal.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "doctor_rig.h"

namespace tp100::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST_F(Doctor, FindsNothingThatKeepsAGoodRobotFromDriving) {
  start_robot({});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 0) << examined.report.dump();
  EXPECT_EQ(examined.report.at("errors"), 0);
  EXPECT_THAT(examined.line("firmware"),
              HasSubstr("ok firmware: an emulated board, firmware 0.1.0"));
  const Finished here = run({"tp100d", "doctor", "--port", std::filesystem::relative(port())});
  EXPECT_EQ(here.status, 0) << "the port's relative path must work: " << here.output;
  for (const char* name :
       {"device", "permission", "battery", "imu", "link", "clock", "real-time", "governor", "disk"})
    EXPECT_FALSE(examined.finding(name).is_null()) << name;
  const json& link = examined.report.at("link");
  EXPECT_GT(link.at("samples"), 0);
  EXPECT_GT(link.at("commands_confirmed"), 0);
  EXPECT_GT(link.at("round_trip_us").at("p50"), 0.0);
  EXPECT_LE(link.at("age_us").at("p50"), link.at("age_us").at("p99"));
  expect_motors_never_on();
}

TEST_F(Doctor, PrintsATableWithTheCountsAtItsEnd) {
  start_robot({});
  const Finished finished = run({"tp100d", "doctor", "--port", port(), "--link-test", "0"});
  EXPECT_EQ(finished.status, 0) << finished.output;
  EXPECT_THAT(finished.output, AllOf(HasSubstr("ok       firmware"), HasSubstr("0 errors, ")));
}

TEST_F(Doctor, MissesAPortThatIsNotThere) {
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("device"), HasSubstr("no such port; plug the robot in"));
}

TEST_F(Doctor, NamesWhoHoldsThePort) {
  start_robot({});
  Process holder({"tp100d", "run", "--port", port(), "--listen", "off"});
  ASSERT_TRUE(holder.wait_for("-> ready")) << holder.output();
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("open"), AllOf(HasSubstr("error open"), HasSubstr("port is busy")));
}

TEST_F(Doctor, HearsThatARobotIsSilent) {
  start_robot({"--fault", "cut:to-host"});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("firmware"), HasSubstr("error firmware: " + port() + ": silent"));
}

TEST_F(Doctor, AsksForFlashingAFirmwareOfAnotherProtocol) {
  start_robot({"--fault", "version:9"});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("firmware"),
              AllOf(HasSubstr("error"), HasSubstr("protocol 9"), HasSubstr("scripts/flash")));
}

TEST_F(Doctor, CountsRestartsOfABoard) {
  start_robot({"--fault", "reboot-loop:0.3"});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("reboots"), HasSubstr("error reboots: the board restarted"));
}

TEST_F(Doctor, FindsAnEmptyBattery) {
  start_robot({"--fault", "battery:5.5"});
  EXPECT_THAT(examine().line("battery"),
              AllOf(HasSubstr("error battery: 5.5 V"), HasSubstr("charge the battery")));
}

TEST_F(Doctor, FindsAMissingGyro) {
  start_robot({"--fault", "imu-missing"});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("fault"), HasSubstr("error fault: imu_missing"));
}

TEST_F(Doctor, CountsCorruptedFrames) {
  start_robot({"--fault", "flip:0.002"});
  const Examined examined = examine();
  EXPECT_THAT(examined.line("link"), HasSubstr("use a short cable"));
  EXPECT_GT(examined.report.at("link").at("crc_errors").get<int>() +
                examined.report.at("link").at("cobs_errors").get<int>(),
            0);
}

TEST_F(Doctor, NamesWhoListensOnThePagesPort) {
  const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), size), 0);
  ASSERT_EQ(::listen(listener, 1), 0);
  ASSERT_EQ(::getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
  const std::string number = std::to_string(ntohs(address.sin_port));
  write_bytes(folder_.file("page.toml"), "[server]\nlisten = \"127.0.0.1:" + number + "\"\n");
  const Examined examined = examine({"--config", folder_.file("page.toml")});
  EXPECT_THAT(examined.line("page-port"), HasSubstr("warning page-port: TCP port " + number));
  EXPECT_THAT(examined.line("page-port"), HasSubstr("(pid " + std::to_string(getpid()) + ")"));
  ::close(listener);
}

TEST_F(Doctor, TriesTheFolderOfTheRecordings) {
  write_bytes(folder_.file("disk.toml"), "[record]\ndirectory = \"/proc/self/runs\"\n");
  EXPECT_THAT(examine({"--config", folder_.file("disk.toml")}).line("disk"),
              AllOf(HasSubstr("warning disk: /proc/"), HasSubstr("cannot be written")));
}

TEST_F(Doctor, RefusesBadUsage) {
  for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{
           {"--link-test", "-1"}, {"--robot", "no-such-robot"}, {"--config", "no-such-file"}}) {
    std::vector<std::string> arguments = {"tp100d", "doctor"};
    arguments.insert(arguments.end(), bad.begin(), bad.end());
    const Finished finished = run(arguments);
    EXPECT_EQ(finished.status, 2) << bad[0] << ": " << finished.output;
    EXPECT_EQ(lines(finished.output), 1U) << finished.output;
  }
  EXPECT_THAT(run({"tp100d", "docter"}).output, HasSubstr("did you mean 'doctor'?"));
}

#ifdef TP100_HAS_IMAGE
TEST_F(Doctor, ExaminesTheFirmwareItself) {
  start_robot({"--board", "avr"});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 0) << examined.report.dump();
  EXPECT_THAT(examined.line("firmware"), HasSubstr("ok firmware: a Mega 2560"));
}

TEST_F(Doctor, FindsABoardWithNothingButItsBootloader) {
  start_robot({"--board", "avr", "--blank"});
  const Examined examined = examine();
  EXPECT_EQ(examined.status, 1);
  EXPECT_THAT(examined.line("bootloader"),
              HasSubstr("only the bootloader answers; scripts/flash --port " + port()));
}
#endif

}  // namespace
}  // namespace tp100::test
