#include "sim/lab/study_processes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

#include "support/refusal.h"

namespace tp100::sim {
namespace {

using namespace std::chrono_literals;

CourseStudy study_called(const std::string& name) {
  CourseStudy study;
  study.course = name;
  study.uneven = true;
  study.runs = 3;
  study.distance_m = 0.1;
  study.judged.push_back({name,
                          "robot",
                          "recovery",
                          "s",
                          2.0,
                          {std::numeric_limits<double>::infinity(), std::nan(""), 3}});
  study.forms.push_back({"extended", {.max_position_error_m = 0.1, .max_yaw_error_rad = 1e-17}});
  return study;
}

TEST(StudyProcesses, ReturnEveryStudyInTheOrderOfTheJobs) {
  std::vector<StudyProcesses::Job> jobs;
  for (int i = 0; i < 9; ++i)
    jobs.emplace_back([i] {
      std::this_thread::sleep_for((9 - i) * 1ms);
      return std::vector{study_called(std::to_string(i)), study_called("second")};
    });
  jobs.emplace_back([] { return std::vector<CourseStudy>{}; });
  StudyProcesses processes(jobs);
  const std::vector<CourseStudy> studies = processes.results();
  ASSERT_EQ(studies.size(), 18U);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(studies[2 * i].course, std::to_string(i));
  const CourseStudy& one = studies[1];
  EXPECT_EQ(one.course, "second");
  EXPECT_TRUE(one.uneven);
  EXPECT_EQ(one.distance_m, 0.1);
  ASSERT_EQ(one.judged.size(), 1U);
  EXPECT_EQ(one.judged[0].ours.median, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(one.judged[0].ours.p95));
  EXPECT_EQ(one.judged[0].unit, "s");
  ASSERT_EQ(one.forms.size(), 1U);
  EXPECT_EQ(one.forms[0].median.max_yaw_error_rad, 1e-17);
}

TEST(StudyProcesses, AJobThatFailsOrIsKilledIsAnError) {
  using Studies = std::vector<CourseStudy>;
  StudyProcesses fails({[]() -> Studies { throw UserError("no such robot"); },
                        [] { return Studies{study_called("good")}; }});
  EXPECT_EQ(test::refusal([&] { fails.results(); }), "no such robot");
  StudyProcesses defect({[]() -> Studies { throw std::out_of_range("a defect"); }});
  EXPECT_THAT([&] { defect.results(); }, testing::ThrowsMessage<std::runtime_error>("a defect"));
  StudyProcesses killed({[]() -> Studies {
    raise(SIGKILL);
    return {};
  }});
  EXPECT_THROW(killed.results(), std::runtime_error);
}

TEST(StudyProcesses, EndWithTheirOwner) {
  int ends[2] = {};
  ASSERT_EQ(pipe(ends), 0);
  {
    const StudyProcesses processes({[&]() -> std::vector<CourseStudy> {
      close(ends[0]);
      EXPECT_EQ(write(ends[1], "1", 1), 1);
      while (true) pause();
    }});
    char begun = 0;
    ASSERT_EQ(read(ends[0], &begun, 1), 1);
  }
  close(ends[1]);
  // The end of the file comes when no process is left that could write.
  char more = 0;
  EXPECT_EQ(read(ends[0], &more, 1), 0);
  close(ends[0]);
}

}  // namespace
}  // namespace tp100::sim
