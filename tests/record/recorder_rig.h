#pragma once
// Fixture of the recorder's tests: a folder, input records, and the numbers of recorded steps.

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "../messages/fixtures.h"
#include "random_record.h"
#include "record/recorder.h"
#include "record/recording.h"
#include "record/recording_file.h"
#include "support/temporary_folder.h"

namespace tp100::record {

class RecorderTest : public testing::Test {
 protected:
  RecordingSettings settings(const std::string& name = "run.mcap") const {
    return {.path = folder_.file(name), .clock = {0, 0}};
  }
  static RunFacts facts() {
    RunFacts facts;
    facts.run_context = messages::example_subject();
    facts.run_context.version = "9.8.7";
    facts.facts = {{"course", "example"}, {"seed", "7"}};
    facts.files = {
        {.name = "robot.toml", .media_type = "application/toml", .log_ns = 0, .data = "x = 1\n"}};
    return facts;
  }
  static void feed(Recorder& recorder, std::uint64_t from, std::uint64_t to) {
    for (std::uint64_t i = from; i <= to; ++i) recorder.take(*random_record(i));
  }
  /// Asks for a recording that looks back. Returns its number.
  std::uint64_t look_back(Recorder& recorder, const std::string& name,
                          const Recorder::Ended& ended) const {
    return recorder.ask_look_back(
        [=, this] { return std::make_unique<RecordingWriter>(settings(name), facts()); }, ended);
  }
  /// Numbers of the steps in a file of the folder, and of those before it.
  std::vector<std::uint64_t> steps_in(const std::string& name = "run.mcap") const {
    std::vector<std::uint64_t> steps;
    Recording(folder_.file(name)).visit({.step = [&](const StepRecord& r) {
      steps.push_back(r.step);
    }});
    return steps;
  }
  std::vector<std::uint64_t> steps_before(const std::string& name = "run.mcap") const {
    std::vector<std::uint64_t> steps;
    Recording(folder_.file(name)).visit({.before = [&](const StepRecord& r) {
      steps.push_back(r.step);
    }});
    return steps;
  }
  static std::vector<std::uint64_t> numbers(std::uint64_t first, std::uint64_t last) {
    std::vector<std::uint64_t> all(last + 1 - first);
    std::iota(all.begin(), all.end(), first);
    return all;
  }
  test::TemporaryFolder folder_;
};

}  // namespace tp100::record
