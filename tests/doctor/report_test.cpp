#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "doctor/finding.h"
#include "doctor/robot.h"

namespace tp100::doctor {
namespace {

const Findings kFindings = {{Severity::kError, "holder", "held open by cat", "end that program"},
                            {Severity::kNote, "by-id", "no name", "see tp100d ports"},
                            ok("disk", "200 MB/s")};

TEST(Report, OfAnExaminationIsATableWithEachFix) {
  EXPECT_EQ(table(kFindings),
            "error    holder  held open by cat\n"
            "                 fix: end that program\n"
            "note     by-id   no name\n"
            "                 fix: see tp100d ports\n"
            "ok       disk    200 MB/s\n"
            "1 error, 0 warnings, 1 note\n");
}

TEST(Report, OfAnExaminationIsOneJsonObject) {
  LinkTest link;
  link.samples = 200;
  link.counters.crc_errors = 2;
  link.age.p99_us = 1500.0;
  const std::string text = json(kFindings, "/dev/\xff", link);
  EXPECT_EQ(text.find('\n'), text.size() - 1);
  const auto read = nlohmann::json::parse(text);
  EXPECT_EQ(read["errors"], 1);
  EXPECT_EQ(read["warnings"], 0);
  EXPECT_EQ(read["findings"].size(), 3U);
  EXPECT_EQ(read["findings"][0]["severity"], "error");
  EXPECT_EQ(read["findings"][0]["fix"], "end that program");
  EXPECT_EQ(read["link"]["samples"], 200);
  EXPECT_EQ(read["link"]["crc_errors"], 2);
  EXPECT_EQ(read["link"]["age_us"]["p99"], 1500.0);
  EXPECT_TRUE(nlohmann::json::parse(json({}, "", std::nullopt))["link"].is_null());
}

}  // namespace
}  // namespace tp100::doctor
