// scripts/experiment on one short run.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "godot.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class Experiment : public Godot {
 protected:
  Finished experiment(const std::string& robot = "end-loaded") const {
    return run({"/usr/bin/env", "TP100_BIN=" + build_path("bin"), source_path("scripts/experiment"),
                folder_.file("out"), "--runs", "1", "--courses", short_course(folder_), "--setups",
                "flat", "--boards", "native", "--robot", robot, "--no-film"});
  }
  std::string text(const std::string& name) const {
    std::ifstream file(folder_.file("out/" + name));
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

// The age of the answers, and thus the status, depends on the machine.
TEST_F(Experiment, JudgesARunByTheTruthAndDoesNotDriveItAgain) {
  const Finished driven = experiment();
  ASSERT_LE(driven.status, 1) << driven.output;
  EXPECT_THAT(driven.output, HasSubstr("[1/1] short, flat, native, seed 1: completed in"));
  const auto results = nlohmann::json::parse(text("results.json"), nullptr, false);
  ASSERT_TRUE(results.is_object());
  ASSERT_EQ(results.at("runs").size(), 1u);
  const nlohmann::json& once = results.at("runs").at(0);
  ASSERT_TRUE(once.value("completed", false)) << once;
  EXPECT_LE(once.value("largest_cm", 1e9), 2.0);
  EXPECT_GE(once.value("largest_cm", 0.0), once.value("end_cm", 1e9));
  EXPECT_GT(once.at("answer_age_ms").value("p50", 0.0), 0.0);
  EXPECT_EQ(results.at("virtual").at("short").at("flat").at("completed"), 1);
  const std::string page = text("index.html");
  EXPECT_THAT(page, HasSubstr("1 of 1 runs were completed"));
  EXPECT_THAT(page, HasSubstr("<polyline"));
  EXPECT_THAT(page, HasSubstr("report.html'>completed</a>"));

  const Finished again = experiment();
  EXPECT_EQ(again.status, driven.status) << again.output;
  EXPECT_THAT(again.output, Not(HasSubstr("[1/")));
  EXPECT_THAT(again.output, HasSubstr("1 of 1 runs were completed"));

  const Finished another = experiment("uniform");
  EXPECT_EQ(another.status, 2);
  EXPECT_THAT(another.output, HasSubstr("give another FOLDER"));
}

}  // namespace
}  // namespace tp100::test
