// Requests about courses, robots, places, recorded runs, the doctor, and parameters.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "request_rig.h"

namespace tp100::server {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;

TEST_F(RequestHandlerTest, WhatIsChosenPlacedOrExaminedIsPassedOnUnlessARunIsUnderWay) {
  step(ready());
  EXPECT_EQ(answered(Service::kChoose, R"({"course":"3","setup":"flat"})")["course"], "3");
  ASSERT_EQ(controls_.choices.size(), 1U);
  EXPECT_EQ(controls_.choices[0].course, "3");
  EXPECT_EQ(controls_.choices[0].robot, std::nullopt) << "what is not named stays";
  EXPECT_EQ(controls_.choices[0].setup, "flat");
  answered(Service::kPlace, R"({"at":"start"})");
  answered(Service::kPlace, R"({"x_m":1.5,"y_m":-2,"yaw_rad":0.5})");
  ASSERT_EQ(controls_.places.size(), 2U);
  EXPECT_FALSE(controls_.places[0]);
  const Pose at = controls_.places[1].value_or(Pose{});
  EXPECT_EQ(at.x_m, 1.5);
  EXPECT_EQ(at.y_m, -2.0);
  EXPECT_EQ(at.yaw_rad, 0.5);
  for (const char* part : {"port", "robot", "machine"})
    EXPECT_EQ(answered(Service::kDoctor, R"({"part":")" + std::string(part) + R"("})")["port"],
              "/dev/ttyACM0");
  EXPECT_THAT(controls_.examined,
              ElementsAre(DoctorPart::kPort, DoctorPart::kRobot, DoctorPart::kMachine));
  controls_.change_refusal = "mine.toml:3:1: unknown key 'x'";
  EXPECT_EQ(refused(Service::kChoose, R"({"course":"mine"})"), controls_.change_refusal);

  const std::size_t before = controls_.requests();
  for (const RunState state : {RunState::kArming, RunState::kRunning, RunState::kDriving}) {
    step(ready(state));
    for (const auto& [service, request] : {std::pair(Service::kChoose, R"({"course":"3"})"),
                                           std::pair(Service::kPlace, R"({"at":"start"})"),
                                           std::pair(Service::kDoctor, R"({"part":"robot"})")})
      EXPECT_THAT(refused(service, request), ::testing::HasSubstr("a run is under way"));
  }
  EXPECT_EQ(controls_.requests(), before);
}

TEST_F(RequestHandlerTest, FilesAreSavedDeletedAndCheckedAlsoDuringARun) {
  step(ready(RunState::kRunning));
  const std::string draft = R"({"kind":"robot","name":"mine","text":"x")";
  answered(Service::kFileCheck, draft + "}");
  answered(Service::kFileSave, draft + R"(,"replace":true})");
  answered(Service::kFileDelete, R"({"kind":"course","name":"old"})");
  ASSERT_EQ(controls_.checked.size(), 1U);
  EXPECT_EQ(controls_.checked[0].text, "x");
  ASSERT_EQ(controls_.saved.size(), 1U);
  EXPECT_EQ(controls_.saved[0].name, "mine");
  EXPECT_TRUE(controls_.saved[0].is_robot && controls_.saved[0].replace);
  ASSERT_EQ(controls_.deleted.size(), 1U);
  EXPECT_EQ(controls_.deleted[0].name, "old");
  EXPECT_FALSE(controls_.deleted[0].is_robot);
}

TEST_F(RequestHandlerTest, ARunIsNamedReportedComparedIdentifiedAndDeleted) {
  EXPECT_EQ(
      answered(Service::kRunNote, R"({"run":"a","name":"","tags":"wet","keep":false})")["run"],
      "a");
  answered(Service::kRunReport, R"({"run":"a"})");
  answered(Service::kRunCompare, R"({"run":"a","with":"b"})");
  answered(Service::kRunDelete, R"({"run":"a"})");
  answered(Service::kRunIdentify, R"({"runs":"a b","measured":"run,distance_m\n1,2\n"})");
  using What = RunRequest::What;
  const std::vector<RunRequest>& asked = controls_.managed;
  EXPECT_THAT(
      asked,
      ElementsAre(Field(&RunRequest::what, What::kNote), Field(&RunRequest::what, What::kReport),
                  Field(&RunRequest::what, What::kCompare), Field(&RunRequest::what, What::kDelete),
                  Field(&RunRequest::what, What::kIdentify)));
  EXPECT_EQ(asked[0].note.name, "");
  EXPECT_EQ(asked[0].note.note, std::nullopt);
  EXPECT_EQ(asked[0].note.tags, "wet");
  EXPECT_EQ(asked[0].note.keep, false);
  EXPECT_EQ(asked[2].with, "b");
  EXPECT_THAT(asked[4].drives, ElementsAre("a", "b"));
  EXPECT_EQ(asked[4].measured, "run,distance_m\n1,2\n");
  controls_.change_refusal = "is open";
  EXPECT_EQ(refused(Service::kRunDelete, R"({"run":"a"})"), "is open");
}

TEST_F(RequestHandlerTest, ARecordingIsBegunUnderItsNameAndEnded) {
  controls_.can_record = true;
  EXPECT_EQ(answered(Service::kRecordStart, R"({"name":"run-1_a.b"})")["run"], "run-1_a.b");
  EXPECT_EQ(answered(Service::kRecordStop)["run"], "run-1_a.b");
  controls_.can_record = false;
  EXPECT_EQ(refused(Service::kRecordStart), "no directory");
}

TEST_F(RequestHandlerTest, AnAnswerOfASlowDiskComesLaterAndStopBeforeIt) {
  controls_.slow_disk = true;
  const Received nothing = call(Service::kRecordStop);
  EXPECT_TRUE(nothing.texts.empty() && nothing.binaries.empty());
  call(Service::kStop);
  messages::RecordingFigures late;
  late.run = "late";
  late.bytes = 7;
  controls_.unanswered("", late);
  handler_.tick(kNow);
  EXPECT_EQ(answer_of(take().binaries.at(0)), Json::parse(R"({"run":"late","bytes":7})"));
  call(Service::kRecordStop);
  controls_.unanswered("no disk", {});
  handler_.tick(kNow);
  EXPECT_EQ(take().texts.at(0)["message"], "no disk");
  // A viewer that has left must not get an answer.
  call(Service::kRecordStop);
  viewer_.reset();
  controls_.unanswered("", {});
  handler_.tick(kNow);
}

TEST_F(RequestHandlerTest, ParametersAreListed) {
  const Received all = send(R"({"op":"getParameters","parameterNames":[],"id":"q"})");
  EXPECT_EQ(all.texts[0]["parameters"].size(), 6U);
  EXPECT_EQ(all.texts[0]["id"], "q");
  const Received one = send(R"({"op":"getParameters","parameterNames":["loop.rate_hz","none"]})");
  EXPECT_EQ(one.texts[0]["parameters"].size(), 1U);
}

TEST_F(RequestHandlerTest, AGoodValueIsPassedOnAndTold) {
  send(R"({"op":"subscribeParameterUpdates","parameterNames":["control.gain"]})");
  const Received received = set("control.gain", "20");
  ASSERT_EQ(controls_.sets.size(), 1U);
  EXPECT_EQ(controls_.sets[0].second, messages::ParameterValue(20.0));
  ASSERT_EQ(received.texts.size(), 2U);  // one for the subscription, then the answer to the request
  EXPECT_EQ(received.texts[1]["parameters"][0]["value"], 20);
  EXPECT_EQ(received.texts[1]["id"], "s");
}

TEST_F(RequestHandlerTest, WatchedParametersAddUpUntilTheyAreTakenBack) {
  const auto updates = [&] { return set("control.gain", "20").texts.size() - 1; };
  EXPECT_EQ(updates(), 0U);
  send(R"({"op":"subscribeParameterUpdates","parameterNames":["control.gain"]})");
  send(R"({"op":"subscribeParameterUpdates","parameterNames":["loop.rate_hz","none"]})");
  EXPECT_EQ(updates(), 1U);
  send(R"({"op":"unsubscribeParameterUpdates","parameterNames":["control.gain"]})");
  EXPECT_EQ(updates(), 0U);
  send(R"({"op":"subscribeParameterUpdates","parameterNames":[]})");
  EXPECT_EQ(updates(), 1U);
  send(R"({"op":"unsubscribeParameterUpdates","parameterNames":[]})");
  EXPECT_EQ(updates(), 0U);
}

TEST_F(RequestHandlerTest, NothingUncheckedIsPassedOn) {
  for (const auto& [name, value] :
       std::vector<std::pair<const char*, const char*>>{{"control.gain", "-1"},
                                                        {"control.gain", "201"},
                                                        {"control.gain", "\"20\""},
                                                        {"control.gain", "null"},
                                                        {"loop.rate_hz", "100"},
                                                        {"none", "1"},
                                                        {"estimation.steering", "\"truth\""}}) {
    const Received received = set(name, value);
    ASSERT_EQ(received.texts.size(), 2U) << name << value;
    EXPECT_EQ(received.texts[0]["op"], "status");
    EXPECT_EQ(received.texts[0]["level"], 2);
  }
  EXPECT_TRUE(controls_.sets.empty());
  // JSON cannot express these values, but a caller in the program could pass them.
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()})
    handler_.handle(viewer_, SetParameters{{{"control.gain", messages::ParameterValue(value)}}, ""},
                    Permission::kCommand, kNow);
  EXPECT_TRUE(controls_.sets.empty());
}

