#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../link/pty_pair.h"
#include "../support/as_nobody.h"
#include "doctor/port_checks.h"
#include "fake_system.h"

namespace tp100::doctor {
namespace {

using test::FakeSystem;
using test::find;
using test::kDevice;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Port : public testing::Test {
 protected:
  Port() { fake_.plug_in_mega(); }
  FakeSystem fake_;
};

TEST_F(Port, IsTheOnlyBoardWithItsStableName) {
  fake_.link("/dev/serial/by-id/usb-Arduino-7583", "../../ttyACM0");
  const ChosenPort port = choose_port(fake_.system(), "auto", {FakeSystem::mega()});
  EXPECT_EQ(port.device, kDevice);
  EXPECT_FALSE(port.pseudo_terminal);
  EXPECT_EQ(count(port.findings, Severity::kOk), port.findings.size());
  EXPECT_EQ(find(port.findings, "device").seen, "/dev/ttyACM0: Arduino Mega 2560, serial 7583");
  EXPECT_EQ(find(port.findings, "by-id").seen, "/dev/serial/by-id/usb-Arduino-7583");
}

TEST_F(Port, IsTheOneThatIsOpenWhateverElseIsPluggedIn) {
  const ChosenPort port = choose_port(fake_.system(), "auto", {}, kDevice);
  EXPECT_EQ(port.path, kDevice);
  EXPECT_EQ(port.device, kDevice);
}

TEST_F(Port, IsFoundBehindALink) {
  fake_.link("/dev/robot", "ttyACM0");
  const ChosenPort port = choose_port(fake_.system(), "/dev/robot", {FakeSystem::mega()});
  EXPECT_EQ(port.path, "/dev/robot");
  EXPECT_EQ(port.device, kDevice);
  EXPECT_EQ(port.info.serial, "7583");
}

TEST_F(Port, IsMissingIfNothingIsPluggedIn) {
  const ChosenPort port = choose_port(fake_.system(), "auto", {});
  EXPECT_EQ(port.device, "");
  EXPECT_EQ(find(port.findings, "device").severity, Severity::kError);
  EXPECT_THAT(find(port.findings, "device").fix, HasSubstr("plug the robot in"));
}

TEST_F(Port, IsMissingIfItsNameLeadsToAFolder) {
  const ChosenPort port = choose_port(fake_.system(), "/dev", {FakeSystem::mega()});
  EXPECT_EQ(port.device, "");
  EXPECT_THAT(find(port.findings, "device").seen, HasSubstr("/dev: no port, but a folder"));
}

TEST_F(Port, IsMissingIfItsNameLeadsNowhere) {
  const ChosenPort port = choose_port(fake_.system(), "/dev/ttyACM7", {FakeSystem::mega()});
  EXPECT_EQ(port.device, "");
  EXPECT_EQ(find(port.findings, "device").severity, Severity::kError);
  EXPECT_THAT(find(port.findings, "device").seen, HasSubstr("/dev/ttyACM7: no such port"));
}

TEST_F(Port, WithoutAStableNameIsNoted) {
  const ChosenPort port = choose_port(fake_.system(), "auto", {FakeSystem::mega()});
  EXPECT_EQ(find(port.findings, "by-id").severity, Severity::kNote);
  EXPECT_THAT(find(port.findings, "by-id").fix, HasSubstr("link.port"));
}

TEST_F(Port, OneOfSeveralMustBeNamed) {
  fake_.link("/dev/serial/by-id/usb-Arduino-7583", "../../ttyACM0");
  const std::vector<link::PortInfo> two = {FakeSystem::mega(), FakeSystem::mega("/dev/ttyACM1")};
  const ChosenPort none = choose_port(fake_.system(), "auto", two);
  EXPECT_EQ(find(none.findings, "device").severity, Severity::kError);
  EXPECT_THAT(find(none.findings, "device").fix, HasSubstr("name it with --port or link.port"));
  // The other one was plugged in while the daemon had the robot's port.
  const ChosenPort port = choose_port(fake_.system(), "auto", two, kDevice);
  EXPECT_EQ(find(port.findings, "by-id").severity, Severity::kWarning);
  EXPECT_THAT(find(port.findings, "by-id").fix,
              HasSubstr("link.port = \"/dev/serial/by-id/usb-Arduino-7583\""));
}

TEST_F(Port, ThatIsNamedAnyhowIsStillAPort) {
  fake_.write("/dev/robot", "");
  const ChosenPort port = choose_port(fake_.system(), "/dev/robot", {});
  EXPECT_FALSE(port.pseudo_terminal);
  EXPECT_EQ(find(port.findings, "by-id").severity, Severity::kNote);
}

TEST_F(Port, ThatAutoPassesOverSaysWhy) {
  fake_.process("999999999", "octoprint");
  fake_.opens("999999999", kDevice);
  const ChosenPort port = choose_port(fake_.system(), "auto", {FakeSystem::mega()});
  EXPECT_EQ(port.device, "");
  EXPECT_EQ(find(port.findings, "device").severity, Severity::kError);
  EXPECT_EQ(find(port.findings, "device").seen,
            "auto skips /dev/ttyACM0: held open by octoprint (pid 999999999)");
  EXPECT_THAT(find(port.findings, "device").fix, HasSubstr("name it with --port"));
}

TEST_F(Port, ThatIsAPseudoTerminalHasNoStableName) {
  const PtyPair pty;
  const ChosenPort port = choose_port(System(), pty.near(), {});
  EXPECT_TRUE(port.pseudo_terminal);
  EXPECT_EQ(port.findings.size(), 1U);
  EXPECT_EQ(find(port.findings, "device").severity, Severity::kOk);
}

TEST_F(Port, ThatIsHeldNamesItsHolder) {
  EXPECT_EQ(find(holder_findings(fake_.system(), kDevice), "holder").severity, Severity::kOk);
  fake_.process("999999999", "minicom");
  fake_.opens("999999999", kDevice);
  const Finding held = find(holder_findings(fake_.system(), kDevice), "holder");
  EXPECT_EQ(held.severity, Severity::kError);
  EXPECT_EQ(held.seen, "/dev/ttyACM0: held open by minicom (pid 999999999)");
  EXPECT_THAT(held.fix, HasSubstr("end that program"));
}

TEST_F(Port, ThatAnotherAccountMayHoldIsNotCalledFree) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can look as somebody else; run it as root";
  ASSERT_EQ(::chmod(fake_.system().file("/").c_str(), 0755), 0);
  fake_.process("999999999", "tp100d");
  fake_.opens("999999999", kDevice);
  fake_.mode("/proc/999999999/fd", 0700);
  const test::AsNobody as_nobody;
  EXPECT_EQ(find(holder_findings(fake_.system(), kDevice), "holder").seen,
            "/dev/ttyACM0: no other program of this account has it open");
}

TEST_F(Port, IsProbedByAModemManagerThatRuns) {
  const auto finding = [&] {
    return find(modem_manager_findings(fake_.system(), kDevice, FakeSystem::mega()),
                "modem-manager");
  };
  EXPECT_EQ(finding().severity, Severity::kOk);
  fake_.process("41", "ModemManager");
  EXPECT_EQ(finding().severity, Severity::kWarning);
  EXPECT_THAT(finding().fix, HasSubstr("ATTRS{idVendor}==\"2341\", ATTRS{idProduct}==\"0042\""));
  EXPECT_THAT(finding().fix, HasSubstr("ENV{ID_MM_PORT_IGNORE}=\"1\""));
  const Finding unknown =
      find(modem_manager_findings(fake_.system(), kDevice, {}), "modem-manager");
  EXPECT_EQ(unknown.severity, Severity::kWarning);
  EXPECT_THAT(unknown.fix, HasSubstr("systemctl disable --now ModemManager"));
}

TEST_F(Port, IsLeftAloneByAModemManagerThatUdevTold) {
  fake_.process("41", "ModemManager");
  fake_.write("/run/udev/data/c189:3", "E:ID_VENDOR_ID=2341\nE:ID_MM_DEVICE_IGNORE=1\n");
  EXPECT_EQ(
      find(modem_manager_findings(fake_.system(), kDevice, FakeSystem::mega()), "modem-manager")
          .severity,
      Severity::kOk);
}

TEST_F(Port, MayBePutToSleep) {
  const auto finding = [&] {
    return find(usb_findings(fake_.system(), kDevice, FakeSystem::mega()), "autosuspend");
  };
  const std::string file = FakeSystem::kUsb + "/power/control";
  fake_.write(file, "on\n");
  EXPECT_EQ(finding().severity, Severity::kOk);
  fake_.write(file, "auto\n");
  EXPECT_EQ(finding().severity, Severity::kWarning);
  EXPECT_EQ(finding().fix, "echo on | sudo tee " + file);
}

TEST_F(Port, MayKeepBytesBack) {
  fake_.write(FakeSystem::kUsb + "/1-1:1.0/latency_timer", "16\n");
  fake_.link(FakeSystem::kUsb + "/1-1:1.0/tty/ttyACM0/device", "../..");
  const auto finding = [&] {
    return find(usb_findings(fake_.system(), kDevice, FakeSystem::mega()), "latency-timer");
  };
  EXPECT_EQ(finding().severity, Severity::kWarning);
  EXPECT_THAT(finding().seen, HasSubstr("16 ms"));
  EXPECT_EQ(finding().fix, "echo 1 | sudo tee /sys/class/tty/ttyACM0/device/latency_timer");
  fake_.write(FakeSystem::kUsb + "/1-1:1.0/latency_timer", "1\n");
  EXPECT_EQ(finding().severity, Severity::kOk);
}

TEST_F(Port, BehindACh340IsNoted) {
  const link::PortInfo clone{kDevice, 0x1a86, 0x7523, "", "", ""};
  const Finding bridge = find(usb_findings(fake_.system(), kDevice, clone), "bridge");
  EXPECT_EQ(bridge.severity, Severity::kNote);
  EXPECT_THAT(bridge.seen, HasSubstr("CH340"));
  EXPECT_THAT(usb_findings(fake_.system(), kDevice, FakeSystem::mega()), IsEmpty());
}

}  // namespace
}  // namespace tp100::doctor
