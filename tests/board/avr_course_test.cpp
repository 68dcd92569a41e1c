#include <gtest/gtest.h>

#include "sim/robot/lockstep.h"
#include "sim/robot/options.h"

namespace tp100::sim {
namespace {

TEST(AvrCourse, TheImageDrivesAWholeCourse) {
  Options options;
  options.board = "avr";
  const Loaded loaded = load(options);
  const report::RunResult result = run_lockstep({.course = load_course("1-straight"),
                                                 .robot = loaded.robot,
                                                 .configuration = loaded.configuration,
                                                 .setup = loaded.setup,
                                                 .board = loaded.board,
                                                 .seed = 1});
  EXPECT_TRUE(result.completed) << result.cause;
  EXPECT_EQ(result.board, "avr");
}

}  // namespace
}  // namespace tp100::sim
