// Standard streams that are closed or cannot be written, and what is said of wrong arguments.

#include "text/standard_streams.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <vector>

namespace tp100::text {
namespace {

// The number of the next opened file after the streams `closed` were closed and claimed.
int next_number(std::initializer_list<int> closed) {
  for (const int fd : closed) ::close(fd);
  claim_standard_streams();
  return ::open("/", O_RDONLY);
}

TEST(StandardStreamsDeathTest, NoFileGetsTheNumberOfAClosedStream) {
  for (const auto closed : {std::initializer_list<int>{0}, {1}, {2}, {0, 1, 2}, {}}) {
    EXPECT_EXIT(std::_Exit(next_number(closed) > 2 ? 0 : 1), testing::ExitedWithCode(0), "");
  }
}

TEST(StandardStreamsDeathTest, AnOutputThatCannotBeWrittenIsAnError) {
  const auto end = [](const char* path, int status, bool fails_earlier = false) {
    if (std::freopen(path, "w", stdout) == nullptr) std::_Exit(99);
    std::printf("result\n");
    if (fails_earlier) std::fflush(stdout);
    std::_Exit(finish_standard_output("prog", status));
  };
  EXPECT_EXIT(end("/dev/full", 0), testing::ExitedWithCode(2),
              "^prog: standard output: cannot be written \\(No space left on device\\)");
  EXPECT_EXIT(end("/dev/full", 1), testing::ExitedWithCode(1), "cannot be written");
  EXPECT_EXIT(end("/dev/full", 0, true), testing::ExitedWithCode(2), "cannot be written");
  EXPECT_EXIT(end("/dev/null", 0), testing::ExitedWithCode(0), "");
}

TEST(UsageError, NamesWhatWasMeantAndTheRightHelp) {
  const std::vector<Subcommand> known = {{"run", {"--course", "--port"}}, {"replay", {"--out"}}};
  const auto error_of = [&](std::vector<std::string> arguments, const char* what) {
    arguments.insert(arguments.begin(), "prog");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    testing::internal::CaptureStderr();
    EXPECT_EQ(report_usage_error("prog", what, static_cast<int>(argv.size()), argv.data(), known),
              2);
    return testing::internal::GetCapturedStderr();
  };
  const auto expect = [&](const std::vector<std::string>& arguments, const char* what,
                          const std::string& error) {
    EXPECT_EQ(error_of(arguments, what), "prog: " + error + "\n");
  };
  const char* unknown = "unknown option '--cours'; did you mean '--course'?; see prog run --help";
  expect({"run", "--cours", "3"}, "what", unknown);
  expect({"run", "--zzz"}, "what", "unknown option '--zzz'; see prog run --help");
  expect({"run", "--", "--cours"}, "what", "what; see prog run --help");
  expect({"rum"}, "what", "unknown subcommand 'rum'; did you mean 'run'?; see prog --help");
  expect({"run", "--port", "x"}, "Could not convert: --port = x",
         "--port x: not a number; see prog run --help");
  expect({"run"}, "--port: Value abc not in range 0.100000 to 3600.000000",
         "--port abc: not a number; give 0.1 to 3600; see prog run --help");
  expect({"run"}, "--port: Value -7 not in range 1 to 100",
         "--port -7: out of range; give 1 to 100; see prog run --help");
  const char* unexpected = "The following argument was not expected: low";
  expect({"run", "--port", "low"}, unexpected,
         "low: unexpected argument; did you mean '--port=low'?; see prog run --help");
  expect({"run", "low"}, unexpected, "low: unexpected argument; see prog run --help");
}

}  // namespace
}  // namespace tp100::text
