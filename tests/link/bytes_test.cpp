// The bytes of a port: each that comes is in a frame or counted, and frames leave as they were
// queued.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <vector>

#include "link/frame_reader.h"
#include "link/output_queue.h"
#include "support/sequence.h"
#include "support/wire_host.h"

namespace tp100::link {
namespace {

using test::frame_of;
using Bytes = std::vector<std::uint8_t>;

/// A frame as a bad line may pass it on. `damage` 0: whole; 1: one bit flipped; 2: cut short; 3:
/// far too long; 4: only its delimiter.
Bytes damaged(Bytes frame, int damage, test::Sequence& random) {
  const int size = static_cast<int>(frame.size());
  if (damage == 1) {
    std::uint8_t& byte = frame.at(static_cast<std::size_t>(random.below(size - 1)));
    const int bit = 1 << random.below(8);
    // A byte that became a delimiter would make two frames of one.
    byte ^= static_cast<std::uint8_t>(byte != bit ? bit : bit == 1 ? 2 : 1);
  }
  if (damage == 2) {
    frame.resize(static_cast<std::size_t>(1 + random.below(size - 2)));
    frame.push_back(wire::kDelimiter);
  }
  if (damage == 3) frame.insert(frame.begin(), wire::kMaxFrame + 10, 0x01);
  if (damage == 4) frame = {wire::kDelimiter};
  return frame;
}

TEST(FrameReader, EachFrameIsReadOrCountedOnceAndWhatComesBeforeTheFirstIsForeign) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    test::Sequence random(seed);
    LinkCounters counters{};
    FrameReader reader(counters);
    std::uint64_t good = 0, corrupted = 0, foreign = 0;
    bool begun = false;
    const auto count_bad = [&](std::size_t bytes) {
      (begun ? corrupted : foreign) += begun ? 1 : bytes;
    };
    for (std::uint16_t id = 0; id < 300; ++id) {
      const wire::SyncReply sent{id, 0x01000200U, 9, 0, 1};
      const int damage = random.below(8);
      const Bytes bytes = damaged(frame_of(sent), damage, random);
      bool read = false;
      for (const std::uint8_t byte : bytes) read = reader.push(byte);
      ASSERT_EQ(read, damage == 0 || damage > 4);
      if (read) {
        wire::SyncReply got{};
        ASSERT_TRUE(wire::read_payload(reader.payload(), reader.size(), got));
        EXPECT_EQ(reader.type(), static_cast<std::uint8_t>(wire::Type::kSyncReply));
        EXPECT_EQ(got.id, id);
        EXPECT_EQ(reader.frame_bytes(), bytes.size());
        ++good;
        begun = true;
      } else if (damage != 4 || !begun) {
        count_bad(bytes.size());
      }
      if (random.chance(0.1)) {
        // The port goes in the middle of a frame, or of one that never ends.
        const Bytes cut(random.chance(0.5) ? 5 : 300, 0x55);
        for (const std::uint8_t byte : cut) reader.push(byte);
        reader.reset();
        count_bad(cut.size());
        begun = false;
      }
      ASSERT_EQ(counters.frames_in, good);
      ASSERT_EQ(counters.corrupted(), corrupted);
      ASSERT_EQ(counters.foreign_bytes, foreign);
    }
  }
}

TEST(FrameReader, ABadFrameIsCountedByItsCause) {
  Bytes oversize(wire::kMaxFrame + 5, 0x01);
  oversize.push_back(wire::kDelimiter);
  struct Case {
    std::uint64_t LinkCounters::*cause;
    Bytes bytes;
  };
  const Case cases[] = {{&LinkCounters::oversize, oversize},
                        {&LinkCounters::cobs_errors, {0x09, 'x', 'y', 0x00}},
                        {&LinkCounters::undersize, {0x02, 'x', 0x00}},
                        {&LinkCounters::crc_errors, {0x05, 'x', 'y', 'z', 'u', 0x00}}};
  LinkCounters counters{};
  FrameReader reader(counters);
  for (const std::uint8_t byte : frame_of(wire::Disarm{7})) reader.push(byte);
  for (const Case& each : cases) {
    for (const std::uint8_t byte : each.bytes) reader.push(byte);
    EXPECT_EQ(counters.*each.cause, 1U);
  }
  EXPECT_EQ(counters.corrupted(), 4U);
}

TEST(FrameReader, BytesWithoutAnEndAreForeignAsSoonAsTheyAreTooMany) {
  LinkCounters counters{};
  FrameReader reader(counters);
  for (int i = 0; i < 300; ++i) reader.push(0x55);
  EXPECT_GT(counters.foreign_bytes, 200U);
}

