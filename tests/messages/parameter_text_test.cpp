#include "messages/parameter_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace tp100::messages {
namespace {

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

TEST(ParameterText, TheTypeMustFit) {
  EXPECT_NE(why_not(kGain, true), "");
  EXPECT_NE(why_not(kGain, std::string("16")), "");
  EXPECT_NE(why_not(kSteering, 1.0), "");
  ParameterText whole = kGain;
  whole.type = ParameterText::Type::kInteger;
  EXPECT_EQ(why_not(whole, 3.0), "");
  EXPECT_NE(why_not(whole, 3.5), "");
}

TEST(ParameterText, AChoiceMustBeAmongThem) {
  EXPECT_EQ(why_not(kSteering, std::string("fused")), "");
  EXPECT_THAT(why_not(kSteering, std::string("truth")), HasSubstr("model, fused"));
}

TEST(ParameterText, TheListHasUnitAndLimits) {
  const auto json = nlohmann::json::parse(parameters_message({kGain, kSteering}))["parameters"];
  EXPECT_EQ(json[0]["unit"], "1/m");
  EXPECT_EQ(json[0]["max"], 200.0);
  EXPECT_FALSE(json[1].contains("max"));
  for (const auto& one : json)
    for (const auto& [name, content] : one.items()) EXPECT_FALSE(content.is_null()) << name;
  EXPECT_EQ(json[1]["choices"][1], "fused");
}

}  // namespace
}  // namespace tp100::messages
