// What the doctor says of the machine: privileges, clock, processors, the page's port and the disk.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "doctor/host_checks.h"
#include "fake_system.h"

namespace tp100::doctor {
namespace {

using test::expect_finding;
using test::FakeSystem;
using ::testing::IsEmpty;

constexpr const char* kClock = "/sys/devices/system/clocksource/clocksource0/";

TEST(Host, WithoutAPrivilegeSaysHowToGetIt) {
  const Findings findings = real_time_findings(
      {{"memory locked", true, ""}, {"SCHED_FIFO 80", false, "set rtprio to 90"}});
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].severity, Severity::kOk);
  EXPECT_EQ(findings[1].severity, Severity::kWarning);
  EXPECT_EQ(findings[1].seen, "not granted: SCHED_FIFO 80");
  EXPECT_EQ(findings[1].fix, "set rtprio to 90");
}

TEST(Host, WithAPoorClockSourceNamesABetterOne) {
  FakeSystem fake;
  const auto findings = [&] { return clock_source_findings(fake.system()); };
  EXPECT_THAT(findings(), IsEmpty());
  fake.write(std::string(kClock) + "current_clocksource", "tsc\n");
  expect_finding(findings(), "clock-source", Severity::kOk);
  fake.write(std::string(kClock) + "current_clocksource", "hpet\n");
  fake.write(std::string(kClock) + "available_clocksource", "hpet acpi_pm \n");
  expect_finding(findings(), "clock-source", Severity::kWarning, "", "tsc=reliable");
  fake.write(std::string(kClock) + "available_clocksource", "hpet tsc acpi_pm \n");
  expect_finding(findings(), "clock-source", Severity::kWarning, "",
                 "echo tsc | sudo tee " + std::string(kClock));
}

TEST(Host, WhoseProcessorsSlowDownIsWarnedOf) {
  FakeSystem fake;
  const auto findings = [&] { return governor_findings(fake.system()); };
  expect_finding(findings(), "governor", Severity::kOk);
  fake.write("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "performance\n");
  fake.write("/sys/devices/system/cpu/cpufreq/boost", "1\n");
  expect_finding(findings(), "governor", Severity::kOk);
  fake.write("/sys/devices/system/cpu/cpu1/cpufreq/scaling_governor", "powersave\n");
  expect_finding(findings(), "governor", Severity::kWarning, "powersave",
                 "echo performance | sudo tee");
}

TEST(Host, WhoHasMoreToDoThanProcessorsIsWarnedOf) {
  FakeSystem fake;
  const auto findings = [&] { return load_findings(fake.system()); };
  EXPECT_TRUE(findings().empty());
  fake.write("/proc/loadavg", "1.99 9.00 9.00 3/400 1234\n");
  fake.write("/sys/devices/system/cpu/cpu0/online", "1\n");
  fake.write("/sys/devices/system/cpu/cpu1/online", "1\n");
  expect_finding(findings(), "load", Severity::kOk, "2 processors");
  fake.write("/proc/loadavg", "5.12 1.00 1.00 3/400 1234\n");
  expect_finding(findings(), "load", Severity::kWarning, "5.1 programs want 2", "top");
}

TEST(Host, WhosePagePortIsTakenNamesTheProgram) {
  FakeSystem fake;
  const std::string head = "  sl  local_address rem_address   st tx_queue rx_queue ...\n";
  const std::string rest = " 00:00000000 00000000  1000 0 4711 1\n";
  // Port 8766 is listening; 8765 is only one end of a connection.
  fake.write("/proc/net/tcp", head + "   0: 0100007F:223E 00000000:0000 0A 00000000:00000000" +
                                  rest + "   1: 0100007F:223D 0100007F:9000 01 00000000:00000000" +
                                  rest);
  expect_finding(page_port_findings(fake.system(), 8765), "page-port", Severity::kOk);
  fake.write("/proc/net/tcp6", head +
                                   "   0: 00000000000000000000000001000000:223D "
                                   "00000000000000000000000000000000:0000 0A 00000000:00000000" +
                                   rest);
  fake.process("999999999", "foxglove");
  fake.opens("999999999", "socket:[4711]");
  expect_finding(page_port_findings(fake.system(), 8765), "page-port", Severity::kWarning,
                 "TCP port 8765 of the page is taken by foxglove (pid 999999999)", "--listen");
}

TEST(Host, WhoseDiskIsSlowFullOrClosedIsWarnedOf) {
  expect_finding(disk_findings({"/runs", 200.0, 9000.0, ""}), "disk", Severity::kOk);
  expect_finding(disk_findings({"/runs", 3.0, 9000.0, ""}), "disk", Severity::kWarning,
                 "slow, 3 MB/s", "record.directory");
  expect_finding(disk_findings({"/runs", 200.0, 90.0, ""}), "disk", Severity::kWarning, "",
                 "delete old recordings");
  expect_finding(disk_findings({"/runs", 0.0, 0.0, "Read-only file system"}), "disk",
                 Severity::kWarning, "Read-only file system");
}

}  // namespace
}  // namespace tp100::doctor
