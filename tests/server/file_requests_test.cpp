// Requests about parameters, and answers that come late.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "request_rig.h"

namespace tp100::server {
namespace {

using ::testing::HasSubstr;

TEST_F(RequestHandlerTest, AnAnswerOfASlowDiskComesLaterAndStopBeforeIt) {
  const Received nothing = call(Service::kRecordStop);
  EXPECT_TRUE(nothing.texts.empty() && nothing.binaries.empty());
  call(Service::kStop);
  unanswered_("", R"({"run":"late"})");
  handler_.tick(kNow);
  EXPECT_EQ(answer_of(take().binaries.at(0))["run"], "late");
  call(Service::kRecordStop);
  unanswered_("no disk", {});
  handler_.tick(kNow);
  EXPECT_EQ(take().texts.at(0)["message"], "no disk");
  // A viewer that has left must not get an answer.
  call(Service::kRecordStop);
  viewer_.reset();
  unanswered_("", {});
  handler_.tick(kNow);
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
  handler_.exchange(next, kNow);
  const Json values = send(R"({"op":"getParameters","parameterNames":[]})").texts.at(0);
  EXPECT_EQ(values["parameters"][0]["value"], 20.0);
  EXPECT_EQ(values["parameters"][1]["value"], 400.0);
}

}  // namespace
}  // namespace tp100::server