TEST_F(RequestHandlerTest, SomeParametersWaitForTheEndOfARun) {
  step(ready(RunState::kRunning));
  EXPECT_THAT(set("estimation.steering", R"("model")").texts[0]["message"],
              HasSubstr("during a run"));
  EXPECT_TRUE(controls_.sets.empty());
  step(ready());
  set("estimation.steering", R"("model")");
  EXPECT_EQ(controls_.sets.size(), 1U);
}

TEST_F(RequestHandlerTest, TheStepHasTheLastWord) {
  step(ready());
  set("estimation.steering", R"("model")");
  const auto value = [&] {
    return send(R"({"op":"getParameters","parameterNames":["estimation.steering"]})")
        .texts.back()["parameters"][0]["value"];
  };
  EXPECT_EQ(value(), "model");
  StepRecord later = ready();
  later.now_ns += kNsPerS;
  step(later);  // the pose source is still odometry: the change came too late
  EXPECT_EQ(value(), "odometry");
  later.now_ns += kNsPerS;
  later.snapshot.steering = PoseSource::kModel;
  step(later);
  EXPECT_EQ(value(), "model");
}

TEST_F(RequestHandlerTest, OtherParametersKeepWhatViewersHaveSet) {
  set("control.gain", "20");
  std::vector<messages::ParameterText> next = parameters();
  next[1].value = 400.0;
  handler_.change_setup(next, kNow);
  const Json values = send(R"({"op":"getParameters","parameterNames":[]})").texts.at(0);
  EXPECT_EQ(values["parameters"][0]["value"], 20.0);
  EXPECT_EQ(values["parameters"][1]["value"], 400.0);
}

