// What the doctor says about a robot whose hello, state or link is not as it should be, as a table
// and as JSON; and what it reads from a hello of any version.

#include "doctor/robot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <nlohmann/json.hpp>

#include "doctor/hello.h"
#include "fake_system.h"
#include "link/session.h"
#include "wire/frame.h"
#include "wire/messages.h"

namespace tp100::doctor {
namespace {

using test::expect_finding;
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

TEST(Robot, ThatIsWellHasNothingToFix) {
  const Findings findings = robot_findings(good_probe());
  EXPECT_EQ(count(findings, Severity::kOk), findings.size());
  EXPECT_THAT(find(findings, "link").seen, HasSubstr("200 samples in 1.0 s, 0 lost"));
  EXPECT_THAT(find(findings, "link").seen, HasSubstr("age 1.50/2.00/3.00/4.00 ms"));
  EXPECT_THAT(find(findings, "link").seen, HasSubstr("round trip 5.00/6.00/7.00/8.00 ms"));
  EXPECT_THAT(find(findings, "start").seen, HasSubstr("waits for Enter"));
  ProbeResult without_clock = good_probe();
  without_clock.link->clock_known = false;
  EXPECT_EQ(find(robot_findings(without_clock), "clock").name, "none");
}

// Without a hello of this firmware nothing else is known.
TEST(Robot, ThatDoesNotAnswerIsOneErrorThatSaysWhatToDo) {
  constexpr const char* kFlash =
      "scripts/flash --port /dev/ttyACM0 (installed: tp100-flash --port /dev/ttyACM0)";
  ProbeResult silent;
  silent.port = "/dev/ttyACM0";
  const struct {
    std::function<void(ProbeResult&)> set;
    const char *name, *seen, *fix;
  } cases[] = {
      {[](ProbeResult& p) {
         p.open_error = "/dev/ttyACM0: port is busy, held by cat (pid 7); end that program";
       },
       "open", "/dev/ttyACM0: port is busy, held by cat (pid 7)", "end that program"},
      {[](ProbeResult&) {}, "firmware", "/dev/ttyACM0: silent", kFlash},
      {[](ProbeResult& p) { p.bytes_in = 80; }, "firmware",
       "/dev/ttyACM0: 80 bytes, but no frame of a TP100", kFlash},
      {[](ProbeResult& p) { p.bytes_in = 80, p.frames_in = 4; }, "firmware",
       "/dev/ttyACM0: sends frames of the protocol but no hello", kFlash},
      {[](ProbeResult& p) { p.bootloader = true; }, "bootloader",
       "/dev/ttyACM0: only the bootloader answers", kFlash},
      {[](ProbeResult& p) {
         p.ready = true;
         p.hello = "firmware 3.0.0, protocol 2, but tp100d uses 1; flash it";
       },
       "firmware", "firmware 3.0.0, protocol 2, but tp100d uses 1", kFlash},
  };
  for (const auto& it : cases) {
    SCOPED_TRACE(it.seen);
    ProbeResult probe = silent;
    it.set(probe);
    const Findings findings = robot_findings(probe);
    ASSERT_EQ(findings.size(), 1U);
    expect_finding(findings, it.name, Severity::kError, it.seen, it.fix);
  }
}

TEST(Robot, EveryDefectIsTheOnlyOneThatIsFound) {
  const struct {
    std::function<void(ProbeResult&)> set;
    Severity severity;
    const char *name, *seen, *fix;
  } cases[] = {
      {[](ProbeResult& p) { p.moved_unasked = true; }, Severity::kError, "motors",
       "without a request", ""},
      {[](ProbeResult& p) { p.refused = "yaw_kp"; }, Severity::kError, "parameters", "yaw_kp",
       "tp100d check"},
      {[](ProbeResult& p) { p.ready = false, p.link.reset(); }, Severity::kError, "session",
       "its clock could not be read", "short cable"},
      {[](ProbeResult& p) { p.reboots = 3; }, Severity::kError, "reboots", "3 times",
       "power wiring"},
      // A missing command is no defect of a robot that nobody drives.
      {[](ProbeResult& p) {
         p.faults = fault_bit(Fault::imu_missing) | fault_bit(Fault::command_timeout);
       },
       Severity::kError, "fault", "imu_missing", "SDA"},
      // A start clears a fault whose cause is gone.
      {[](ProbeResult& p) { p.faults = fault_bit(Fault::watchdog_reset); }, Severity::kWarning,
       "fault", "watchdog_reset", ""},
      {[](ProbeResult& p) { p.battery_v = 5.5; }, Severity::kError, "battery", "5.5 V",
       "charge the battery"},
      {[](ProbeResult& p) { p.battery_v = 0.4; }, Severity::kError, "battery", "0.4 V",
       "switch the motors' battery on"},
      {[](ProbeResult& p) { p.up_mps2 = -9.6; }, Severity::kError, "imu", "-9.6 m/s^2",
       "mount the MPU6050 level"},
      {[](ProbeResult& p) { p.link->samples = 60; }, Severity::kError, "link", "200 were due",
       "short cable"},
      {[](ProbeResult& p) { p.link->confirmed = 0; }, Severity::kError, "link",
       "confirmed no command", "short cable"},
      {[](ProbeResult& p) { p.link->counters.crc_errors = 2; }, Severity::kWarning, "link",
       "2 frames corrupted", "short cable"},
      {[](ProbeResult& p) { p.link->counters.lost = 3; }, Severity::kWarning, "link", "3 lost",
       "short cable"},
      {[](ProbeResult& p) { p.link->age.p99_us = 30'000.0; }, Severity::kWarning, "link", "30.00",
       "without a hub"},
      {[](ProbeResult& p) { p.link->round_trip.p99_us = 50'000.0; }, Severity::kWarning, "link",
       "50.00", "without a hub"},
      {[](ProbeResult& p) { p.link->clock_uncertainty_us = 9'000.0; }, Severity::kWarning, "clock",
       "9000 us", "without a hub"},
  };
  for (const auto& it : cases) {
    SCOPED_TRACE(std::string(it.name) + ": " + it.seen);
    ProbeResult probe = good_probe();
    it.set(probe);
    const Findings findings = robot_findings(probe);
    EXPECT_EQ(count(findings, Severity::kOk), findings.size() - 1);
    expect_finding(findings, it.name, it.severity, it.seen, it.fix);
  }
}

const Findings kFindings = {{Severity::kError, "holder", "held open by cat", "end that program"},
                            {Severity::kNote, "by-id", "no name", "see tp100d ports"},
                            ok("disk", "200 MB/s")};

TEST(Report, OfAnExaminationIsATableWithEachFix) {
  EXPECT_EQ(table(kFindings),
            "error    holder  held open by cat\n"
            "                 fix: end that program\n"
            "note     by-id   no name\n"
            "                 fix: see tp100d ports\n"
            "ok       disk    200 MB/s\n"
            "1 error, 0 warnings, 1 note\n");
}

TEST(Report, OfAnExaminationIsOneJsonObject) {
  LinkTest link;
  link.samples = 200;
  link.confirmed = 120;
  link.counters.lost = 1;
  link.counters.crc_errors = 2;
  link.counters.cobs_errors = 3;
  link.counters.duplicated = 4;
  link.counters.implausible = 5;
  link.age = {10.0, 20.0, 30.0, 40.0};
  link.round_trip = {50.0, 60.0, 70.0, 80.0};
  const std::string text = json(kFindings, "/dev/\xff", link);
  EXPECT_EQ(text.find('\n'), text.size() - 1);
  const auto read = nlohmann::json::parse(text);
  EXPECT_EQ(read["errors"], 1);
  EXPECT_EQ(read["warnings"], 0);
  EXPECT_EQ(read["notes"], 1);
  ASSERT_EQ(read["findings"].size(), 3U);
  EXPECT_EQ(read["findings"][0], nlohmann::json::parse(R"({"severity":"error","name":"holder",
      "seen":"held open by cat","fix":"end that program"})"));
  EXPECT_EQ(read["link"], nlohmann::json::parse(R"({"duration_s":0.0,"samples":200,"lost":1,
      "crc_errors":2,"cobs_errors":3,"duplicated":4,"implausible":5,"commands_confirmed":120,
      "age_us":{"p50":10.0,"p90":20.0,"p99":30.0,"max":40.0},
      "round_trip_us":{"p50":50.0,"p90":60.0,"p99":70.0,"max":80.0},
      "clock_uncertainty_us":0.0,"clock_drift_ppm":0.0})"));
  EXPECT_TRUE(nlohmann::json::parse(json({}, "", std::nullopt))["link"].is_null());
}

/// The payload of a hello.
std::array<std::uint8_t, wire::Hello::kSize> payload(std::uint16_t protocol, std::uint32_t schema) {
  wire::Hello hello{};
  hello.protocol = protocol;
  hello.firmware[0] = 3;
  hello.firmware[1] = 20;
  hello.firmware[2] = 100;
  hello.schema = schema;
  hello.board = static_cast<std::uint8_t>(wire::BoardType::kMega2560);
  hello.boot_nonce = 7;
  std::array<std::uint8_t, wire::Hello::kSize> bytes{};
  wire::Writer writer(bytes.data());
  hello.visit(writer);
  return bytes;
}

TEST(HelloReply, NamesBoardFirmwareAndProtocol) {
  auto bytes = payload(wire::kProtocolVersion, wire::kSchemaHash);
  EXPECT_FALSE(link::read_hello(bytes.data(), 8)) << "too short";
  EXPECT_FALSE(link::read_hello(bytes.data(), bytes.size() - 1)) << "ours, but of another size";
  const HelloReply hello = reply_of(link::read_hello(bytes.data(), bytes.size()).value());
  EXPECT_TRUE(hello.ours);
  EXPECT_EQ(hello.text,
            "a Mega 2560, firmware 3.20.100, protocol " + std::to_string(wire::kProtocolVersion));
  bytes[9] = static_cast<std::uint8_t>(wire::BoardType::kFakeRobot);
  EXPECT_THAT(reply_of(link::read_hello(bytes.data(), bytes.size()).value()).text,
              HasSubstr("robot simulated inside the board"));
}

TEST(HelloReply, OfAnotherVersionNamesBothAndAsksForFlashing) {
  const auto other = payload(wire::kProtocolVersion + 1, 0xABCD);
  // Only the first nine bytes of a hello are guaranteed in every version.
  for (const std::size_t size : {std::size_t{9}, other.size()}) {
    const HelloReply hello = reply_of(link::read_hello(other.data(), size).value());
    EXPECT_FALSE(hello.ours);
    EXPECT_THAT(hello.text, HasSubstr("firmware 3.20.100"));
    EXPECT_THAT(hello.text, HasSubstr("schema 0000abcd"));
    EXPECT_THAT(hello.text, ::testing::EndsWith(
                                "; flash the board with scripts/flash (installed: tp100-flash)"));
  }
}

}  // namespace
}  // namespace tp100::doctor
