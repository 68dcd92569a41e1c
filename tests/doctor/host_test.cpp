#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "doctor/host_checks.h"
#include "fake_system.h"

namespace tp100::doctor {
namespace {

using test::FakeSystem;
using test::find;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kClock = "/sys/devices/system/clocksource/clocksource0/";

TEST(Host, WithoutAPrivilegeSaysHowToGetIt) {
  const Findings findings = real_time_findings(
      {{"memory locked", true, ""}, {"SCHED_FIFO 80", false, "set rtprio to 90"}});
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].severity, Severity::kOk);
  EXPECT_EQ(findings[0].seen, "memory locked");
  EXPECT_EQ(findings[1].severity, Severity::kWarning);
  EXPECT_EQ(findings[1].seen, "not granted: SCHED_FIFO 80");
  EXPECT_EQ(findings[1].fix, "set rtprio to 90");
}

TEST(Host, WithAPoorClockSourceNamesABetterOne) {
  FakeSystem fake;
  EXPECT_THAT(clock_source_findings(fake.system()), IsEmpty());
  fake.write(std::string(kClock) + "current_clocksource", "tsc\n");
  EXPECT_EQ(find(clock_source_findings(fake.system()), "clock-source").severity, Severity::kOk);
  fake.write(std::string(kClock) + "current_clocksource", "hpet\n");
  fake.write(std::string(kClock) + "available_clocksource", "hpet acpi_pm \n");
  Finding poor = find(clock_source_findings(fake.system()), "clock-source");
  EXPECT_EQ(poor.severity, Severity::kWarning);
  EXPECT_THAT(poor.fix, HasSubstr("tsc=reliable"));
  fake.write(std::string(kClock) + "available_clocksource", "hpet tsc acpi_pm \n");
  poor = find(clock_source_findings(fake.system()), "clock-source");
  EXPECT_THAT(poor.fix, HasSubstr("echo tsc | sudo tee " + std::string(kClock)));
}

TEST(Host, WhoseProcessorsSlowDownIsWarnedOf) {
  FakeSystem fake;
  EXPECT_EQ(find(governor_findings(fake.system()), "governor").severity, Severity::kOk);
  fake.write("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "performance\n");
  fake.write("/sys/devices/system/cpu/cpufreq/boost", "1\n");
  EXPECT_EQ(find(governor_findings(fake.system()), "governor").severity, Severity::kOk);
  fake.write("/sys/devices/system/cpu/cpu1/cpufreq/scaling_governor", "powersave\n");
  const Finding slow = find(governor_findings(fake.system()), "governor");
  EXPECT_EQ(slow.severity, Severity::kWarning);
  EXPECT_THAT(slow.seen, HasSubstr("powersave"));
  EXPECT_THAT(slow.fix, HasSubstr("echo performance | sudo tee"));
}

TEST(Host, WhosePagePortIsTakenNamesTheProgram) {
  FakeSystem fake;
  const std::string head = "  sl  local_address rem_address   st tx_queue rx_queue ...\n";
  // Port 8766 is listening; 8765 is only one end of a connection.
  const std::string others =
      "   0: 0100007F:223E 00000000:0000 0A 00000000:00000000 00:00000000 00000000  0 0 11 1\n"
      "   1: 0100007F:223D 0100007F:9000 01 00000000:00000000 00:00000000 00000000  0 0 12 1\n";
  fake.write("/proc/net/tcp", head + others);
  EXPECT_EQ(find(page_port_findings(fake.system(), 8765), "page-port").severity, Severity::kOk);
  fake.write("/proc/net/tcp6",
             head +
                 "   0: 00000000000000000000000001000000:223D "
                 "00000000000000000000000000000000:0000 0A 00000000:00000000 00:00000000 "
                 "00000000  1000 0 4711 1\n");
  fake.process("999999999", "foxglove");
  fake.opens("999999999", "socket:[4711]");
  const Finding taken = find(page_port_findings(fake.system(), 8765), "page-port");
  EXPECT_EQ(taken.severity, Severity::kWarning);
  EXPECT_EQ(taken.seen, "TCP port 8765 of the page is taken by foxglove (pid 999999999)");
  EXPECT_THAT(taken.fix, HasSubstr("--listen"));
}

TEST(Host, WhoseDiskIsSlowFullOrClosedIsWarnedOf) {
  EXPECT_EQ(find(disk_findings({"/runs", 200.0, 9000.0, ""}), "disk").severity, Severity::kOk);
  const Finding slow = find(disk_findings({"/runs", 3.0, 9000.0, ""}), "disk");
  EXPECT_EQ(slow.severity, Severity::kWarning);
  EXPECT_THAT(slow.seen, HasSubstr("slow, 3 MB/s"));
  EXPECT_THAT(slow.fix, HasSubstr("record.directory"));
  const Finding full = find(disk_findings({"/runs", 200.0, 90.0, ""}), "disk");
  EXPECT_EQ(full.severity, Severity::kWarning);
  EXPECT_THAT(full.fix, HasSubstr("delete old recordings"));
  const Finding closed = find(disk_findings({"/runs", 0.0, 0.0, "Read-only file system"}), "disk");
  EXPECT_EQ(closed.severity, Severity::kWarning);
  EXPECT_THAT(closed.seen, HasSubstr("Read-only file system"));
}

}  // namespace
}  // namespace tp100::doctor
