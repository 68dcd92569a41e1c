// The engine's project sim/godot in the laboratory's scripts, with programs that drive in real
// time.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "programs/godot.h"

namespace tp100::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// sim/lab/experiment on one short run.
class Experiment : public Godot {
 protected:
  Finished experiment(const std::string& robot = "end-loaded") const {
    return run({"/usr/bin/env", "TP100_BIN=" + build_path("bin"), source_path("sim/lab/experiment"),
                folder_.file("out"), "--runs", "1", "--courses", short_course(folder_), "--setups",
                "flat", "--boards", "native", "--robot", robot, "--no-film"});
  }
  std::string text(const std::string& name) const {
    return read_bytes(folder_.file("out/" + name));
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

#ifdef TP100_HAS_CAMERA
// The image rate and the delay of the images depend on the machine and are not judged. The drive is
// short because rendering takes all the time of the processors.
TEST_F(Godot, RendersForATp100dThatDrives) {
  const Finished done = run({source_path("sim/lab/overhead"), "--json", "--live", "--bin",
                             build_path("bin"), "--course", short_course(folder_, 0.2)});
  ASSERT_LE(done.status, 1) << done.output;
  const std::size_t begin = done.output.find("{\"course\"");
  ASSERT_NE(begin, std::string::npos) << done.output;
  const auto figures = nlohmann::json::parse(done.output.substr(begin), nullptr, false);
  ASSERT_TRUE(figures.is_object()) << done.output;
  const auto figure = [&](const char* name) { return figures.value(name, std::nan("")); };
  EXPECT_TRUE(figures.value("completed", false)) << figures;
  EXPECT_GE(figure("visible"), 1);
  EXPECT_GE(figure("found_share"), 0.95);
  EXPECT_LT(figure("image_max_m"), 0.004);
  EXPECT_GT(figure("accepted") + figure("late"), 0);
}
#endif

}  // namespace
}  // namespace tp100::test
