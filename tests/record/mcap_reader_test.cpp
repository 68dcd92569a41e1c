// Recordings as MCAP files: what was written is read, a damaged or hostile file costs neither
// memory nor more than its damaged chunks, and a file of another program is no recording.

#include "record/mcap_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <random>

#include "record/mcap_writer.h"
#include "record/recording.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace tp100::record {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Collects all records as text.
class Listener : public McapHandler {
 public:
  bool message(const McapMessage& message) override {
    messages.push_back(message.channel->topic + " " + std::to_string(message.log_ns) + " " +
                       std::string(message.text()));
    return true;
  }
  bool attachment(const std::string& name, const std::string&, std::uint64_t,
                  std::string_view data) override {
    attachments.push_back(name + "=" + std::string(data));
    return true;
  }
  bool metadata(const std::string& name,
                const std::map<std::string, std::string>& entries) override {
    for (const auto& [key, value] : entries) facts.push_back(name + "." + key + "=" + value);
    return true;
  }
  std::vector<std::string> messages, attachments, facts;
};

class McapFile : public testing::TestWithParam<McapCompression> {
 protected:
  McapFile() : path_(folder_.file("file.mcap")) {}

  /// Writes ten chunks of ten messages that alternate between two topics; message i is logged at
  /// time i.
  void write() {
    RecordingFile file(path_);
    McapWriter writer(file, "test", GetParam());
    const auto schema = writer.add_schema({"test.Text", "jsonschema", "{}"});
    const auto even = writer.add_channel(schema, "/even", "json");
    const auto odd = writer.add_channel(schema, "/odd", "json");
    writer.attach({"course.toml", "text/plain", 3, "hello"});
    writer.add_metadata("tp100", {{"seed", "7"}, {"empty", ""}});
    for (std::uint64_t i = 0; i < 100; ++i) {
      writer.message(i % 2 == 0 ? even : odd, i, bytes_of("{\"i\":" + std::to_string(i) + "}"));
      if (i % 10 != 9) continue;
      writer.end_chunk();
      chunk_ends_.push_back(file.size());
    }
    writer.finish();
    ASSERT_EQ(file.error(), 0);
  }
  McapEnd stream(Listener& listener) const { return McapReader(path_).stream(listener); }

  test::TemporaryFolder folder_;
  std::string path_;
  std::vector<std::size_t> chunk_ends_;
};

TEST_P(McapFile, StreamsEverythingThatWasWritten) {
  write();
  Listener received;
  const McapEnd end = stream(received);
  EXPECT_TRUE(end.whole) << end.problem;
  EXPECT_EQ(end.corrupted, 0u);
  ASSERT_THAT(received.messages, SizeIs(100));
  EXPECT_EQ(received.messages[41], "/odd 41 {\"i\":41}");
  EXPECT_THAT(received.attachments, ElementsAre("course.toml=hello"));
  EXPECT_THAT(received.facts, ElementsAre("tp100.empty=", "tp100.seed=7"));
}

TEST_P(McapFile, CutOffAnywhereItGivesItsWholeChunks) {
  write();
  std::size_t last = 100;
  for (std::size_t size = std::filesystem::file_size(path_) - 1; size >= 8; --size) {
    std::filesystem::resize_file(path_, size);
    Listener received;
    const McapEnd end = stream(received);
    ASSERT_FALSE(end.whole);
    ASSERT_THAT(end.problem, HasSubstr("at byte"));
    ASSERT_LE(received.messages.size(), last);
    const std::ptrdiff_t chunks = std::count_if(chunk_ends_.begin(), chunk_ends_.end(),
                                                [&](std::size_t at) { return at <= size; });
    ASSERT_GE(received.messages.size(), 10u * static_cast<std::size_t>(chunks));
    last = received.messages.size();
    ASSERT_FALSE(McapReader(path_).indexed());
  }
  EXPECT_EQ(last, 0u);
  std::filesystem::resize_file(path_, 7);
  EXPECT_THROW(McapReader{path_}, UserError);
}

TEST_P(McapFile, ACheckOfTheIndexesNoticesAnyWrongByte) {
  write();
  McapHandler nobody;
  const std::string whole = test::read_bytes(path_);
  ASSERT_EQ(McapReader(path_).stream(nobody, McapCheck::kIndexes).problem, "");
  for (std::size_t at = 8; at < whole.size(); at += 1 + at % 7) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x15);
    test::write_bytes(path_, bytes);
    ASSERT_FALSE(McapReader(path_).stream(nobody, McapCheck::kIndexes).whole) << "byte " << at;
  }
}

