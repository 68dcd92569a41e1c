// Requests that read, set and save parameters.
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
