// The C library without FMA, as on an older processor: recordings made with it are replayed here.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/processor.h"
#include "process.h"
#include "support/paths.h"

namespace tp100::sim {
namespace {

using testing::HasSubstr;

TEST(Processors, ARecordingWithoutFmaIsReplayedButForRounding) {
  if (!arithmetic().starts_with("x86_64") || !arithmetic().ends_with("with FMA"))
    GTEST_SKIP() << arithmetic()
                 << ": this processor has no other choice of the C library's functions";
  const test::TemporaryFolder folder;
  const auto recorded = test::run({"/usr/bin/env", "GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2",
                                   build_path("bin/tp100-sim"), "course", "1-curve", "--record",
                                   folder.file("runs")});
  ASSERT_EQ(recorded.status, 0) << recorded.output;
  const auto replayed = test::run({"tp100d", "replay", folder.file("runs/1-curve-end-loaded-1"),
                                   "--out", folder.file("poses.csv")});
  EXPECT_EQ(replayed.status, 0) << replayed.output;
  EXPECT_THAT(replayed.output, HasSubstr("the largest difference is "));
  EXPECT_THAT(replayed.output, HasSubstr("without FMA, replayed on " + arithmetic()));
}

}  // namespace
}  // namespace tp100::sim
