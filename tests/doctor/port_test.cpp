#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../link/pty_pair.h"
#include "../support/as_nobody.h"
#include "doctor/port_checks.h"
#include "fake_system.h"

namespace tp100::doctor {
namespace {

using test::expect_finding;
using test::FakeSystem;
using test::find;
using test::kDevice;
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

TEST_F(Port, ThatIsMissingSaysWhy) {
  const auto expect_none = [&](const std::string& name, const std::vector<link::PortInfo>& there,
                               const std::string& seen, const std::string& fix) {
    const ChosenPort port = choose_port(fake_.system(), name, there);
    EXPECT_EQ(port.device, "");
    expect_finding(port.findings, "device", Severity::kError, seen, fix);
  };
  const link::PortInfo mega = FakeSystem::mega();
  expect_none("auto", {}, "", "plug the robot in");
  expect_none("/dev", {mega}, "/dev: no port, but a folder", "");
  expect_none("/dev/ttyACM7", {mega}, "/dev/ttyACM7: no such port", "");
  expect_none("auto", {mega, FakeSystem::mega("/dev/ttyACM1")}, "",
              "name it with --port or link.port");
  fake_.process("999999999", "octoprint");
  fake_.opens("999999999", kDevice);
  expect_none("auto", {mega}, "auto skips /dev/ttyACM0: held open by octoprint (pid 999999999)",
              "name it with --port");
}

TEST_F(Port, WithoutAStableNameIsNoted) {
  expect_finding(choose_port(fake_.system(), "auto", {FakeSystem::mega()}).findings, "by-id",
                 Severity::kNote, "", "link.port");
  fake_.write("/dev/robot", "");
  const ChosenPort unknown = choose_port(fake_.system(), "/dev/robot", {});
  EXPECT_FALSE(unknown.pseudo_terminal);
  expect_finding(unknown.findings, "by-id", Severity::kNote);
}

// The other board was plugged in while the daemon had the robot's port.
TEST_F(Port, OneOfSeveralIsBestNamedByItsStableName) {
  fake_.link("/dev/serial/by-id/usb-Arduino-7583", "../../ttyACM0");
  const std::vector<link::PortInfo> two = {FakeSystem::mega(), FakeSystem::mega("/dev/ttyACM1")};
  expect_finding(choose_port(fake_.system(), "auto", two, kDevice).findings, "by-id",
                 Severity::kWarning, "", "link.port = \"/dev/serial/by-id/usb-Arduino-7583\"");
}

TEST_F(Port, ThatIsAPseudoTerminalHasNoStableName) {
  const PtyPair pty;
  const ChosenPort port = choose_port(System(), pty.near(), {});
  EXPECT_TRUE(port.pseudo_terminal);
  EXPECT_EQ(port.findings.size(), 1U);
  expect_finding(port.findings, "device", Severity::kOk);
}

TEST_F(Port, ThatIsHeldNamesItsHolder) {
  expect_finding(holder_findings(fake_.system(), kDevice), "holder", Severity::kOk);
  fake_.process("999999999", "minicom");
  fake_.opens("999999999", kDevice);
  expect_finding(holder_findings(fake_.system(), kDevice), "holder", Severity::kError,
                 "/dev/ttyACM0: held open by minicom (pid 999999999)", "end that program");
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

TEST_F(Port, IsProbedByAModemManagerThatRunsUnlessUdevToldIt) {
  const auto findings = [&](const link::PortInfo& info = FakeSystem::mega()) {
    return modem_manager_findings(fake_.system(), kDevice, info);
  };
  expect_finding(findings(), "modem-manager", Severity::kOk);
  fake_.process("41", "ModemManager");
  const std::string rule = "ATTRS{idVendor}==\"2341\", ATTRS{idProduct}==\"0042\"";
  expect_finding(findings(), "modem-manager", Severity::kWarning, "", rule);
  expect_finding(findings(), "modem-manager", Severity::kWarning, "",
                 "ENV{ID_MM_PORT_IGNORE}=\"1\"");
  expect_finding(findings({}), "modem-manager", Severity::kWarning, "",
                 "systemctl disable --now ModemManager");
  fake_.write("/run/udev/data/c189:3", "E:ID_VENDOR_ID=2341\nE:ID_MM_DEVICE_IGNORE=1\n");
  expect_finding(findings(), "modem-manager", Severity::kOk);
}

TEST_F(Port, MayBePutToSleep) {
  const std::string file = FakeSystem::kUsb + "/power/control";
  fake_.write(file, "on\n");
  expect_finding(usb_findings(fake_.system(), kDevice, FakeSystem::mega()), "autosuspend",
                 Severity::kOk);
  fake_.write(file, "auto\n");
  expect_finding(usb_findings(fake_.system(), kDevice, FakeSystem::mega()), "autosuspend",
                 Severity::kWarning, "", "echo on | sudo tee " + file);
}

TEST_F(Port, MayKeepBytesBack) {
  const std::string file = FakeSystem::kUsb + "/1-1:1.0/latency_timer";
  fake_.link(FakeSystem::kUsb + "/1-1:1.0/tty/ttyACM0/device", "../..");
  fake_.write(file, "16\n");
  expect_finding(usb_findings(fake_.system(), kDevice, FakeSystem::mega()), "latency-timer",
                 Severity::kWarning, "16 ms",
                 "echo 1 | sudo tee /sys/class/tty/ttyACM0/device/latency_timer");
  fake_.write(file, "1\n");
  expect_finding(usb_findings(fake_.system(), kDevice, FakeSystem::mega()), "latency-timer",
                 Severity::kOk);
}

TEST_F(Port, BehindACh340IsNoted) {
  const link::PortInfo clone{kDevice, 0x1a86, 0x7523, "", "", ""};
  expect_finding(usb_findings(fake_.system(), kDevice, clone), "bridge", Severity::kNote, "CH340");
  EXPECT_THAT(usb_findings(fake_.system(), kDevice, FakeSystem::mega()), IsEmpty());
}

}  // namespace
}  // namespace tp100::doctor
