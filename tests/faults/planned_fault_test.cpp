#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/time.h"
#include "sim/faults/fault.h"
#include "support/refusal.h"

namespace tp100::sim {
namespace {

using ::testing::HasSubstr;

std::string refusal(const std::string& text) {
  return test::refusal([&] { parse_fault(text); });
}

TEST(PlannedFault, EveryOneOfTheListIsReadByItsName) {
  std::set<std::string_view> names;
  for (const InjectableFault& row : kInjectableFaults) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    const PlannedFault fault = parse_fault(row.name);
    EXPECT_EQ(&kInjectableFaults[fault.kind], &row);
    EXPECT_EQ(fault.number, row.standard);
    EXPECT_TRUE(fault.active(0));
    EXPECT_LE(row.least, row.standard);
    EXPECT_GE(row.most, row.standard);
  }
}

TEST(PlannedFault, NumberWordAndTimesAreTaken) {
  const PlannedFault fault = parse_fault("drop:0.25:to-robot@2.5+1");
  EXPECT_EQ(fault.kind, fault_kind("drop"));
  EXPECT_EQ(fault.number, 0.25);
  EXPECT_TRUE(fault.to_robot);
  EXPECT_FALSE(fault.to_host);
  EXPECT_FALSE(fault.active(from_s(2.4)));
  EXPECT_TRUE(fault.active(from_s(2.5)));
  EXPECT_TRUE(fault.active(from_s(3.4)));
  EXPECT_FALSE(fault.active(from_s(3.5)));
  const PlannedFault jump = parse_fault("encoder-jump:left:-40@1");
  EXPECT_EQ(jump.number, -40.0);
  EXPECT_TRUE(jump.left);
  EXPECT_FALSE(jump.right);
}

TEST(PlannedFault, WhatMakesNoSenseIsRefusedInOneLine) {
  for (const auto& [text, says] : {std::pair{"dorp:0.1", "did you mean 'drop'?"},
                                   {"drop:2", "out of range"},
                                   {"drop:nan", "says nothing"},
                                   {"drop:left", "says nothing"},
                                   {"cut:1", "says nothing"},
                                   {"drop:0.1@x", "no time"},
                                   {"drop@-1", "no time"},
                                   {"drop@1+", "no time"},
                                   {"reboot@1+2", "does not last"},
                                   {"", "no such fault"}})
    EXPECT_THAT(refusal(text), HasSubstr(says)) << text;
  EXPECT_EQ(refusal("\n" + std::string(5000, 'x')).find('\n'), std::string::npos);
}

}  // namespace
}  // namespace tp100::sim
