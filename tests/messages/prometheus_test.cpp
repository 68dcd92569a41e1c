// Metrics of the daemon in Prometheus' format.

#include "messages/prometheus.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "fixtures.h"

namespace tp100::messages {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

double value_of(const std::string& text, const std::string& sample) {
  for (const std::string& line : lines_of(text))
    if (line.starts_with(sample + " ")) return std::stod(line.substr(sample.size()));
  ADD_FAILURE() << sample << " is not in\n" << text;
  return -1.0;
}

TEST(PrometheusText, FollowsTheExpositionFormat) {
  DaemonMetrics metrics;
  metrics.state.battery_v = 7.9;
  metrics.link.clock.valid = true;
  const std::string text = prometheus_text(metrics, example_subject());
  const std::regex help("# HELP ([a-z_][a-z0-9_]*) .+"),
      type("# TYPE ([a-z_][a-z0-9_]*) (counter|gauge|histogram|summary)"),
      sample(
          R"re(([a-z_][a-z0-9_]*)(\{[a-z]+="([^"\\\n]|\\.)*"(,[a-z]+="([^"\\\n]|\\.)*")*\})? [-+.e0-9]+)re");
  ASSERT_EQ(text.back(), '\n');
  std::set<std::string> families, samples;
  std::string family, kind;
  for (const std::string& line : lines_of(text)) {
    std::smatch found;
    if (std::regex_match(line, found, help)) {
      family = found[1];
      EXPECT_TRUE(families.insert(family).second) << "twice: " << line;
      kind.clear();
    } else if (std::regex_match(line, found, type)) {
      EXPECT_EQ(found[1], family);
      kind = found[2];
      EXPECT_EQ(family.ends_with("_total"), kind == "counter") << line;
    } else {
      ASSERT_TRUE(std::regex_match(line, found, sample)) << line;
      const std::string name = found[1];
      EXPECT_TRUE(name == family || ((kind == "summary" || kind == "histogram") &&
                                     (name == family + "_sum" || name == family + "_count" ||
                                      (kind == "histogram" && name == family + "_bucket"))))
          << line;
      EXPECT_TRUE(samples.insert(line.substr(0, line.rfind(' '))).second) << "twice: " << line;
    }
  }
  EXPECT_GT(families.size(), 40U);
}

TEST(PrometheusText, StatesAndFaultsAreZeroOrOne) {
  DaemonMetrics metrics;
  metrics.state.run = RunState::kRunning;
  metrics.state.session = SessionState::kReady;
  metrics.state.faults = fault_bit(Fault::cross_track);
  metrics.state.battery_v = 7.9;
  const std::string text = prometheus_text(metrics, example_subject());
  EXPECT_EQ(value_of(text, R"(tp100_run_state{state="running"})"), 1.0);
  EXPECT_EQ(value_of(text, R"(tp100_run_state{state="driving"})"), 0.0);
  EXPECT_EQ(value_of(text, R"(tp100_session_state{state="ready"})"), 1.0);
  EXPECT_EQ(value_of(text, R"(tp100_fault{fault="cross_track"})"), 1.0);
  EXPECT_EQ(value_of(text, R"(tp100_fault{fault="battery_low"})"), 0.0);
  EXPECT_THAT(text, Not(HasSubstr("\"unknown\"")));
  EXPECT_EQ(value_of(text, "tp100_battery_volts"), 7.9);
}

TEST(PrometheusText, TheHistogramOfLatenessIsCumulative) {
  DaemonMetrics metrics;
  metrics.loop.lateness_counts.fill(2);
  metrics.loop.lateness.mean_us = 3.0;
  const std::string text = prometheus_text(metrics, example_subject());
  EXPECT_EQ(value_of(text, R"(tp100_loop_lateness_seconds_bucket{le="1e-06"})"), 2.0);
  EXPECT_EQ(value_of(text, R"(tp100_loop_lateness_seconds_bucket{le="0.01"})"), 26.0);
  EXPECT_EQ(value_of(text, R"(tp100_loop_lateness_seconds_bucket{le="+Inf"})"), 28.0);
  EXPECT_EQ(value_of(text, "tp100_loop_lateness_seconds_count"), 28.0);
  EXPECT_NEAR(value_of(text, "tp100_loop_lateness_seconds_sum"), 84e-6, 1e-12);
}

TEST(PrometheusText, WhatIsNotKnownIsLeftOut) {
  EXPECT_THAT(prometheus_text({}, example_subject()),
              testing::AllOf(Not(HasSubstr("battery_volts")), Not(HasSubstr("clock_drift"))));
}

TEST(PrometheusText, ANameFromAFileCannotEndItsLabel) {
  RunContext run_context = example_subject();
  run_context.robot.name = "a\"b\\c\nd";
  EXPECT_THAT(prometheus_text({}, run_context), HasSubstr(R"(robot="a\"b\\c\nd")"));
}

}  // namespace
}  // namespace tp100::messages