TEST_P(McapFile, AnIndexThatPointsElsewhereIsFoundWithoutASumOfTheData) {
  write();
  McapHandler nobody;
  std::string bytes = test::read_bytes(path_);
  const std::string data_end("\x0f\x04\0\0\0\0\0\0\0", 9);
  bytes.replace(bytes.rfind(data_end) + data_end.size(), 4, 4, '\0');
  test::write_bytes(path_, bytes);
  EXPECT_TRUE(McapReader(path_).stream(nobody, McapCheck::kIndexes).whole);
  // The last byte before the end of the data belongs to the offset of a message.
  bytes[bytes.rfind(data_end) - 8] ^= 1;
  test::write_bytes(path_, bytes);
  const McapEnd end = McapReader(path_).stream(nobody, McapCheck::kIndexes);
  EXPECT_FALSE(end.whole);
  EXPECT_THAT(end.problem, HasSubstr("an index of messages is wrong at byte"));
  EXPECT_EQ(end.corrupted, 0u) << "no message is lost";
  EXPECT_TRUE(McapReader(path_).stream(nobody).whole);
}

TEST_P(McapFile, AWrongBitInAChunkCostsThatChunkAlone) {
  write();
  std::string bytes = test::read_bytes(path_);
  // In the records of the fourth chunk, behind its head.
  const std::size_t at = chunk_ends_.at(2) + 54;
  bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
  test::write_bytes(path_, bytes);
  Listener received;
  const McapEnd end = stream(received);
  EXPECT_EQ(end.corrupted, 1u) << end.problem;
  EXPECT_FALSE(end.whole);
  EXPECT_THAT(received.messages, SizeIs(90));
}

TEST_P(McapFile, AClaimOfHugeSizesIsRefusedBeforeAnythingIsAllocated) {
  write();
  const std::string whole = test::read_bytes(path_);
  std::mt19937_64 random(1);
  // The test overwrites, one after the other, the positions that could be a length.
  for (std::size_t at = 8; at + 8 < whole.size(); at += 3) {
    std::string bytes = whole;
    const std::uint64_t huge =
        random() % 2 == 0 ? ~std::uint64_t{0} >> (random() % 40) : 0x7fffffff;
    std::memcpy(bytes.data() + at, &huge, 8);
    test::write_bytes(path_, bytes);
    Listener received;
    stream(received);
  }
}

INSTANTIATE_TEST_SUITE_P(Packed, McapFile,
                         testing::Values(McapCompression::kNone, McapCompression::kZstd),
                         [](const auto& param) {
                           return param.param == McapCompression::kNone ? "Not" : "Zstd";
                         });

TEST(McapReader, SchemasAndChannelsBeyondAllReasonAreLeftOut) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("file.mcap");
  {
    RecordingFile file(path);
    McapWriter writer(file, "test", McapCompression::kNone);
    const auto schema =
        writer.add_schema({"huge", "text", std::string(std::size_t{30} << 20, 'x')});
    for (const char* topic : {"/a", "/b", "/c"}) {
      const auto channel = writer.add_channel(schema, topic, "json");
      writer.message(channel, 1, bytes_of("{}"));
      writer.end_chunk();
    }
    writer.finish();
  }
  Listener received;
  const McapEnd end = McapReader(path).stream(received);
  EXPECT_THAT(received.messages, ElementsAre("/a 1 {}"));
  EXPECT_THAT(end.problem, HasSubstr("too many schemas and channels"));
}

TEST(McapReader, AnIndexOfThousandsOfChunksIsWholeAndTakesNoMemoryMeanwhile) {
  constexpr std::uint64_t kChunks = 8000;
  const test::TemporaryFolder folder;
  const std::string path = folder.file("file.mcap");
  {
    RecordingFile file(path);
    McapWriter writer(file, "test", McapCompression::kNone);
    const auto channel =
        writer.add_channel(writer.add_schema({"test.Text", "jsonschema", "{}"}), "/a", "json");
    std::size_t settled = 0;
    for (std::uint64_t i = 0; i < kChunks; ++i) {
      writer.message(channel, i, bytes_of("{}"));
      writer.end_chunk();
      if (i == kChunks / 4) settled = ::mallinfo2().uordblks;
    }
    EXPECT_LE(::mallinfo2().uordblks, settled + 1000);
    EXPECT_GT(writer.needed(), kChunks * 80);
    writer.finish();
    ASSERT_EQ(file.error(), 0);
  }
  Listener streamed;
  EXPECT_TRUE(McapReader(path).stream(streamed).whole);
  // Other programs find the chunks by the index in the summary, in their order.
  const std::string file = test::read_bytes(path);
  const std::span<const std::uint8_t> bytes = bytes_of(file);
  ByteReader footer(bytes.last(kMcapFooterSize + kMcapMagic.size()));
  RecordList summary(bytes.subspan(footer.number<std::uint64_t>()));
  std::uint64_t found = 0;
  while (summary.next() && summary.op != McapOp::kFooter) {
    if (summary.op != McapOp::kChunkIndex) continue;
    ByteReader index(summary.content);
    ASSERT_EQ(index.number<std::uint64_t>(), found++) << "the time of its first message";
    index.number<std::uint64_t>();
    RecordList chunk(bytes.subspan(index.number<std::uint64_t>()));
    ASSERT_TRUE(chunk.next() && chunk.op == McapOp::kChunk);
    ASSERT_EQ(ByteReader(chunk.content).number<std::uint64_t>(), found - 1);
  }
  EXPECT_EQ(found, kChunks);
}

