#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "../record/random_record.h"
#include "app/commands.h"
#include "core/error.h"
#include "recorded_run.h"
#include "report/run_result.h"
#include "support/temporary_folder.h"

namespace tp100::app {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

class Report : public testing::Test {
 protected:
  std::string file() const { return folder_.file("run.mcap"); }
  std::string text(const std::string& name) const { return test::read_bytes(folder_.file(name)); }
  Json metrics() const { return Json::parse(text("metrics.json")); }
  /// Makes the report; returns the error message, or an empty string.
  std::string report() const {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    std::string message;
    try {
      EXPECT_EQ(run_report({.runs = {file()}, .out = {}}), 0);
    } catch (const UserError& error) {
      message = error.what();
    }
    testing::internal::GetCapturedStdout();
    testing::internal::GetCapturedStderr();
    return message;
  }
  test::TemporaryFolder folder_;
};

/// The page contains no address except SVG's XML namespace, which no browser fetches.
void expect_offline(std::string page) {
  const std::string svg = "http://www.w3.org/2000/svg";
  // Links within the page, and the one to the replay of the run, load nothing.
  for (const std::string& harmless :
       {svg, std::string("href='#"), std::string("href=\"../../#replay=")})
    for (std::size_t at = 0; (at = page.find(harmless)) != std::string::npos;)
      page.erase(at, harmless.size());
  EXPECT_THAT(page, AllOf(Not(HasSubstr("://")), Not(HasSubstr("src=")), Not(HasSubstr("href=")),
                          Not(HasSubstr("@import")), Not(HasSubstr("url("))));
}

TEST_F(Report, ARunThatNeverBeganHasNoFigures) {
  record_run(file(), [](StepRecord& record) {
    record.snapshot.run_state = RunState::kArming;
    return true;
  });
  ASSERT_EQ(report(), "");
  const Json json = metrics();
  EXPECT_EQ(json["cause"], report::kNeverBegan);
  for (const char* name : {"model", "tracking", "estimated", "differences"})
    EXPECT_TRUE(json.at(name).is_null()) << name;
  EXPECT_THAT(text("report.html"), HasSubstr("The run never began: there is nothing to judge"));
}

TEST_F(Report, ARunThatWasHeldIsInterrupted) {
  record_run(file(), [](StepRecord& record) {
    if (record.step > 350) record.snapshot.run_state = RunState::kIdle;
    return true;
  });
  ASSERT_EQ(report(), "");
  EXPECT_EQ(metrics()["completed"], false);
  EXPECT_EQ(metrics()["cause"], "interrupted");
}

TEST_F(Report, OfALiveRunHasItsFactsAndCallsNothingAnError) {
  record_run(file());
  ASSERT_EQ(report(), "");
  const Json json = metrics();
  EXPECT_FALSE(json["truth"]);
  for (const char* name : {"model", "odometry", "baselines", "tracking"})
    EXPECT_TRUE(json.at(name).is_null());
  EXPECT_TRUE(json["differences"]["model_from_odometry"].contains("max_m"));
  EXPECT_EQ(json["recording"]["steps"], 400);
  EXPECT_EQ(json["seed"], 5);
  const std::string page = text("report.html");
  EXPECT_THAT(page, HasSubstr("The true pose was not measured"));
  EXPECT_THAT(page, HasSubstr("run: idle -&gt; arming"));
  EXPECT_THAT(page, HasSubstr("robot.toml"));
  expect_offline(page);
  for (const char* name : {"path.svg", "yaw.svg", "error.svg", "tracking.svg", "slip.svg"})
    EXPECT_THAT(text(name), testing::StartsWith("<svg")) << name;
  EXPECT_THAT(text("error.svg"), Not(HasSubstr("2 sd"))) << "of what, without the truth?";
  EXPECT_THAT(text("uncertainty.svg"), HasSubstr("model, 2 sd"));
  EXPECT_TRUE(json["timing"].at("world_age_us").is_null()) << "there is no external world";
  // The page begins with what was driven with what.
  const std::string top = page.substr(0, page.find("<h2"));
  EXPECT_THAT(top, HasSubstr("<p class='verdict "));
  for (const char* fact : {"<dt>driven with</dt>", "<dt>set-up</dt>", "<dd>5</dd>", " UTC"})
    EXPECT_THAT(top, HasSubstr(fact));
}

TEST_F(Report, WhatIsMissingIsTold) {
  record_run(file(), [](StepRecord& record) { return record.step < 200 || record.step > 209; });
  ASSERT_EQ(report(), "");
  EXPECT_EQ(metrics()["recording"]["missing_steps"], 10);
  EXPECT_THAT(text("report.html"), HasSubstr("steps 200 to 209 are not in the recording"));
  // The same recording, cut off.
  const std::string whole = test::read_bytes(file());
  test::write_bytes(file(), whole.substr(0, whole.size() * 3 / 4));
  ASSERT_EQ(report(), "");
  EXPECT_FALSE(metrics()["recording"]["whole"]);
  EXPECT_THAT(text("report.html"), HasSubstr("cut off"));
}

// Every second step has a new answer, to the pose of 12 ms ago.
TEST_F(Report, TheAgeOfTheWorldsAnswersIsThatOfTheNewestAtEachStep) {
  record_run(file(), [](StepRecord& record) {
    if (record.step % 2 == 0)
      record.inputs.world.push({.answered_ns = record.now_ns - 12 * kNsPerMs});
    return true;
  });
  ASSERT_EQ(report(), "");
  const Json age_us = metrics()["timing"]["world_age_us"];
  EXPECT_NEAR(age_us["p50"], 12e3, 0.06 * 12e3);
  EXPECT_NEAR(age_us["p99"], 17e3, 0.06 * 17e3);
  EXPECT_NEAR(age_us["max"], 17e3, 1.0);
  EXPECT_THAT(text("report.html"), HasSubstr("age of the world&#39;s newest answer"));
}

TEST_F(Report, WhatARecordingSaysCannotBecomeMarkup) {
  record_run(file(), [](StepRecord&) { return true; },
             {{"seed", "<script>1</script>"}, {"</script><b>", "<img>"}});
  ASSERT_EQ(report(), "");
  EXPECT_THAT(text("report.html"), AllOf(Not(HasSubstr("<img")), Not(HasSubstr("<script>1")),
                                         Not(HasSubstr("</script><b>"))));
}

TEST_F(Report, ResultsThatNoStepGivesDoNoHarm) {
  std::mt19937_64 random(3);
  const double nonsense[] = {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e308, -1e308, 1e17, 5e-324};
  record_run(file(), [&](StepRecord& record) {
    const std::uint64_t step = record.step;
    const HostNs now = record.now_ns;
    if (step % 3 == 0) record = *record::random_record(step);
    record.step = step % 7 == 0 ? random() : step;
    record.now_ns = now;
    Snapshot& snapshot = record.snapshot;
    snapshot.run_state = step > 20 ? RunState::kRunning : RunState::kIdle;
    const auto pick = [&] { return nonsense[random() % std::size(nonsense)]; };
    if (step % 2 == 0) snapshot.cross_track_m = snapshot.slip_left = snapshot.left_mps = pick();
    if (step % 5 == 0) snapshot.estimates[PoseSource::kModel].pose.x_m = pick();
    if (step % 11 == 0) snapshot.world.yaw_rad = pick();
    if (step % 13 == 0) snapshot.progress_m = pick();
    snapshot.has_sample = true;
    snapshot.sample.device_us = static_cast<DeviceUs>(step);
    snapshot.sample.measured_ns = now;
    return true;
  });
  ASSERT_EQ(report(), "");
  EXPECT_GT(metrics()["recording"]["implausible_points"], 10);
  for (const char* name : {"path.svg", "yaw.svg", "error.svg", "tracking.svg", "slip.svg"})
    EXPECT_THAT(text(name), AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf")))) << name;
}

TEST_F(Report, NoChangeOfAFileDoesAnyHarm) {
  record_run(file());
  const std::string whole = test::read_bytes(file());
  std::mt19937_64 random(11);
  for (int i = 0; i < 60; ++i) {
    std::string bytes = whole;
    const std::size_t at = random() % bytes.size();
    if (i % 3 == 0)
      bytes.resize(at);
    else if (i % 3 == 1)
      bytes[at] = static_cast<char>(random());
    else
      bytes.erase(at, 1 + random() % 100);
    test::write_bytes(file(), bytes);
    EXPECT_EQ(report().find('\n'), std::string::npos);
  }
}

TEST_F(Report, AComparisonSaysWhatIsBetterOrWorseThanTheFirstRun) {
  const auto with_cross_track = [&](const std::string& name, double cross_track_m) {
    record_run(folder_.file(name), [&](StepRecord& record) {
      record.snapshot.cross_track_m = cross_track_m;
      return true;
    });
    return folder_.file(name);
  };
  const std::string base = with_cross_track("base.mcap", 0.02);
  const std::string better = with_cross_track("better.mcap", 0.015);
  const std::string worse = with_cross_track("worse.mcap", -0.0312);
  const std::string out = folder_.file("out");
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_compare({.runs = {base, better, worse}, .out = out}), 0);
  testing::internal::GetCapturedStdout();
  const std::string page = test::read_bytes(out + "/compare.html");
  EXPECT_THAT(page, HasSubstr("base: base"));
  EXPECT_THAT(page, HasSubstr("<td>2.00</td><td>1.50</td><td class='better'>-0.50 cm better</td>"
                              "<td>3.12</td><td class='missed'>+1.12 cm worse</td>"));
  EXPECT_THAT(page, HasSubstr("<td>0 same</td>"));
}

TEST_F(Report, ComparesSeveralRunsAndNamesThemApart) {
  record_run(file());
  const std::string out = folder_.file("out");
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_compare({.runs = {file(), file(), file()}, .out = out}), 0);
  testing::internal::GetCapturedStdout();
  const std::string name = folder_.path().filename().string();
  const std::string page = test::read_bytes(out + "/compare.html");
  EXPECT_THAT(page, AllOf(HasSubstr(name + " (2)"), HasSubstr(name + " (3)")));
  expect_offline(page);
  EXPECT_EQ(Json::parse(test::read_bytes(out + "/compare.json"))["runs"].size(), 3u);
  EXPECT_THAT(test::read_bytes(out + "/paths.svg"), HasSubstr(name + " (3)"));
  EXPECT_THROW(run_compare({.runs = {file()}, .out = out}), UserError);
  EXPECT_THROW(run_report({.runs = {file(), file()}, .out = out}), UserError);
}

}  // namespace
}  // namespace tp100::app
