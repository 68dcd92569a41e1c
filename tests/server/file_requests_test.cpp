// Requests about courses, robots, places, recorded runs and the doctor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "request_rig.h"

namespace tp100::server {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;

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

}  // namespace
}  // namespace tp100::server
