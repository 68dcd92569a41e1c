// The seed recordings of the fuzzer must have the present layout: the reader refuses any other
// layout before it reads the content. `scripts/test --accept` rewrites them.

#include <gtest/gtest.h>

#include <cstdlib>

#include "record/recording.h"
#include "recorded_run.h"
#include "support/paths.h"
#include "support/temporary_folder.h"

namespace tp100::app {
namespace {

constexpr std::uint64_t kSteps = 12;
const std::string kSeeds = source_path("tests/fuzz/seeds/recordings/");

std::string recorded(bool compress) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("run.mcap");
  record_run(
      path, [](StepRecord& record) { return record.step <= kSteps; }, {{"seed", "5"}}, 0, compress);
  return test::read_bytes(path);
}

void rewrite() {
  const std::string plain = recorded(false);
  test::write_bytes(kSeeds + "plain.mcap", plain);
  test::write_bytes(kSeeds + "packed.mcap", recorded(true));
  test::write_bytes(kSeeds + "cut.mcap", plain.substr(0, plain.size() * 2 / 3));
}

std::uint64_t steps_of(const record::Recording& recording) {
  std::uint64_t steps = 0;
  recording.visit({.step = [&](const StepRecord&) { ++steps; }, .truth = {}, .message = {}});
  return steps;
}

TEST(FuzzSeeds, AreRecordingsOfThePresentLayout) {
  if (std::getenv("TP100_ACCEPT") != nullptr) rewrite();
  for (const std::string name : {"plain", "packed", "cut"}) {
    SCOPED_TRACE(name + ".mcap; scripts/test --accept writes the seeds anew");
    try {
      const record::Recording recording(kSeeds + name + ".mcap");
      const std::uint64_t steps = steps_of(recording);
      EXPECT_EQ(recording.whole(), name != "cut");
      // The only chunk of the cut recording is lost because its end is missing.
      EXPECT_EQ(steps, name == "cut" ? 0 : kSteps);
    } catch (const UserError& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

}  // namespace
}  // namespace tp100::app
