// The examination of robot, port and machine from within the daemon. What each finding says:
// tests/doctor.
#include "selftest/self_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "wire/messages.h"

namespace tp100::selftest {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

constexpr HostNs kPeriodNs = 5 * kNsPerMs;
constexpr const char* kPort = "/dev/no-such-port";

wire::Hello hello() {
  wire::Hello out{};
  out.protocol = wire::kProtocolVersion;
  out.schema = wire::kSchemaHash;
  out.board = static_cast<std::uint8_t>(wire::BoardType::kMega2560);
  out.boot_nonce = 7;
  return out;
}

/// What a part is found to be that another thread examines.
Json examined(SelfTest& test, DoctorPart part) {
  // Kept until the other thread has let go of it.
  const auto promise = std::make_shared<std::promise<Json>>();
  test.examine(part, [promise](const std::string&, const std::string& json) {
    promise->set_value(Json::parse(json));
  });
  return promise->get_future().get();
}

/// A self-test that sees the steps of a robot which confirms every command after one step.
class SelfTestOfARobot : public ::testing::Test {
 protected:
  SelfTestOfARobot() {
    record_.snapshot.sample.battery_v = 7.9;
    record_.snapshot.sample.accel_mps2 = {0.0, 0.0, 9.8};
    record_.snapshot.sample.imu_age = 0;
    record_.snapshot.sample.state = RobotState::kDisarmed;
  }

  void event(const auto& what) { test_.on_event({record_.now_ns, what}, hello(), {kPort, false}); }
  void identify(SessionState state = SessionState::kReady) {
    event(link::HelloReceived{});
    record_.inputs.session = state;
  }

  void step() {
    ++record_.step;
    record_.now_ns += kPeriodNs;
    record_.inputs.samples.clear();
    const bool ready = record_.inputs.session == SessionState::kReady;
    record_.snapshot.has_sample = ready;
    record_.command_valid = ready;
    if (ready) {
      Sample sample = record_.snapshot.sample;
      sample.measured_ns = record_.now_ns - 2 * kNsPerMs;
      sample.last_command = sent_++;
      record_.inputs.samples.push(sample);
      record_.link.bytes_in += 45;
      ++record_.link.frames_in;
    }
    test_.take(record_);
  }

  /// Steps until the robot is examined.
  Json examine(int steps = 1100) {
    Json found;
    test_.examine(DoctorPart::kRobot, [&](const std::string& why, const std::string& json) {
      EXPECT_EQ(why, "");
      found = Json::parse(json);
    });
    for (int i = 0; i < steps && found.is_null(); ++i) step();
    return found;
  }

  static Json finding(const Json& found, const std::string& name) {
    for (const Json& each : found.at("findings"))
      if (each.at("name") == name) return each;
    return {{"severity", "none"}, {"seen", ""}, {"fix", ""}};
  }