constexpr std::size_t kRoom = 160;

/// What an output queue must do, with a mark at each byte that ends a frame.
class PlainQueue {
 public:
  explicit PlainQueue(LinkCounters& counters) : counters_(counters) {}

  std::size_t push(const Bytes& frame) {
    if (waiting_.size() + frame.size() + 1 > kRoom) {
      ++counters_.unwritten;
      return 0;
    }
    // What a receiver got before may be half a frame.
    if (begins_with_delimiter_) waiting_.push_back({wire::kDelimiter, false});
    begins_with_delimiter_ = false;
    for (const std::uint8_t byte : frame) waiting_.push_back({byte, byte == wire::kDelimiter});
    return frame.size();
  }
  std::size_t pad(std::size_t n) {
    n = std::min(n, kRoom - waiting_.size());
    waiting_.insert(waiting_.end(), n, {wire::kDelimiter, false});
    return n;
  }
  void written(std::size_t n) {
    for (n = std::min(n, waiting_.size()); n > 0; --n) {
      ++counters_.bytes_out;
      counters_.frames_out += waiting_.front().ends_frame;
      between_frames_ = waiting_.front().value == wire::kDelimiter;
      waiting_.pop_front();
    }
  }
  void drop() {
    for (const Byte& byte : waiting_) counters_.unwritten += byte.ends_frame;
    waiting_.clear();
    begins_with_delimiter_ = !between_frames_;
  }
  void reset() {
    waiting_.clear();
    between_frames_ = false;
    begins_with_delimiter_ = true;
  }
  Bytes bytes() const {
    Bytes out;
    for (const Byte& byte : waiting_) out.push_back(byte.value);
    return out;
  }
  bool begins_with_delimiter() const { return begins_with_delimiter_; }

 private:
  struct Byte {
    std::uint8_t value;
    bool ends_frame;
  };
  LinkCounters& counters_;
  std::deque<Byte> waiting_;
  bool between_frames_ = false, begins_with_delimiter_ = true;
};

TEST(OutputQueueTest, FramesLeaveAsTheyWereQueuedHoweverThePortTakesThem) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    test::Sequence random(seed);
    const auto below = [&](std::size_t limit) {
      return static_cast<std::size_t>(random.below(static_cast<int>(limit)));
    };
    LinkCounters is{}, wanted{};
    OutputQueue<kRoom> queue(is);
    PlainQueue plain(wanted);
    for (std::uint16_t id = 0; id < 600; ++id) {
      const std::size_t what = below(24);
      if (what < 8) {
        const wire::SyncRequest request{id};
        ASSERT_EQ(queue.push(request), plain.push(frame_of(request)));
      } else if (what < 10) {
        ASSERT_EQ(queue.push(wire::Command{}), plain.push(frame_of(wire::Command{})));
      } else if (what < 13 && !plain.begins_with_delimiter()) {
        const std::size_t n = below(90);
        ASSERT_EQ(queue.pad(n), plain.pad(n));
      } else if (what < 22) {
        const std::size_t n = what == 21 ? kRoom : below(queue.bytes().size() + 3);
        queue.written(n);
        plain.written(n);
      } else if (what == 22 && !plain.begins_with_delimiter()) {
        queue.drop();
        plain.drop();
      } else if (what == 23 && random.chance(0.3)) {
        queue.reset();
        plain.reset();
      }
      ASSERT_EQ(Bytes(queue.bytes().begin(), queue.bytes().end()), plain.bytes());
      ASSERT_EQ(is.frames_out, wanted.frames_out);
      ASSERT_EQ(is.bytes_out, wanted.bytes_out);
      ASSERT_EQ(is.unwritten, wanted.unwritten);
    }
    EXPECT_GT(is.frames_out, 50U);
    EXPECT_GT(is.unwritten, 10U);
  }
}

TEST(OutputQueueTest, AFrameCutBeforeItsDelimiterCountsOnce) {
  LinkCounters counters{};
  OutputQueue<kRoom> queue(counters);
  const std::size_t frame = queue.push(wire::SyncRequest{1});
  queue.written(frame);  // with the leading delimiter, this is all but the frame's last byte
  EXPECT_EQ(counters.frames_out, 0u);
  queue.pad(3);
  queue.written(queue.bytes().size());
  EXPECT_EQ(counters.frames_out, 1u);
}

}  // namespace
}  // namespace tp100::link
