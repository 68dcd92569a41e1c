// Requests about recorded runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "request_rig.h"

namespace tp100::server {
namespace {

using ::testing::HasSubstr;

TEST_F(RequestHandlerTest, ARunIsNamedReportedComparedAndDeleted) {
  const Received named =
      call(Service::kRunNote, R"({"run":"a","name":"","tags":"wet","keep":false})");
  EXPECT_EQ(answer_of(named.binaries.at(0))["run"], "a");
  call(Service::kRunReport, R"({"run":"a"})");
  call(Service::kRunCompare, R"({"run":"a","with":"b"})");
  call(Service::kRunDelete, R"({"run":"a"})");
  ASSERT_EQ(controls_.managed.size(), 4U);
  EXPECT_EQ(controls_.managed[0].note.name, "");
  EXPECT_EQ(controls_.managed[0].note.note, std::nullopt);
  EXPECT_EQ(controls_.managed[0].note.tags, "wet");
  EXPECT_EQ(controls_.managed[0].note.keep, false);
  EXPECT_EQ(controls_.managed[1].what, RunRequest::What::kReport);
  EXPECT_EQ(controls_.managed[2].with, "b");
  EXPECT_EQ(controls_.managed[3].what, RunRequest::What::kDelete);
  controls_.change_refusal = "is open";
  EXPECT_EQ(call(Service::kRunDelete, R"({"run":"a"})").texts.at(0)["message"], "is open");
}

TEST_F(RequestHandlerTest, ARobotIsIdentifiedFromRunsThatAreNamed) {
  call(Service::kRunIdentify, R"({"runs":"a b","measured":"run,distance_m\n1,2\n"})");
  call(Service::kRunIdentify, R"({"runs":"a"})");
  ASSERT_EQ(controls_.managed.size(), 2U);
  EXPECT_EQ(controls_.managed[0].what, RunRequest::What::kIdentify);
  EXPECT_EQ(controls_.managed[0].drives, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(controls_.managed[0].measured, "run,distance_m\n1,2\n");
  std::string many;
  for (int i = 0; i <= 100; ++i) many += "a ";
  for (const std::string& bad :
       {std::string("{}"), std::string(R"({"runs":""})"), std::string(R"({"runs":"a ../b"})"),
        std::string(R"({"runs":1})"), std::string(R"({"runs":"a","measured":1})"),
        R"({"runs":")" + many + R"("})"})
    EXPECT_THAT(std::string(call(Service::kRunIdentify, bad.c_str()).texts.at(0)["message"]),
                HasSubstr("runs must be one to 100 names"))
        << bad;
  EXPECT_EQ(controls_.managed.size(), 2U);
}

TEST_F(RequestHandlerTest, ArgumentsOfTheServicesOfRunsAreChecked) {
  const std::string long_name(256, 'a');
  for (const std::string& name :
       {std::string("../a"), std::string(), std::string("."), std::string("a/b"),
        std::string("a\\u0000b"), std::string("a%2Fb"), long_name}) {
    for (const Service service : {Service::kRunNote, Service::kRunDelete, Service::kRunReport})
      EXPECT_THAT(std::string(call(service, R"({"run":")" + name + R"("})").texts.at(0)["message"]),
                  HasSubstr("run must be the name of a run"));
    EXPECT_THAT(std::string(call(Service::kRunCompare, R"({"run":"a","with":")" + name + R"("})")
                                .texts.at(0)["message"]),
                HasSubstr("names of runs"));
  }
  struct Bad {
    Service service;
    const char* request;
    const char* why;
  };
  for (const Bad& bad : {Bad{Service::kRunNote, R"({"run":"a","name":1})", "must be strings"},
                         {Service::kRunNote, R"({"run":"a","keep":"yes"})", "must be strings"},
                         {Service::kRunNote, R"({"run":"a","name":"a\u0000b"})", "name takes"},
                         {Service::kRunNote, R"({"run":"a","tags":"a\nb"})", "tags takes"},
                         {Service::kRunDelete, R"({"run":"a","with":"b"})", "no argument 'with'"},
                         {Service::kRunCompare, R"({"run":"a"})", "names of runs"}})
    EXPECT_THAT(std::string(call(bad.service, bad.request).texts.at(0)["message"]),
                HasSubstr(bad.why))
        << bad.request;
  EXPECT_TRUE(controls_.managed.empty());
}

TEST_F(RequestHandlerTest, RecordingsHaveHarmlessNames) {
  controls_.can_record = true;
  for (const char* name : {"../x", "/x", ".x", "a b", "a/b", "\\u0000", "ü"})
    EXPECT_EQ(call(Service::kRecordStart, std::string(R"({"name":")") + name + "\"}").texts.size(),
              1U)
        << name;
  EXPECT_EQ(call(Service::kRecordStart, R"({"name":1})").texts.size(), 1U);
  EXPECT_EQ(answer_of(call(Service::kRecordStart, R"({"name":"run-1_a.b"})").binaries.at(0))["run"],
            "run-1_a.b");
  EXPECT_EQ(answer_of(call(Service::kRecordStop).binaries.at(0))["run"], "run-1_a.b");
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
  const Json answer = answer_of(take().binaries.at(0));
  EXPECT_EQ(answer["run"], "late");
  EXPECT_EQ(answer["bytes"], 7);
  call(Service::kRecordStop);
  controls_.unanswered("no disk", {});
  handler_.tick(kNow);
  EXPECT_EQ(take().texts.at(0)["op"], "serviceCallFailure");
  // A viewer that has left must not get an answer.
  call(Service::kRecordStop);
  viewer_.reset();
  controls_.unanswered("", {});
  handler_.tick(kNow);
}

}  // namespace
}  // namespace tp100::server
