#include <gtest/gtest.h>

#include "sim/study/calibrate_command.h"

namespace tp100::sim {
namespace {

Loaded robot(const std::string& name) {
  Options options;
  options.robot = name;
  return load(options);
}

// The short form of `tp100-sim calibrate --runs 50`: a robot that turns about a point ahead of it.
// Intervals of 95 %, on noise that is given.
TEST(Calibration, FindsWhatTheBodyReallyDid) {
  const Calibration calibration = calibrate(robot("front-heavy"), 1, 7);
  EXPECT_TRUE(calibration.accurate());
  std::size_t held = 0;
  for (std::size_t i = 0; i < identify::kParameters; ++i)
    if (calibration.holds(static_cast<identify::Parameter>(i))) ++held;
  EXPECT_GE(held + 1, identify::kParameters);
  EXPECT_TRUE(calibration.found.extended.confused.empty());
}

}  // namespace
}  // namespace tp100::sim
