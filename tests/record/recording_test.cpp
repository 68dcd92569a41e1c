#include "record/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "../messages/fixtures.h"
#include "core/error.h"
#include "random_record.h"
#include "record/recorder.h"
#include "support/temporary_folder.h"

namespace tp100::record {
namespace {

using testing::HasSubstr;

class RecordingTest : public testing::Test {
 protected:
  void write(std::uint64_t steps, bool compress = true) const {
    RunFacts facts;
    facts.run_context = messages::example_subject();
    facts.facts = {{"course", "example"}};
    Recorder recorder({.blocking = true});
    recorder.begin({.path = path(), .compress = compress, .clock = {0, 0}}, facts);
    for (std::uint64_t i = 1; i <= steps; ++i) {
      recorder.take_truth(static_cast<HostNs>(i), {.x_m = 1.0});
      recorder.take(*random_record(i));
    }
  }
  std::string path() const { return folder_.file("run.mcap"); }
  test::TemporaryFolder folder_;
};

/// Reads the whole recording in every way. Every error must be one line.
std::string read_all(const std::string& path) {
  try {
    const Recording recording(path);
    recording.visit({.step = [](const StepRecord&) {},
                     .truth = [](HostNs, const Pose&) {},
                     .message = [](const std::string&, std::uint64_t, std::string_view) {}});
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

TEST_F(RecordingTest, AnMcapFileOfSomebodyElseIsNoRecording) {
  {
    RecordingFile file(path());
    McapWriter(file, "other", McapCompression::kNone).finish();
  }
  EXPECT_THAT(read_all(path()), HasSubstr("no recording of tp100d"));
}

TEST_F(RecordingTest, StepsOfAnotherLayoutAreRefusedWithTheVersion) {
  {
    RecordingFile file(path());
    McapWriter writer(file, "tp100 0.0.9", McapCompression::kNone);
    const auto channel =
        writer.add_channel(writer.add_schema({"tp100.Step", "tp100", "{}"}), "/step", "tp100");
    writer.add_metadata("tp100", {{"version", "0.0.9"}});
    writer.message(channel, 1, {});
    writer.finish();
  }
  EXPECT_THAT(read_all(path()), HasSubstr("recorded by version 0.0.9"));
}

TEST_F(RecordingTest, ATruthThatMakesNoSenseIsRefused) {
  const std::string good =
      R"({"host_ns":5,"x_m":1,"y_m":0,"z_m":0,"roll_rad":0,"pitch_rad":0,"yaw_rad":0)";
  for (const std::string& text :
       {std::string("{}"), std::string("[1]"), std::string("{"), std::string(5000, '['),
        R"({"host_ns":9223372036854775807,)" + good.substr(13) + "}",
        R"({"host_ns":1.5,)" + good.substr(13) + "}", good + R"(,"x_m":1e300})"}) {
    {
      RecordingFile file(path());
      McapWriter writer(file, "tp100", McapCompression::kNone);
      const auto channel = writer.add_channel(
          writer.add_schema({"tp100.Truth", "jsonschema", "{}"}), "/truth", "json");
      writer.add_metadata("tp100", {{"version", "1"}});
      writer.message(channel, 1, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
      writer.finish();
    }
    EXPECT_THAT(read_all(path()), HasSubstr("truth 0 is invalid")) << text.substr(0, 80);
  }
}

// With the address sanitizer, this test proves that a malicious file does no harm.
TEST_F(RecordingTest, NoChangeOfAFileDoesAnyHarm) {
  for (const bool compress : {false, true}) {
    write(60, compress);
    const std::string whole = test::read_bytes(path());
    ASSERT_EQ(read_all(path()), "");
    std::mt19937_64 random(7);
    const auto any = [&](std::size_t below) { return static_cast<std::size_t>(random() % below); };
    for (int i = 0; i < 600; ++i) {
      std::string bytes = whole;
      for (std::size_t changes = 1 + any(4); changes > 0; --changes) {
        const std::size_t at = any(bytes.size());
        switch (any(4)) {
          case 0:
            bytes[at] = static_cast<char>(random());
            break;
          case 1:
            bytes.resize(at + 1);
            break;
          case 2:
            bytes.erase(at, 1 + any(40));
            break;
          default:
            for (std::size_t k = at; k < std::min(at + 8, bytes.size()); ++k)
              bytes[k] = static_cast<char>(any(2) == 0 ? 0xff : 0);
        }
        if (bytes.empty()) bytes = "x";
      }
      test::write_bytes(path(), bytes);
      const std::string message = read_all(path());
      ASSERT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

}  // namespace
}  // namespace tp100::record