TEST_F(RequestHandlerTest, ParametersAreSavedIfTheyMayBeAndTakeTheValue) {
  EXPECT_EQ(answered(Service::kParametersSave, R"({"control.gain":12.5,"course":"3"})")["file"],
            "tp100.toml");
  ASSERT_EQ(controls_.parameters_saved.size(), 1U);
  EXPECT_FALSE(controls_.parameters_saved[0].check);
  ASSERT_EQ(controls_.parameters_saved[0].values.size(), 2U);
  EXPECT_EQ(controls_.parameters_saved[0].values[0].first, "control.gain");
  EXPECT_EQ(controls_.parameters_saved[0].values[0].second, messages::ParameterValue(12.5));
  call(Service::kParametersSave, R"({"check":true,"course":""})");
  EXPECT_TRUE(controls_.parameters_saved.at(1).check);
  call(Service::kParametersRestore, R"({"check":true})");
  call(Service::kParametersRestore, "");
  EXPECT_THAT(controls_.restored, ::testing::ElementsAre(true, false));
}

TEST_F(RequestHandlerTest, DuringARunOnlyWhatIsInForceAtOnceIsSaved) {
  step(ready(RunState::kRunning));
  EXPECT_EQ(refused(Service::kParametersSave, R"({"control.gain":1})"), "");
  EXPECT_EQ(refused(Service::kParametersSave, R"({"check":true,"loop.rate_hz":100})"), "");
  EXPECT_THAT(refused(Service::kParametersSave, R"({"control.gain":1,"loop.rate_hz":100})"),
              HasSubstr("loop.rate_hz takes effect when"));
  EXPECT_THAT(refused(Service::kParametersRestore), HasSubstr("not during a run"));
  EXPECT_EQ(controls_.parameters_saved.size(), 2U);
  EXPECT_TRUE(controls_.restored.empty());
}

}  // namespace
}  // namespace tp100::server
