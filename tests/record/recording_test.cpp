#include "record/recording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "record/recording_file.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace tp100::record {
namespace {

using testing::HasSubstr;

class RecordingTest : public testing::Test {
 protected:
  std::string path() const { return folder_.file("run.mcap"); }
  test::TemporaryFolder folder_;
};

/// Reads the whole recording in every way. Every error must be one line.
std::string read_all(const std::string& path) {
  return test::refusal([&] {
    const Recording recording(path);
    recording.visit({.step = [](const StepRecord&) {},
                     .truth = [](HostNs, const Pose&) {},
                     .message = [](const std::string&, std::uint64_t, std::string_view) {}});
  });
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

}  // namespace
}  // namespace tp100::record
