#include "record/mcap_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstring>
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

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

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
  void write() const {
    RecordingFile file(path_);
    McapWriter writer(file, "test", GetParam());
    const auto schema = writer.add_schema({"test.Text", "jsonschema", "{}"});
    const auto even = writer.add_channel(schema, "/even", "json");
    const auto odd = writer.add_channel(schema, "/odd", "json");
    writer.attach({"course.toml", "text/plain", 3, "hello"});
    writer.add_metadata("tp100", {{"seed", "7"}, {"empty", ""}});
    for (std::uint64_t i = 0; i < 100; ++i) {
      writer.message(i % 2 == 0 ? even : odd, i, bytes_of("{\"i\":" + std::to_string(i) + "}"));
      if (i % 10 == 9) writer.end_chunk();
    }
    writer.finish();
    ASSERT_EQ(file.error(), 0);
  }
  McapEnd stream(Listener& listener) const { return McapReader(path_).stream(listener); }

  test::TemporaryFolder folder_;
  std::string path_;
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

TEST_P(McapFile, FindsMessagesByTopicAndTimeThroughTheIndex) {
  write();
  const McapReader reader(path_);
  ASSERT_TRUE(reader.indexed());
  EXPECT_EQ(reader.message_count(), 100u);
  Listener received;
  reader.read({"/odd"}, 38, 43, received);
  EXPECT_THAT(received.messages,
              ElementsAre("/odd 39 {\"i\":39}", "/odd 41 {\"i\":41}", "/odd 43 {\"i\":43}"));
  Listener none;
  reader.read({"/none"}, 0, 1000, none);
  EXPECT_THAT(none.messages, IsEmpty());
  Listener all;
  reader.read({}, 0, 1000, all);
  EXPECT_THAT(all.messages, SizeIs(100));
}

TEST_P(McapFile, CutOffAnywhereItGivesItsWholeChunks) {
  write();
  const std::string whole = test::read_bytes(path_);
  std::size_t last = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    test::write_bytes(path_, whole.substr(0, size));
    if (size < 8) {
      EXPECT_THROW(McapReader{path_}, SetupError);
      continue;
    }
    Listener received;
    const McapEnd end = stream(received);
    ASSERT_FALSE(end.whole);
    ASSERT_THAT(end.problem, HasSubstr("at byte"));
    ASSERT_EQ(received.messages.size() % 10, 0u);
    ASSERT_GE(received.messages.size(), last);
    last = received.messages.size();
    ASSERT_FALSE(McapReader(path_).indexed());
  }
  EXPECT_EQ(last, 100u);
}

TEST_P(McapFile, AWrongBitInAChunkCostsThatChunkAlone) {
  write();
  std::string bytes = test::read_bytes(path_);
  // The test changes a bit in the records of the fourth chunk.
  std::size_t at = 0;
  for (int chunk = 0; chunk < 4; ++chunk) {
    const std::string head("\x06\0\0", 1);
    do {
      at = bytes.find(head, at + 1);
      ASSERT_NE(at, std::string::npos);
      std::uint64_t length = 0;
      std::memcpy(&length, bytes.data() + at + 1, 8);
      if (length > 60 && length < 2000) break;
    } while (true);
  }
  bytes[at + 9 + 45] = static_cast<char>(bytes[at + 9 + 45] ^ 0x10);
  test::write_bytes(path_, bytes);
  Listener received;
  const McapEnd end = stream(received);
  EXPECT_EQ(end.corrupted, 1u) << end.problem;
  EXPECT_FALSE(end.whole);
  EXPECT_THAT(received.messages, SizeIs(90));
  Listener indexed;
  EXPECT_THROW(McapReader(path_).read({}, 0, 1000, indexed), SetupError);
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
    try {
      McapReader(path_).read({}, 0, 1000, received);
    } catch (const SetupError& error) {
      ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
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
  EXPECT_FALSE(McapReader(path).indexed());
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
  const McapReader reader(path);
  ASSERT_TRUE(reader.indexed());
  EXPECT_EQ(reader.message_count(), kChunks);
  Listener some, all;
  reader.read({"/a"}, 3, 5, some);
  EXPECT_THAT(some.messages, ElementsAre("/a 3 {}", "/a 4 {}", "/a 5 {}"));
  reader.read({}, 0, kChunks, all);
  EXPECT_THAT(all.messages, SizeIs(kChunks));
  Listener streamed;
  EXPECT_TRUE(reader.stream(streamed).whole);
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
    return test::refusal([&] { const McapReader reader(path); });
  };
  EXPECT_THAT(error_of(folder.file("none")), HasSubstr("none: cannot be read (No such file"));
  test::write_bytes(folder.file("text"), "hello, this is text");
  EXPECT_THAT(error_of(folder.file("text")), HasSubstr("text: not a recording"));
  EXPECT_THAT(error_of(folder.path().string()), HasSubstr("not a file"));
}

}  // namespace
}  // namespace tp100::record
