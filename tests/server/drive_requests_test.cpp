// STOP, the wheel, and the tests of the tracks and of the doctor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "request_rig.h"

namespace tp100::server {
namespace {

using ::testing::HasSubstr;

TEST_F(RequestHandlerTest, TracksRunOnlyWhenTheyAreFreeAndNothingElseIsUnderWay) {
  const auto refused = [&](const char* request) {
    return std::string(call(Service::kWheelsUpBegin, request).texts.at(0)["message"]);
  };
  StepRecord lost = ready();
  lost.snapshot.drive_refusal = StartRefusal::kNoSession;
  step(lost);
  EXPECT_EQ(refused(R"({"tracks":"free"})"), to_string(StartRefusal::kNoSession));
  step(ready());
  for (const char* bad : {"{}", R"({"tracks":"perhaps"})", R"({"tracks":true})"})
    EXPECT_THAT(refused(bad), HasSubstr("tracks = \"free\""));
  StepRecord running = ready();
  running.snapshot.run_state = RunState::kRunning;
  step(running);
  EXPECT_NE(refused(R"({"tracks":"free"})"), "");
  EXPECT_TRUE(controls_.checkers.empty());
  step(ready());
  const Received begun = call(Service::kWheelsUpBegin, R"({"tracks":"free"})");
  EXPECT_EQ(answer_of(begun.binaries.at(0))["token"], "free");
  EXPECT_EQ(controls_.checkers.size(), 1U);

  const Received seen =
      call(Service::kWheelsUpWatch, R"({"token":"t","input_ms":5,"question":2,"answer":"b"})");
  EXPECT_EQ(answer_of(seen.binaries.at(0))["step"], "the left track runs");
  ASSERT_EQ(controls_.watched.size(), 1U);
  EXPECT_EQ(controls_.watched[0].token, "t");
  EXPECT_EQ(controls_.watched[0].input_ms, 5.0);
  EXPECT_EQ(controls_.watched[0].question, 2U);
  EXPECT_EQ(controls_.watched[0].answer, "b");
  for (const char* bad : {"{}", R"({"token":"t"})", R"({"token":1,"input_ms":5})"})
    EXPECT_THAT(std::string(call(Service::kWheelsUpWatch, bad).texts.at(0)["message"]),
                HasSubstr("token must be a string"));
}

TEST_F(RequestHandlerTest, TheDoctorExaminesOnePartAtATimeAndNothingDuringARun) {
  step(ready());
  for (const char* part : {"port", "robot", "machine"}) {
    const Received found = call(Service::kDoctor, std::string(R"({"part":")") + part + R"("})");
    EXPECT_EQ(answer_of(found.binaries.at(0))["port"], "/dev/ttyACM0");
  }
  EXPECT_THAT(controls_.examined,
              ::testing::ElementsAre(DoctorPart::kPort, DoctorPart::kRobot, DoctorPart::kMachine));
  for (const char* bad : {"{}", R"({"part":"wheels"})", R"({"part":1})"})
    EXPECT_THAT(std::string(call(Service::kDoctor, bad).texts.at(0)["message"]),
                HasSubstr("part must be \"port\""));
  StepRecord running = ready();
  running.snapshot.run_state = RunState::kRunning;
  step(running);
  EXPECT_THAT(std::string(call(Service::kDoctor, R"({"part":"robot"})").texts.at(0)["message"]),
              HasSubstr("a run is under way"));
  EXPECT_EQ(controls_.examined.size(), 3U);
}

TEST_F(RequestHandlerTest, StopIsAnsweredWhenTheRobotHasAnswered) {
  EXPECT_TRUE(call(Service::kStop).binaries.empty());
  publisher_.stop_answered(kNow + 14 * kNsPerMs, kNow + 15 * kNsPerMs);
  handler_.tick(kNow + 15 * kNsPerMs);
  const Json answer = answer_of(take().binaries.at(0));
  EXPECT_EQ(answer["acknowledged"], true);
  EXPECT_EQ(answer["acknowledged_ms"], 14.0);
}

TEST_F(RequestHandlerTest, StopIsAnsweredAfter200MsWithoutTheRobot) {
  call(Service::kStop);
  publisher_.tick(kNow + 199 * kNsPerMs);
  handler_.tick(kNow + 199 * kNsPerMs);
  EXPECT_TRUE(take().binaries.empty());
  publisher_.tick(kNow + 201 * kNsPerMs);
  handler_.tick(kNow + 201 * kNsPerMs);
  EXPECT_EQ(answer_of(take().binaries.at(0))["acknowledged"], false);
}

// The page would say that the robot has not acknowledged a STOP which it has.
TEST_F(RequestHandlerTest, StopIsAnsweredWhenTheRobotWasFasterThanTheReportOfThePress) {
  publisher_.stop_answered(kNow + 5 * kNsPerMs, kNow + 5 * kNsPerMs);
  const Json answer = answer_of(call(Service::kStop).binaries.at(0));
  EXPECT_EQ(answer["acknowledged"], true);
  EXPECT_EQ(answer["acknowledged_ms"], 5.0);
}

TEST_F(RequestHandlerTest, StateTellsOfTheStop) {
  send(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":16}]})");
  call(Service::kStop);
  publisher_.stop_answered(kNow + 14 * kNsPerMs, kNow + 15 * kNsPerMs);
  const Received received = take();
  ASSERT_FALSE(received.data.empty());
  const Json stop = received.data.back().second["stop"];
  EXPECT_EQ(stop["status"], "acknowledged");
  EXPECT_EQ(stop["acknowledged_ms"], 14.0);
  EXPECT_EQ(stop["by"], "viewer 3");
  EXPECT_EQ(stop["latched"], true);
  StepRecord arming = ready();
  arming.now_ns += kNsPerS;
  arming.snapshot.run_state = RunState::kArming;
  step(arming);
  EXPECT_EQ(take().data.back().second["stop"]["latched"], false);
}

TEST_F(RequestHandlerTest, TheWheelIsTakenDrivenAndReleased) {
  step(ready());
  take();
  const Json taken = answer_of(call(Service::kDriveTake).binaries.at(0));
  const std::string token = taken.at("token");
  const auto drive = [&](const std::string& text) {
    return call(
        7, R"({"token":")" + text + R"(","speed_mps":0.1,"yaw_rate_radps":-0.2,"input_ms":5})");
  };
  EXPECT_EQ(drive(token).binaries.size(), 1U);
  ASSERT_EQ(controls_.inputs.size(), 1U);
  EXPECT_EQ(controls_.inputs[0].speed_mps, 0.1);
  EXPECT_EQ(controls_.inputs[0].yaw_rate_radps, -0.2);
  EXPECT_EQ(drive("other").texts.at(0)["op"], "serviceCallFailure");
  EXPECT_EQ(controls_.inputs.size(), 1U);
  EXPECT_EQ(call(Service::kDriveRelease, R"({"token":"other"})").texts.size(), 1U);
  EXPECT_EQ(call(Service::kDriveRelease, R"({"token":")" + token + R"("})").binaries.size(), 1U);
  EXPECT_EQ(drive(token).texts.size(), 1U);
}

TEST_F(RequestHandlerTest, TheWheelIsNotForViewersWithoutRights) {
  step(ready());
  take();
  for (std::uint32_t service = 6; service <= 8; ++service)
    EXPECT_EQ(call(service, "{}", Permission::kStopOnly).texts.size(), 1U) << service;
  EXPECT_EQ(controls_.wheel.figures(kNow).by, "");
}

TEST_F(RequestHandlerTest, TheWheelIsRefusedWithTheReasonOfTheStep) {
  StepRecord record = ready();
  record.snapshot.drive_refusal = StartRefusal::kNotStill;
  step(record);
  take();
  EXPECT_EQ(call(Service::kDriveTake).texts.at(0)["message"],
            std::string(to_string(StartRefusal::kNotStill)));
  EXPECT_EQ(call(Service::kDriveTake, R"({"x":1})").texts.at(0)["message"],
            "there is no argument 'x'");
}

TEST_F(RequestHandlerTest, AViewerThatLeavesNoLongerDrives) {
  step(ready());
  take();
  const std::string token = answer_of(call(Service::kDriveTake).binaries.at(0)).at("token");
  handler_.leave(Viewer(
                     77, [] {}, [] {}),
                 kNow);
  EXPECT_EQ(controls_.drivers_lost, 0);
  handler_.leave(*viewer_, kNow);
  EXPECT_EQ(controls_.drivers_lost, 1);
  EXPECT_EQ(call(Service::kDrive,
                 R"({"token":")" + token + R"(","speed_mps":0,"yaw_rate_radps":0,"input_ms":0})")
                .texts.size(),
            1U);
}

}  // namespace
}  // namespace tp100::server
