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
  link.confirmed = 120;
  link.counters.lost = 1;
  link.counters.crc_errors = 2;
  link.counters.cobs_errors = 3;
  link.counters.duplicated = 4;
  link.counters.implausible = 5;
  link.age = {10.0, 20.0, 30.0, 40.0};
  link.round_trip = {50.0, 60.0, 70.0, 80.0};
  const std::string text = json(kFindings, "/dev/\xff", link);
  EXPECT_EQ(text.find('\n'), text.size() - 1);
  const auto read = nlohmann::json::parse(text);
  EXPECT_EQ(read["errors"], 1);
  EXPECT_EQ(read["warnings"], 0);
  EXPECT_EQ(read["notes"], 1);
  ASSERT_EQ(read["findings"].size(), 3U);
  EXPECT_EQ(read["findings"][0], nlohmann::json::parse(R"({"severity":"error","name":"holder",
      "seen":"held open by cat","fix":"end that program"})"));
  EXPECT_EQ(read["link"], nlohmann::json::parse(R"({"duration_s":0.0,"samples":200,"lost":1,
      "crc_errors":2,"cobs_errors":3,"duplicated":4,"implausible":5,"commands_confirmed":120,
      "age_us":{"p50":10.0,"p90":20.0,"p99":30.0,"max":40.0},
      "round_trip_us":{"p50":50.0,"p90":60.0,"p99":70.0,"max":80.0},
      "clock_uncertainty_us":0.0,"clock_drift_ppm":0.0})"));
  EXPECT_TRUE(nlohmann::json::parse(json({}, "", std::nullopt))["link"].is_null());
}

}  // namespace
}  // namespace tp100::doctor