TEST(McapReader, AChunkThatUnpacksToAttachmentsIsLeftOut) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("file.mcap");
  Bytes bytes(kMcapMagic.begin(), kMcapMagic.end());
  ByteWriter out(bytes);
  const Bytes inside = {static_cast<std::uint8_t>(McapOp::kAttachment), 0, 0, 0, 0, 0, 0, 0, 0};
  out.number(static_cast<std::uint8_t>(McapOp::kChunk));
  out.number(std::uint64_t{8 + 8 + 8 + 4 + 4 + 8 + inside.size()});
  out.number(std::uint64_t{1});
  out.number(std::uint64_t{1});
  out.number(std::uint64_t{inside.size()});
  out.number(crc32(inside));
  out.text("");
  out.number(std::uint64_t{inside.size()});
  out.bytes(inside);
  test::write_bytes(path, std::string(bytes.begin(), bytes.end()));
  Listener received;
  EXPECT_THAT(McapReader(path).stream(received).problem, HasSubstr("is not allowed in it"));
  EXPECT_THAT(received.attachments, IsEmpty());
}

TEST(McapReader, WhatIsNoMcapFileIsAnErrorOfOneLine) {
  const test::TemporaryFolder folder;
  const auto error_of = [](const std::string& path) {
    return test::refusal([&] { McapReader{path}; });
  };
  EXPECT_THAT(error_of(folder.file("none")), HasSubstr("none: cannot be read (No such file"));
  test::write_bytes(folder.file("text"), "hello, this is text");
  EXPECT_THAT(error_of(folder.file("text")), HasSubstr("text: not a recording"));
  EXPECT_THAT(error_of(folder.path().string()), HasSubstr("not a file"));
}

class RecordingTest : public testing::Test {
 protected:
  std::string path() const { return folder_.file("run.mcap"); }
  /// A recording of that version with one message.
  void write(const std::string& version, const McapSchema& schema, const char* topic,
             const char* encoding, const std::string& message) const {
    RecordingFile file(path());
    McapWriter writer(file, "tp100", McapCompression::kNone);
    const auto channel = writer.add_channel(writer.add_schema(schema), topic, encoding);
    writer.add_metadata("tp100", {{"version", version}});
    writer.message(channel, 1,
                   {reinterpret_cast<const std::uint8_t*>(message.data()), message.size()});
    writer.finish();
  }
  test::TemporaryFolder folder_;
};

/// Why the whole recording cannot be read in every way.
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
  write("0.0.9", {"tp100.Step", "tp100", "{}"}, "/step", "tp100", "");
  EXPECT_THAT(read_all(path()), HasSubstr("recorded by version 0.0.9"));
}

TEST_F(RecordingTest, ATruthThatMakesNoSenseIsRefused) {
  const std::string good =
      R"({"host_ns":5,"x_m":1,"y_m":0,"z_m":0,"roll_rad":0,"pitch_rad":0,"yaw_rad":0)";
  for (const std::string& text :
       {std::string("{}"), std::string("[1]"), std::string("{"), std::string(5000, '['),
        R"({"host_ns":9223372036854775807,)" + good.substr(13) + "}",
        R"({"host_ns":1.5,)" + good.substr(13) + "}", good + R"(,"x_m":1e300})"}) {
    write("1", {"tp100.Truth", "jsonschema", "{}"}, "/truth", "json", text);
    EXPECT_THAT(read_all(path()), HasSubstr("truth 0 is invalid")) << text.substr(0, 80);
  }
}

}  // namespace
}  // namespace tp100::record
