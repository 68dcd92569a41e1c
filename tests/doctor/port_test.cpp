// What the doctor says of the port: which it is, who holds it, who may use it, and what USB and
// ModemManager do.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

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

TEST_F(Port, IsTheOneThatIsOpenOrIsFoundBehindALink) {
  EXPECT_EQ(choose_port(fake_.system(), "auto", {}, kDevice).device, kDevice);
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

TEST_F(Port, WithoutAStableNameIsNotedUnlessItIsAPseudoTerminal) {
  expect_finding(choose_port(fake_.system(), "auto", {FakeSystem::mega()}).findings, "by-id",
                 Severity::kNote, "", "link.port");
  fake_.write("/dev/robot", "");
  const ChosenPort unknown = choose_port(fake_.system(), "/dev/robot", {});
  EXPECT_FALSE(unknown.pseudo_terminal);
  expect_finding(unknown.findings, "by-id", Severity::kNote);
  const PtyPair pty;
  const ChosenPort pseudo_terminal = choose_port(System(), pty.near(), {});
  EXPECT_TRUE(pseudo_terminal.pseudo_terminal);
  EXPECT_EQ(pseudo_terminal.findings.size(), 1U);
  expect_finding(pseudo_terminal.findings, "device", Severity::kOk);
}

// The other board was plugged in while the daemon had the robot's port.
TEST_F(Port, OneOfSeveralIsBestNamedByItsStableName) {
  fake_.link("/dev/serial/by-id/usb-Arduino-7583", "../../ttyACM0");
  const std::vector<link::PortInfo> two = {FakeSystem::mega(), FakeSystem::mega("/dev/ttyACM1")};
  expect_finding(choose_port(fake_.system(), "auto", two, kDevice).findings, "by-id",
                 Severity::kWarning, "", "link.port = \"/dev/serial/by-id/usb-Arduino-7583\"");
}

TEST_F(Port, ThatIsHeldNamesItsHolderIfThisAccountCanSeeIt) {
  expect_finding(holder_findings(fake_.system(), kDevice), "holder", Severity::kOk);
  fake_.process("999999999", "minicom");
  fake_.opens("999999999", kDevice);
  expect_finding(holder_findings(fake_.system(), kDevice), "holder", Severity::kError,
                 "/dev/ttyACM0: held open by minicom (pid 999999999)", "end that program");
  if (::geteuid() != 0) GTEST_SKIP() << "only root can look as somebody else; run it as root";
  fake_.mode("/", 0755);
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

TEST_F(Port, MayBePutToSleepOrKeepBytesBackOrBeBehindACh340) {
  const auto findings = [&] { return usb_findings(fake_.system(), kDevice, FakeSystem::mega()); };
  EXPECT_THAT(findings(), IsEmpty());
  const std::string power = FakeSystem::kUsb + "/power/control";
  fake_.write(power, "on\n");
  expect_finding(findings(), "autosuspend", Severity::kOk);
  fake_.write(power, "auto\n");
  expect_finding(findings(), "autosuspend", Severity::kWarning, "", "echo on | sudo tee " + power);
  const std::string timer = FakeSystem::kUsb + "/1-1:1.0/latency_timer";
  fake_.link(FakeSystem::kUsb + "/1-1:1.0/tty/ttyACM0/device", "../..");
  fake_.write(timer, "16\n");
  expect_finding(findings(), "latency-timer", Severity::kWarning, "16 ms",
                 "echo 1 | sudo tee /sys/class/tty/ttyACM0/device/latency_timer");
  fake_.write(timer, "1\n");
  expect_finding(findings(), "latency-timer", Severity::kOk);
  const link::PortInfo clone{kDevice, 0x1a86, 0x7523, "", ""};
  expect_finding(usb_findings(fake_.system(), kDevice, clone), "bridge", Severity::kNote, "CH340");
}

/// A device that belongs to the default group of new files; alice is not a member.
class Permission : public testing::Test {
 protected:
  Permission() {
    fake_.plug_in_mega();
    fake_.mode(kDevice, 0660);
    write_group("");
  }
  void write_group(const std::string& members) {
    fake_.write("/etc/group", "root:x:99991:\ndialout:x:" + std::to_string(gid()) + ":" + members +
                                  "\nusers:x:99992:alice\n");
  }
  gid_t gid() const { return fake_.system().device(kDevice)->gid; }
  /// The only finding for an account to which the kernel denies access.
  Findings look(const Account& account) const {
    Findings findings = permission_findings(fake_.system(), kDevice, account, false);
    EXPECT_EQ(findings.size(), 1U);
    return findings;
  }
  Account alice() const { return {"alice", {gid() + 1}}; }

  FakeSystem fake_;
};

TEST_F(Permission, ThatIsMissingIsAnErrorThatSaysHowToGetIt) {
  expect_finding(look(alice()), "permission", Severity::kError, "alice is not in group dialout",
                 "sudo adduser alice dialout");
  // Alice is in the group, but her session began before.
  write_group("bob,alice");
  expect_finding(look(alice()), "group", Severity::kError, "", "log out and in again");
  expect_finding(look(alice()), "group", Severity::kError, "", "newgrp dialout");
  // The session has the group, too: an access list forbids it.
  Account account = alice();
  account.groups.push_back(gid());
  expect_finding(look(account), "permission", Severity::kError, "", "getfacl /dev/ttyACM0");
  // The group is the administrator's.
  fake_.write("/etc/group", "root:x:" + std::to_string(gid()) + ":\n");
  expect_finding(look(alice()), "permission", Severity::kError,
                 "group root, which is not for users", "chgrp dialout");
  write_group("");
  // The group itself has no permission.
  fake_.mode(kDevice, 0600);
  expect_finding(look(alice()), "permission", Severity::kError, "mode 0600", "plug it in again");
}

// udev lets the user at the machine in by an access list, which mode and groups do not show.
TEST_F(Permission, IsTheKernelsToSay) {
  EXPECT_EQ(permission_findings(fake_.system(), kDevice, alice(), true).at(0).severity,
            Severity::kOk);
  if (::geteuid() != 0) GTEST_SKIP() << "only root can look as somebody else; run it as root";
  fake_.mode("/", 0755);
  for (const mode_t mode : {0660U, 0662U, 0664U, 0666U}) {
    fake_.mode(kDevice, mode);
    const test::AsNobody as_nobody;
    EXPECT_EQ(fake_.system().usable(kDevice), mode == 0666) << mode;
  }
}

}  // namespace
}  // namespace tp100::doctor
