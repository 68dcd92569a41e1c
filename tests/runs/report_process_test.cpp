#include "runs/report_process.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <string>

#include "../support/temporary_folder.h"

namespace tp100::runs {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

std::string run(ReportProcess& process, const std::string& script,
                std::chrono::milliseconds limit = 60s) {
  return process.run({"/bin/sh", "-c", script}, limit);
}

TEST(ReportProcess, SaysWhyAProgramFailedOrWasKilled) {
  ReportProcess process;
  EXPECT_EQ(run(process, "echo out; echo note >&2"), "") << "of one that is done nothing is said";
  EXPECT_EQ(run(process, "echo first >&2; echo 'the reason' >&2; exit 2"), "the reason");
  EXPECT_THAT(run(process, "exit 2"), HasSubstr("status 2"));
  EXPECT_THAT(run(process, "kill -SEGV $$"), HasSubstr("killed"));
  EXPECT_THAT(process.run({"/none/tp100d"}, 60s), HasSubstr("/none/tp100d: cannot be started"));
  EXPECT_THAT(run(process, "exec sleep 600", 50ms), HasSubstr("not done after"));
  const std::string long_text = run(process, "head -c 100000 /dev/zero | tr '\\0' x >&2; exit 1");
  EXPECT_LT(long_text.size(), 1000U);
}

TEST(ReportProcess, RunsAtTheLowestPriorityWithoutOurFiles) {
  ReportProcess process;
  const test::TemporaryFolder folder;
  const std::string out = folder.file("out");
  const int ours = ::open(folder.file("ours").c_str(), O_CREAT | O_RDWR, 0600);
  // The priority is set when the program has begun.
  EXPECT_EQ(run(process,
                "until chrt -p $$ | grep -q SCHED_IDLE; do sleep 0.01; done; ls -l "
                "/proc/$$/fd > " +
                    out),
            "");
  ::close(ours);
  EXPECT_THAT(test::read_bytes(out), ::testing::Not(HasSubstr("ours")));
}

}  // namespace
}  // namespace tp100::runs