  StepRecord record_{};
  std::uint16_t sent_ = 100;
  course::Robot robot_{};
  config::Configuration configuration_{};
  messages::EventQueue events_;
  SelfTest test_{configuration_, robot_, disk_, events_};
  Worker disk_{"disk"};  // its jobs use the self-test
};

TEST_F(SelfTestOfARobot, FindsAGoodOneReady) {
  identify();
  record_.inputs.clock = {.valid = true, .uncertainty_us = 300.0};
  record_.inputs.session_number = 1;
  const Json found = examine();
  EXPECT_EQ(found.at("errors"), 0) << found;
  EXPECT_EQ(found.at("port"), kPort);
  for (const char* name : {"firmware", "start", "battery", "imu", "link", "clock"})
    EXPECT_EQ(finding(found, name).at("severity"), "ok") << name;
  const std::string link = finding(found, "link").at("seen");
  EXPECT_THAT(link, HasSubstr("200 samples in 1.0 s, 0 lost"));
  // By steps: read after 2 ms, confirmed with the next sample.
  EXPECT_THAT(link, HasSubstr("age 2.0"));
  EXPECT_THAT(link, HasSubstr("round trip 5.0"));
}

TEST_F(SelfTestOfARobot, NamesWhatTheSampleShows) {
  identify();
  record_.snapshot.sample.battery_v = robot_.drive.battery_cutoff_v - 1.0;
  record_.snapshot.sample.accel_mps2 = {0.0, 0.0, -9.8};
  record_.snapshot.faults = fault_bit(Fault::moves_unasked);
  const Json found = examine();
  for (const char* name : {"battery", "imu", "motors"})
    EXPECT_EQ(finding(found, name).at("severity"), "error") << name;
  EXPECT_NE(finding(found, "imu").at("fix"), "");
}

TEST_F(SelfTestOfARobot, NamesTheParameterThatTheFirmwareRefusesUntilThePortIsClosed) {
  identify(SessionState::kParameters);
  event(link::Acknowledged{wire::Type::kParameters, wire::Result::kOutOfRange, 0});
  EXPECT_EQ(finding(examine(), "parameters").at("severity"), "error");
  event(link::StateChanged{SessionState::kReady, SessionState::kClosed});
  record_.inputs.session = SessionState::kListening;
  const Json closed = examine();
  EXPECT_EQ(finding(closed, "start").at("severity"), "none");
  EXPECT_EQ(finding(closed, "parameters").at("severity"), "none");
}

TEST_F(SelfTestOfARobot, CountsOnlyTheRestartsDuringTheExamination) {
  identify();
  record_.link.reboots = 3;
  EXPECT_EQ(finding(examine(), "reboots").at("severity"), "none");
  std::string found;
  test_.examine(DoctorPart::kRobot,
                [&](const std::string&, const std::string& json) { found = json; });
  step();
  ++record_.link.reboots;
  for (int i = 0; i < 300; ++i) step();
  EXPECT_THAT(found, HasSubstr("the board restarted 1 time "));
}

TEST_F(SelfTestOfARobot, GivesUpASilentOneAfterFiveSeconds) {
  record_.inputs.session = SessionState::kListening;
  const Json found = examine();
  EXPECT_EQ(record_.step, 1001U);
  EXPECT_EQ(finding(found, "firmware").at("severity"), "error");
}

TEST_F(SelfTestOfARobot, SaysWhyNoPortIsOpen) {
  test_.note_port("/dev/ttyACM0: no such port; plug the robot in");
  const Json open = finding(examine(), "open");
  EXPECT_EQ(open.at("seen"), "/dev/ttyACM0: no such port");
  EXPECT_EQ(open.at("fix"), "plug the robot in");
}

TEST_F(SelfTestOfARobot, ExaminesOneAtATime) {
  int answers = 0;
  test_.examine(DoctorPart::kRobot, [&](const std::string& why, const std::string&) {
    answers += why.empty() ? 1 : 0;
  });
  std::string refused;
  test_.examine(DoctorPart::kMachine,
                [&](const std::string& why, const std::string&) { refused = why; });
  EXPECT_THAT(refused, HasSubstr("another examination is under way"));
  for (int i = 0; i < 1100; ++i) step();
  EXPECT_EQ(answers, 1);
}

TEST_F(SelfTestOfARobot, ExaminesTheMachineWithThePrivilegesOfTheRun) {
  test_.set_privileges({{.what = "SCHED_FIFO 80", .granted = false, .fix = "not permitted"}});
  const Json found = examined(test_, DoctorPart::kMachine);
  EXPECT_NE(finding(found, "real-time").at("severity"), "ok");
  EXPECT_EQ(finding(found, "page-port").at("severity"), "ok");
  for (const char* name : {"clock-source", "disk"})
    EXPECT_NE(finding(found, name).at("severity"), "none") << name;
}

TEST(SelfTest, FindsThePortThatIsConfiguredMissing) {
  config::Configuration configuration;
  configuration.link.port = kPort;
  messages::EventQueue events;
  Worker disk("disk");
  SelfTest test(configuration, {}, disk, events);
  const Json found = examined(test, DoctorPart::kPort);
  EXPECT_EQ(found.at("errors"), 1);
  EXPECT_THAT(std::string(found.at("findings").at(0).at("seen")), HasSubstr("no such port"));
}

}  // namespace
}  // namespace tp100::selftest
