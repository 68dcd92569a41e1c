#include "doctor/robot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fake_system.h"

namespace tp100::doctor {
namespace {

using test::find;
using ::testing::HasSubstr;

/// The probe of a robot without any problem.
ProbeResult good_probe() {
  ProbeResult probe;
  probe.port = "/dev/ttyACM0";
  probe.bytes_in = 9000;
  probe.frames_in = 200;
  probe.hello = "a Mega 2560, firmware 0.1.0, protocol 1";
  probe.ours = true;
  probe.ready = true;
  probe.battery_v = 7.9;
  probe.battery_cutoff_v = 6.0;
  probe.imu_fresh = true;
  probe.up_mps2 = 9.7;
  LinkTest link;
  link.duration_s = 1.0;
  link.samples = 200;
  link.expected_samples = 200.0;
  link.age = {1500.0, 2000.0, 3000.0, 4000.0};
  link.round_trip = {5000.0, 6000.0, 7000.0, 8000.0};
  link.confirmed = 120;
  link.clock_known = true;
  link.clock_uncertainty_us = 300.0;
  probe.link = link;
  return probe;
}

/// The only finding of a probe that ends with it.
Finding only(const ProbeResult& probe) {
  const Findings findings = robot_findings(probe);
  return findings.size() == 1 ? findings[0] : Finding{Severity::kOk, "not one", "", ""};
}

TEST(Robot, ThatIsWellHasNothingToFix) {
  const Findings findings = robot_findings(good_probe());
  EXPECT_EQ(count(findings, Severity::kOk), findings.size());
  EXPECT_THAT(find(findings, "link").seen, HasSubstr("200 samples in 1.0 s, 0 lost"));
  EXPECT_THAT(find(findings, "link").seen, HasSubstr("age 1.50/2.00/3.00/4.00 ms"));
  EXPECT_THAT(find(findings, "link").seen, HasSubstr("round trip 5.00/6.00/7.00/8.00 ms"));
}

TEST(Robot, WhoseMotorsAreOnUnaskedIsAnError) {
  ProbeResult probe = good_probe();
  probe.moved_unasked = true;
  const Finding motors = find(robot_findings(probe), "motors");
  EXPECT_EQ(motors.severity, Severity::kError);
  EXPECT_THAT(motors.seen, HasSubstr("without a request"));
}

TEST(Robot, WhosePortCannotBeOpenedSaysWhatToDo) {
  ProbeResult probe;
  probe.open_error = "/dev/ttyACM0: port is busy, held by cat (pid 7); end that program";
  const Finding open = only(probe);
  EXPECT_EQ(open.severity, Severity::kError);
  EXPECT_EQ(open.name, "open");
  EXPECT_EQ(open.seen, "/dev/ttyACM0: port is busy, held by cat (pid 7)");
  EXPECT_EQ(open.fix, "end that program");
}

TEST(Robot, ThatIsSilentMayNeedItsFirmware) {
  ProbeResult probe;
  probe.port = "/dev/ttyACM0";
  EXPECT_EQ(only(probe).severity, Severity::kError);
  EXPECT_EQ(only(probe).name, "firmware");
  EXPECT_THAT(only(probe).seen, HasSubstr("silent"));
  probe.bytes_in = 80;
  EXPECT_THAT(only(probe).seen, HasSubstr("80 bytes, but no frame of a TP100"));
  EXPECT_THAT(only(probe).fix, HasSubstr("scripts/flash --port /dev/ttyACM0"));
  probe.frames_in = 4;
  EXPECT_THAT(only(probe).seen, HasSubstr("but no hello"));
}

TEST(Robot, WithNothingButABootloaderNeedsItsFirmware) {
  ProbeResult probe;
  probe.port = "/dev/ttyACM0";
  probe.bootloader = true;
  EXPECT_EQ(only(probe).severity, Severity::kError);
  EXPECT_EQ(only(probe).name, "bootloader");
  EXPECT_EQ(only(probe).fix,
            "scripts/flash --port /dev/ttyACM0 (installed: tp100-flash --port /dev/ttyACM0)");
}

TEST(Robot, OfAnotherVersionNeedsFlashing) {
  ProbeResult probe = good_probe();
  probe.ours = false;
  probe.hello = "firmware 3.0.0, protocol 2, but tp100d uses 1; flash it";
  EXPECT_EQ(only(probe).severity, Severity::kError);
  EXPECT_EQ(only(probe).name, "firmware");
  EXPECT_EQ(only(probe).seen, "firmware 3.0.0, protocol 2, but tp100d uses 1");
  EXPECT_EQ(only(probe).fix,
            "scripts/flash --port /dev/ttyACM0 (installed: tp100-flash --port /dev/ttyACM0)");
}

TEST(Robot, ThatRefusesAParameterNamesIt) {
  ProbeResult probe = good_probe();
  probe.refused = "yaw_kp";
  const Finding refused = find(robot_findings(probe), "parameters");
  EXPECT_EQ(refused.severity, Severity::kError);
  EXPECT_THAT(refused.seen, HasSubstr("yaw_kp"));
  EXPECT_THAT(refused.fix, HasSubstr("tp100d check"));
}

TEST(Robot, WhoseClockIsNotFoundHasNoSession) {
  ProbeResult probe = good_probe();
  probe.ready = false;
  probe.link.reset();
  EXPECT_EQ(find(robot_findings(probe), "session").severity, Severity::kError);
}

TEST(Robot, ThatRestartsHasABadSupply) {
  ProbeResult probe = good_probe();
  probe.reboots = 3;
  const Finding reboots = find(robot_findings(probe), "reboots");
  EXPECT_EQ(reboots.severity, Severity::kError);
  EXPECT_THAT(reboots.seen, HasSubstr("3 times"));
  EXPECT_THAT(reboots.fix, HasSubstr("power wiring"));
}

TEST(Robot, WithALatchedFaultSaysItsFix) {
  ProbeResult probe = good_probe();
  probe.faults = fault_bit(Fault::imu_missing) | fault_bit(Fault::command_timeout);
  const Findings findings = robot_findings(probe);
  EXPECT_EQ(count(findings, Severity::kError), 1U);
  EXPECT_THAT(find(findings, "fault").seen, HasSubstr("imu_missing"));
  EXPECT_THAT(find(findings, "fault").fix, HasSubstr("SDA"));
  // A start clears a fault whose cause is gone.
  probe.faults = fault_bit(Fault::watchdog_reset);
  EXPECT_EQ(find(robot_findings(probe), "fault").severity, Severity::kWarning);
}

TEST(Robot, WithAnEmptyBatteryOrNoneSaysWhich) {
  ProbeResult probe = good_probe();
  probe.battery_v = 5.5;
  EXPECT_EQ(find(robot_findings(probe), "battery").severity, Severity::kError);
  EXPECT_EQ(find(robot_findings(probe), "battery").fix, "charge the battery");
  probe.battery_v = 0.4;
  EXPECT_EQ(find(robot_findings(probe), "battery").fix, "switch the motors' battery on");
}

TEST(Robot, WhoseImuIsNotUprightSaysHowToMountIt) {
  ProbeResult probe = good_probe();
  probe.up_mps2 = -9.6;
  const Finding imu = find(robot_findings(probe), "imu");
  EXPECT_EQ(imu.severity, Severity::kError);
  EXPECT_THAT(imu.seen, HasSubstr("-9.6 m/s^2"));
  EXPECT_THAT(imu.fix, HasSubstr("mount the MPU6050 level"));
}

TEST(Robot, WhoseSamplesDoNotComeHasABadLink) {
  ProbeResult probe = good_probe();
  probe.link->samples = 60;
  EXPECT_EQ(find(robot_findings(probe), "link").severity, Severity::kError);
  EXPECT_THAT(find(robot_findings(probe), "link").seen, HasSubstr("200 were due"));
}

TEST(Robot, ThatConfirmsNoCommandHasABadLink) {
  ProbeResult probe = good_probe();
  probe.link->confirmed = 0;
  EXPECT_EQ(find(robot_findings(probe), "link").severity, Severity::kError);
  EXPECT_THAT(find(robot_findings(probe), "link").seen, HasSubstr("confirmed no command"));
}

TEST(Robot, WhoseFramesAreCorruptedOrLostHasAPoorLink) {
  ProbeResult probe = good_probe();
  probe.link->counters.crc_errors = 2;
  EXPECT_EQ(find(robot_findings(probe), "link").severity, Severity::kWarning);
  EXPECT_THAT(find(robot_findings(probe), "link").seen, HasSubstr("2 frames corrupted"));
  EXPECT_THAT(find(robot_findings(probe), "link").fix, HasSubstr("short cable"));
  probe = good_probe();
  probe.link->counters.lost = 3;
  EXPECT_THAT(find(robot_findings(probe), "link").seen, HasSubstr("3 lost"));
}

TEST(Robot, WhoseSamplesComeLateHasASlowLink) {
  ProbeResult probe = good_probe();
  probe.link->age.p99_us = 30'000.0;
  EXPECT_EQ(find(robot_findings(probe), "link").severity, Severity::kWarning);
  EXPECT_THAT(find(robot_findings(probe), "link").fix, HasSubstr("without a hub"));
}

TEST(Robot, WhoseClockIsKnownBadlyIsWarnedOf) {
  ProbeResult probe = good_probe();
  probe.link->clock_uncertainty_us = 9'000.0;
  const Finding clock = find(robot_findings(probe), "clock");
  EXPECT_EQ(clock.severity, Severity::kWarning);
  EXPECT_THAT(clock.seen, HasSubstr("9000 us"));
  probe.link->clock_known = false;
  EXPECT_EQ(find(robot_findings(probe), "clock").name, "none");
}

}  // namespace
}  // namespace tp100::doctor
