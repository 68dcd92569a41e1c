// Golden traces of the bytes of a port: what is read, counted, queued and dropped.
#include <gtest/gtest.h>

#include <vector>

#include "link/frame_reader.h"
#include "link/output_queue.h"
#include "numbers.h"
#include "support/golden_trace.h"
#include "support/wire_host.h"

namespace tp100::link {
namespace {

TEST(ByteTrace, FramesAmongWhatIsNone) {
  test::GoldenTrace trace("link/frames.csv", {"read", "type", "size", "bytes", "sum", "good",
                                              "foreign", "crc", "cobs", "oversize", "undersize"});
  LinkCounters counters{};
  FrameReader reader(counters);
  Numbers numbers(12345);
  for (int i = 0; i < 700; ++i) {
    std::vector<std::uint8_t> bytes =
        numbers.below(2) == 0
            ? test::frame_of(wire::SyncReply{static_cast<std::uint16_t>(i), 0x01000200U, 9, 0, 1})
            : test::frame_of(wire::Disarm{static_cast<std::uint32_t>(i) << 8U});
    const std::size_t what = numbers.below(9);
    if (what == 0)
      bytes.at(numbers.below(bytes.size() - 1)) ^=
          static_cast<std::uint8_t>(1U << numbers.below(8));
    if (what == 1) bytes.resize(numbers.below(bytes.size()));
    if (what == 2) bytes.insert(bytes.begin(), wire::kMaxFrame - 8 + numbers.below(16), 0x01);
    if (what == 3) bytes.assign(1 + numbers.below(4), 0);
    if (what == 4) bytes = {static_cast<std::uint8_t>(1 + numbers.below(6)), 7, 7, 0};
    double read = 0.0, sum = 0.0;
    for (const std::uint8_t byte : bytes) {
      if (!reader.push(byte)) continue;
      ++read;
      for (std::size_t k = 0; k < reader.size(); ++k)
        sum += static_cast<double>((k + 1) * reader.payload()[k]);
    }
    if (i % 41 == 40) reader.reset();
    // Long runs of foreign bytes at the beginning of some ports.
    if (i % 82 == 81)
      for (std::size_t k = 0; k < numbers.below(300); ++k) reader.push(0x55);
    trace.row({read, static_cast<double>(reader.type()), static_cast<double>(reader.size()),
               static_cast<double>(reader.frame_bytes()), sum,
               static_cast<double>(counters.frames_in), static_cast<double>(counters.foreign_bytes),
               static_cast<double>(counters.crc_errors), static_cast<double>(counters.cobs_errors),
               static_cast<double>(counters.oversize), static_cast<double>(counters.undersize)});
  }
  EXPECT_EQ(trace.difference(), "");
}

TEST(FrameReader, BytesWithoutAnEndAreForeignAsSoonAsTheyAreTooMany) {
  LinkCounters counters{};
  FrameReader reader(counters);
  for (int i = 0; i < 300; ++i) reader.push(0x55);
  EXPECT_GT(counters.foreign_bytes, 200U);
  EXPECT_EQ(counters.oversize, 0U);
  reader.reset();
  EXPECT_EQ(counters.foreign_bytes, 300U);
  const auto frame = test::frame_of(wire::Disarm{7});
  for (const std::uint8_t byte : frame) reader.push(byte);
  EXPECT_EQ(reader.frame_bytes(), frame.size());
  EXPECT_EQ(counters.foreign_bytes, 300U) << "the next port's first frame is whole";
}

TEST(FrameReader, AnEndlessFrameThatAPortCutsIsOversizeOnly) {
  LinkCounters counters{};
  FrameReader reader(counters);
  for (const std::uint8_t byte : test::frame_of(wire::Disarm{7})) reader.push(byte);
  for (int i = 0; i < 300; ++i) reader.push(0x55);
  reader.reset();
  EXPECT_EQ(counters.oversize, 1U);
  EXPECT_EQ(counters.undersize, 0U);
  EXPECT_EQ(counters.foreign_bytes, 0U);
}

TEST(ByteTrace, FramesThatWaitForThePort) {
  test::GoldenTrace trace("link/output_queue.csv", {"result", "bytes", "first", "sum", "frames_out",
                                                    "bytes_out", "unwritten"});
  LinkCounters counters{};
  OutputQueue<160> queue(counters);
  Numbers numbers(12345);
  for (int i = 0; i < 900; ++i) {
    std::size_t result = 0;
    const std::size_t what = numbers.below(12);
    if (what < 3) result = queue.push(wire::SyncRequest{static_cast<std::uint16_t>(i)});
    if (what == 3) result = queue.push(wire::Stop{static_cast<std::uint32_t>(i)});
    if (what == 4) result = queue.push(wire::Command{});
    if (what == 5) result = queue.pad(numbers.below(90));
    if (what > 5 && what < 9) queue.written(numbers.below(queue.bytes().size() + 3));
    if (what == 9 && numbers.below(3) == 0) queue.written(queue.bytes().size());
    if (what == 10 && numbers.below(6) == 0) queue.drop();
    if (what == 11 && numbers.below(9) == 0) queue.reset();
    double sum = 0.0;
    for (std::size_t k = 0; k < queue.bytes().size(); ++k)
      sum += static_cast<double>((k + 1) * queue.bytes()[k]);
    trace.row({static_cast<double>(result), static_cast<double>(queue.bytes().size()),
               queue.bytes().empty() ? -1.0 : queue.bytes()[0] * 1.0, sum,
               static_cast<double>(counters.frames_out), static_cast<double>(counters.bytes_out),
               static_cast<double>(counters.unwritten)});
  }
  EXPECT_EQ(trace.difference(), "");
}

}  // namespace
}  // namespace tp100::link
