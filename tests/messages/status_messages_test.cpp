// What the channels say once or twice a second: state, faults, STOP, link and loop. Parameters, of
// which a viewer asks for values: only what fits is taken.

#include "messages/status_messages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "fixtures.h"
#include "messages/parameter_text.h"

namespace tp100::messages {
namespace {

using Json = nlohmann::json;

TEST(StateMessage, FaultsComeWithCauseAndFix) {
  StateFigures state;
  state.faults = fault_bit(Fault::cross_track) | fault_bit(Fault::battery_low);
  state.robot_faults = fault_bit(Fault::battery_low);
  const Json faults = Json::parse(state_message(0, {}, state, example_subject()))["faults"];
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0]["name"], "battery_low");
  EXPECT_EQ(faults[0]["from"], "robot");
  EXPECT_EQ(faults[1]["from"], "daemon");
  for (const Json& fault : faults) {
    EXPECT_NE(fault["cause"], "");
    EXPECT_NE(fault["fix"], "");
  }
}

TEST(StateMessage, TheTimeOfAStopIsOnlyThereWhenItIsKnown) {
  StateFigures state;
  const auto stop = [&] {
    return Json::parse(state_message(0, example_clock(), state, example_subject()))["stop"];
  };
  EXPECT_EQ(stop()["status"], "none");
  EXPECT_FALSE(stop().contains("requested_t_s"));
  state.stop = {.count = 1,
                .latched = true,
                .by = "viewer 3",
                .requested_ns = 5 * kNsPerS,
                .status = StopFigures::Status::kNotAcknowledged,
                .acknowledged_ms = 14.0};
  EXPECT_EQ(stop()["status"], "not_acknowledged");
  EXPECT_EQ(stop()["requested_t_s"], 3.0);
  EXPECT_FALSE(stop().contains("acknowledged_ms"));
  state.stop.status = StopFigures::Status::kAcknowledged;
  EXPECT_EQ(stop()["acknowledged_ms"], 14.0);
}

TEST(LinkMessage, ALinkIsPoorAboveOnePercent) {
  LinkFigures link;
  EXPECT_STREQ(link_quality(link), "lost");
  link.session = SessionState::kReady;
  link.samples_hz = 200.0;
  link.lost_hz = 2.0;
  EXPECT_STREQ(link_quality(link), "good");
  link.bad_hz = 1.0;
  EXPECT_STREQ(link_quality(link), "poor");
}

TEST(LinkMessage, SaysWhatKindOfRobotItIsOnceABoardWasHeard) {
  LinkFigures link;
  EXPECT_FALSE(Json::parse(link_message(0.5, link)).contains("kind"));
  link.port.firmware = "0.1.0";
  for (const auto& [kind, name] : {std::pair{RobotKind::kPhysical, "physical"},
                                   {RobotKind::kEmulated, "emulated"},
                                   {RobotKind::kSimulated, "simulated"}}) {
    link.port.kind = kind;
    EXPECT_EQ(Json::parse(link_message(0.5, link))["kind"], name);
  }
}

TEST(LoopMessage, HasEveryTimeOfACycle) {
  LoopFigures loop;
  loop.sample_wait.p99_us = 2.5;
  loop.privileges = {{"SCHED_FIFO 80", true}};
  const Json json = Json::parse(loop_message(1.0, loop, example_subject()));
  EXPECT_EQ(json["sample_wait_us"]["p99"], 2.5);
  int times = 0;
  loop.each_time([&](const char* name, const Durations&) {
    ++times;
    EXPECT_TRUE(json[name].contains("p999")) << name;
  });
  EXPECT_EQ(times, 7);
  EXPECT_EQ(json["histogram"]["lateness"].size(), json["histogram"]["edges_us"].size() + 1);
  EXPECT_EQ(json["privileges"]["SCHED_FIFO 80"], true);
}

TEST(Durations, AreInMicrosecondsAndNonsenseIsLeftOut) {
  Histogram histogram;
  for (const double us : {-1.0, std::nan(""), HUGE_VAL}) add_us(histogram, us);
  EXPECT_EQ(durations_of(histogram).count, 0U);
  EXPECT_EQ(durations_of(histogram).p99_us, 0.0);
  for (int us = 1; us <= 10000; ++us) add_us(histogram, us);
  const Durations result = durations_of(histogram);
  EXPECT_EQ(result.count, 10000U);
  EXPECT_DOUBLE_EQ(result.mean_us, 5000.5);
  EXPECT_DOUBLE_EQ(result.max_us, 10000.0);
}

TEST(LoopMessage, EveryDurationIsInItsBin) {
  Histogram histogram;
  for (std::int64_t us = 1; us <= 20'000; ++us) histogram.add(us * 1000);
  const LatenessCounts counts = lateness_counts_of(histogram);
  std::uint64_t below = 0;
  for (std::size_t i = 0; i < kLatenessEdgesUs.size(); ++i) {
    below += counts[i];
    // A bucket is up to a sixteenth of its value wide.
    EXPECT_LE(below, static_cast<std::uint64_t>(kLatenessEdgesUs[i])) << i;
    EXPECT_GE(static_cast<double>(below), kLatenessEdgesUs[i] * 15.0 / 16.0 - 1.0) << i;
  }
  EXPECT_EQ(below + counts.back(), 20'000U);
}

using ::testing::HasSubstr;

const ParameterText kGain{{.name = "control.gain",
                           .type = ParameterText::Type::kNumber,
                           .value = 16.0,
                           .standard = 16.0,
                           .unit = "1/m",
                           .range = {0.0, 200.0}}};
const ParameterText kSteering{{.name = "estimation.steering",
                               .type = ParameterText::Type::kChoice,
                               .value = std::string("model"),
                               .standard = std::string("model"),
                               .choices = {"model", "fused"}}};

TEST(ParameterText, NumbersMustBeFiniteAndInRange) {
  for (const double good : {0.0, 16.5, 200.0}) EXPECT_EQ(why_not(kGain, good), "");
  for (const double bad : {-0.001, 200.001, std::nan(""), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()})
    EXPECT_NE(why_not(kGain, bad), "") << bad;
  EXPECT_THAT(why_not(kGain, 201.0), HasSubstr("0 to 200 1/m"));
}

TEST(ParameterText, TheTypeMustFitAndAChoiceMustBeAmongThem) {
  EXPECT_NE(why_not(kGain, true), "");
  EXPECT_NE(why_not(kGain, std::string("16")), "");
  EXPECT_NE(why_not(kSteering, 1.0), "");
  EXPECT_EQ(why_not(kSteering, std::string("fused")), "");
  EXPECT_THAT(why_not(kSteering, std::string("truth")), HasSubstr("model, fused"));
  ParameterText whole = kGain;
  whole.type = ParameterText::Type::kInteger;
  EXPECT_EQ(why_not(whole, 3.0), "");
  EXPECT_NE(why_not(whole, 3.5), "");
}

TEST(ParameterText, TheListHasUnitAndLimits) {
  const auto json = Json::parse(parameters_message({kGain, kSteering}))["parameters"];
  EXPECT_EQ(json[0]["unit"], "1/m");
  EXPECT_EQ(json[0]["max"], 200.0);
  EXPECT_FALSE(json[1].contains("max"));
  for (const auto& one : json)
    for (const auto& [name, content] : one.items()) EXPECT_FALSE(content.is_null()) << name;
  EXPECT_EQ(json[1]["choices"][1], "fused");
}

}  // namespace
}  // namespace tp100::messages
